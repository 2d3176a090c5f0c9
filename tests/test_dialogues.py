"""Conversations a person could have: every file of tests/dialogues, played and checked."""

from pathlib import Path

import pytest

from daemon.dialogue import Expect, load
from daemon.rehearse import rehearse

FILES = sorted((Path(__file__).parent / "dialogues").glob("*.txt"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_dialogue_goes_as_its_file_says(path: Path) -> None:
    dialogue = load(path)
    failed = [
        f"line {line.line}: {outcome.expectation.text}\n{outcome.diff()}"
        for act in rehearse(dialogue)
        for line, outcome in zip(act.act.expected, act.outcomes, strict=True)
        if not outcome.ok
    ]
    assert not failed, "\n".join(failed)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_expectation_of_a_dialogue_is_checked(path: Path) -> None:
    for step in load(path).steps:
        if isinstance(step, Expect):
            assert step.expectation.checked, f"line {step.line} is only a comment"
