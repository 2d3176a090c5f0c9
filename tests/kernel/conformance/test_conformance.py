"""The directives, situation by situation: what is taught, what happens, and the whole trace that must follow.

Each *.txt here is a table of cases, each as a person and the world would make it:

    == one way fails, the other is tried          the promise
    A: to dance fly                               a lesson, called A in the trace (B, C ...)
    you: dance                                    an utterance; Rick: dance, by a person of that name
    wait: 0.5                                     time passes; without it, it runs until nothing is going on
    feel: range_m=0.04                            what the body reports from now on
    stop:                                         the emergency stop
    --
    DO dance                                      the trace of what follows the lessons, indented by depth
      of A                                        operators that were considered, where there were several
    ...

`@1.0` is the time, s; lines of a second focus begin with its number ("2| "). Lessons are in force before the first
line; what they do themselves is not in the trace.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Final

import pytest

from grammars.knowledge import born
from grammars.parse import parse
from grammars.vocabulary import from_policy
from kernel.action.trace import Record
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Teach
from kernel.memory.reply import Failed, Reply

HERE: Final = Path(__file__).parent
LINE: Final = re.compile(r"(?P<key>[A-Za-z]+):\s*(?P<rest>.*)")


def cases() -> Iterator[Any]:
    for file in sorted(HERE.glob("*.txt")):
        for block in re.split(r"^== ", file.read_text("utf8"), flags=re.MULTILINE)[1:]:
            title, _, body = block.partition("\n")
            given, _, expected = body.partition("--\n")
            yield pytest.param(given, expected, id=f"{file.stem}: {title.strip()}")


@pytest.mark.parametrize(("given", "expected"), list(cases()))
def test_the_trace_is(given: str, expected: str, make_robot: Callable[..., Any]) -> None:
    steps = [match for line in given.splitlines() if (match := LINE.fullmatch(line.strip()))]
    assert len(steps) == len(given.split("\n")) - given.split("\n").count(""), given
    robot, labels = prepared(steps, make_robot)
    for index, step in enumerate(steps):
        if len(step["key"]) > 1:
            following = steps[index + 1]["key"] if index + 1 < len(steps) else ""
            act(robot, step["key"], step["rest"], settle=following not in ("wait", "together"))
    got = list(told(robot, labels))
    wanted = [line for line in expected.rstrip().splitlines() if line.strip()]
    assert got == wanted, "\n" + "\n".join(difflib.ndiff(wanted, got))


def prepared(steps: list[Any], make_robot: Callable[..., Any]) -> tuple[Any, dict[int, str]]:
    """A robot with the lessons in force from the start, and their labels."""
    lessons = [*born()]
    labels: dict[int, str] = {}
    for number, step in enumerate((s for s in steps if len(s["key"]) == 1), start=1):
        parsed = parse(step["rest"], from_policy(tuple(lessons)))
        assert isinstance(parsed.meaning, Teach), (step["rest"], parsed.kind)
        kind, content = parsed.meaning.kind, parsed.meaning.content
        lessons.append(Lesson(number, kind, content, step["rest"], "teacher"))
        labels[number] = step["key"]
    robot = make_robot(lessons)
    robot.tick()
    return robot, labels


def act(robot: Any, key: str, rest: str, settle: bool) -> None:
    match key:
        case "wait":
            robot.pass_time(float(rest))
            return
        case "feel":
            changes = dict(part.split("=") for part in rest.split())
            robot.feel(**{k: None if v == "None" else float(v) for k, v in changes.items()})
        case "stop":
            robot.stop()
        case "together":  # until nothing is going on
            robot.settle()
            return
        case speaker:
            words = from_policy(robot.mind.policy)
            said_by = "" if speaker == "you" else speaker.lower()
            robot.hear(parse(rest, words).meaning, rest, said_by)
    if settle:
        robot.settle(120)
    else:
        robot.tick()


def told(robot: Any, labels: dict[int, str]) -> Iterator[str]:
    """The trace as lines; replies come where the focus they belong to has ended."""
    first: int | None = None
    now = 0.0
    began: float | None = None
    for record in robot.trace:
        line = line_of(record, labels)
        if line is None:
            continue
        if record.focus:
            first = record.focus if first is None else first
        began = record.at_s if began is None else began
        if (time := round(record.at_s - began, 1)) != now:
            yield f"@{time}"
            now = time
        yield line if record.focus in (0, first) else f"{record.focus - first + 1}| {line}"
    for reply in robot.replies:
        yield reply_line(reply)


def line_of(record: Record, labels: dict[int, str]) -> str | None:
    data: Any = record.data
    indent = "  " * data.get("depth", 0)
    match record.what:
        case "directive":
            return f"{indent}{data['tag']} {data['text']}".rstrip()
        case "directive_ended":
            return f"{indent}{data['tag']} {data['text']}".rstrip() + f": {data['verdict']}"
        case "considered" if len(data["options"]) > 1:
            names = sorted(labels.get(n, "born") for n in data["options"])
            return f"{data['tag']} considers {', '.join(names)}"
        case "chosen":
            name = labels.get(data["lesson"])
            return f"{indent}  by {name}" if name else None
        case "verdict":
            return f"ends: {data['verdict']}"
        case "prohibited" | "permitted" | "resource_lost" | "stopped" | "promoted":
            detail = data.get("resource") or labels.get(data.get("lesson", 0), "")
            return f"{record.what} {detail}".rstrip()
    return None


def reply_line(reply: Reply) -> str:
    reason = f" {reply.reason}" if isinstance(reply, Failed) else ""
    return f"reply {type(reply).__name__}{reason}"
