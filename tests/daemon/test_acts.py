"""How a dialogue is cut into acts."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from daemon.acts import acts
from daemon.dialogue import Expect, parse


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("you: a", [(1, None, [])]),
        ("you: a\nrobot: lifts\nrobot: asks", [(1, None, [2, 3])]),
        ("you: a\nyou: b", [(1, None, []), (2, None, [])]),
        ("you: a\nwait: 2 s\nrobot: lifts", [(1, 2.0, [3])]),
        ("you: a\nrobot: lifts\nwait: 2 s\nrobot: asks", [(1, 2.0, [2, 4])]),
        ("you: a\nwait: until idle\nrobot: lifts", [(1, None, [3])]),
        ("audio: a.wav\nwait: 1 s", [(1, 1.0, [])]),
        ("world: clear\nwait: 1 s", [(1, 1.0, [])]),
        ("you: a\nwait: 1 s\nwait: 2 s\nrobot: lifts", [(1, 1.0, []), (3, 2.0, [4])]),
        ("link: down\nwait: 1 s\nrobot: lifts", [(1, 0.0, []), (2, 1.0, [3])]),
        ("restart:\nyou: a", [(1, 0.0, []), (2, None, [])]),
        ("wait: until idle", [(1, None, [])]),
        ("robot: lifts\nyou: a", [(None, 0.0, [1]), (2, None, [])]),
        ("", []),
    ],
)
def test_an_act_is_an_input_line_its_time_and_what_is_expected_of_it(
    text: str, expected: list[tuple[int | None, float | None, list[int]]]
) -> None:
    found = acts(parse(text, folder=Path()).steps)
    assert [
        (act.step.line if act.step else None, act.seconds, [line.line for line in act.expected])
        for act in found
    ] == expected


@given(
    st.lists(
        st.sampled_from(["you: a", "wait: 1 s", "world: clear", "robot: lifts", "restart:"]),
        max_size=12,
    )
)
def test_no_expectation_is_lost_and_no_time_is_counted_twice(lines: list[str]) -> None:
    steps = parse("\n".join(lines)).steps
    found = acts(steps)
    expected = [line for act in found for line in act.expected]
    assert expected == [step for step in steps if isinstance(step, Expect)]
    assert sum(act.seconds or 0.0 for act in found) == lines.count("wait: 1 s")
