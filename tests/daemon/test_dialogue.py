"""Dialogue files: every line form of service.md, and a named complaint for every other line."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from daemon.dialogue import (
    Audio,
    DialogueError,
    Expect,
    Insert,
    LinkSwitch,
    Place,
    Remove,
    Restart,
    Step,
    Thing,
    Wait,
    You,
    load,
    parse,
)
from daemon.expectation import expectation

LINES: dict[str, Step] = {
    "you: drive forward": You(1, "drive forward"),
    "you(Rick): Turn right!": You(1, "Turn right!", "rick"),
    "you(unknown): hello: robot": You(1, "hello: robot", ""),
    "  you( Rick ) :  hi  ": You(1, "hi", "rick"),
    "audio: drive forward.wav": Audio(1, Path("here/drive forward.wav")),
    "audio: sub/a.WAV": Audio(1, Path("here/sub/a.WAV")),
    "wait: 3 s": Wait(1, 3.0),
    "wait: 0.5s": Wait(1, 0.5),
    "wait: until idle": Wait(1, None),
    "world: wall 4 cm ahead": Place(1, Thing("wall"), 0.04, "ahead"),
    "world: low red block at 12.5 cm left": Place(
        1, Thing("block", "red", low=True), 0.125, "left"
    ),
    "world: person Mary 30 cm behind": Place(1, Thing("person", name="mary"), 0.3, "behind"),
    "world: girl mary 30 cm right": Place(1, Thing("girl", name="mary"), 0.3, "right"),
    "world: a cereal box 10 cm ahead": Place(1, Thing("cereal box"), 0.1, "ahead"),
    "world: wall 4 cm ahead, following the robot": Place(
        1, Thing("wall"), 0.04, "ahead", following=True
    ),
    "world: low block between the fingers": Insert(1, Thing("block", low=True)),
    "world: blue ball between the fingers": Insert(1, Thing("ball", "blue")),
    "world: nothing within 40 cm": Remove(1, 0.4),
    "world: clear": Remove(1, None),
    "restart:": Restart(1),
    "link: down": LinkSwitch(1, up=False),
    "link: up": LinkSwitch(1, up=True),
    "robot: lifts": Expect(1, expectation("lifts")),
    "ROBOT: waves": Expect(1, expectation("waves")),
}


@pytest.mark.parametrize("line", LINES)
def test_a_line_is_read_as_its_step(line: str) -> None:
    assert parse(line, folder=Path("here")).steps == (LINES[line],)


WRONG = {
    "drive forward": "you: TEXT",
    "me: drive forward": "you: TEXT",
    "you drive forward": "you: TEXT",
    "you:": "what is said",
    "you(): hi": "you(NAME)",
    "wait(3): 3 s": "you: TEXT",
    "audio: drive.mp3": "FILE.wav",
    "audio:": "FILE.wav",
    "wait:": "wait: N s",
    "wait: 3": "wait: N s",
    "wait: -3 s": "wait: N s",
    "wait: a while": "wait: N s",
    "world: wall": "between the fingers",
    "world: wall 4 inches ahead": "cm ahead",
    "world: wall 4 cm above": "left, right or behind",
    "world: 4 cm ahead": "NOUN",
    "world: low red 4 cm ahead": "NOUN",
    "world: w@ll 4 cm ahead": "NOUN",
    "world: nothing within 40 m": "nothing within N cm",
    "world:": "or clear",
    "restart: now": "restart: alone",
    "link: sideways": "link: down",
    "robot:": "what the robot does",
}


@pytest.mark.parametrize("line", WRONG)
def test_a_wrong_line_is_named_with_what_may_stand_there(line: str) -> None:
    with pytest.raises(DialogueError) as caught:
        parse(f"# a comment\n\n{line}\nyou: hi")
    assert caught.value.line == 3
    assert caught.value.text == line
    assert WRONG[line] in caught.value.expected
    assert f"line 3: {line!r}" in str(caught.value)


def test_blank_lines_comments_and_line_ends_make_no_steps() -> None:
    dialogue = parse("# one\r\n\r\nyou: a\r\n   # two\r\nyou: b")
    assert dialogue.steps == (You(3, "a"), You(5, "b"))
    assert dialogue.lines == {3: "you: a", 5: "you: b"}


@given(st.text())
def test_any_text_is_parsed_or_refused_with_a_line(text: str) -> None:
    lines = len(text.splitlines())
    try:
        reached = [step.line for step in parse(text).steps]
    except DialogueError as error:
        reached = [error.line]
    assert reached == sorted(set(reached))
    assert all(1 <= line <= lines for line in reached)


@given(st.lists(st.sampled_from(sorted(LINES))))
def test_steps_come_in_the_order_of_their_lines(lines: list[str]) -> None:
    steps = parse("\n".join(lines), folder=Path("here")).steps
    assert [type(step) for step in steps] == [type(LINES[line]) for line in lines]
    assert [step.line for step in steps] == list(range(1, len(lines) + 1))


def test_a_file_is_named_in_its_error(tmp_path: Path) -> None:
    path = tmp_path / "wrong.txt"
    path.write_text("you: hi\nnonsense\n")
    with pytest.raises(DialogueError, match=r"wrong\.txt: line 2: 'nonsense'"):
        load(path)


def test_a_file_that_is_not_there_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(DialogueError, match="No such file"):
        load(tmp_path / "none.txt")


def test_bytes_that_are_not_utf8_are_an_error_with_their_line(tmp_path: Path) -> None:
    path = tmp_path / "latin.txt"
    path.write_bytes(b"you: hi\nyou: caf\xe9\n")
    with pytest.raises(DialogueError) as caught:
        load(path)
    assert (caught.value.line, caught.value.expected) == (2, "UTF-8 text")


def test_a_missing_recording_is_found_before_anything_is_played(tmp_path: Path) -> None:
    path = tmp_path / "talk.txt"
    path.write_text("you: hi\naudio: a.wav\n")
    with pytest.raises(DialogueError, match=r"line 2.*there is no .*a\.wav"):
        load(path)
    (tmp_path / "a.wav").write_bytes(b"")
    assert load(path).steps[1] == Audio(2, tmp_path / "a.wav")
