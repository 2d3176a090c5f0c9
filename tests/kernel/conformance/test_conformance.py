"""The directives, situation by situation: what is taught, what happens, and the whole trace that must follow.

Each *.txt here is a table of cases, each as a person and the world would make it:

    == one way fails, the other is tried          the promise
    A: to dance fly                               a lesson, called A in the trace (B, C ...); or an operator or rule in
                                                  the notation, with ";" for the end of a line
    given: Mary is a girl                         said before; what comes of it is not in the trace
    you: dance                                    an utterance; Rick: dance, by a person of that name
    net: DO[ act-1 -lex- dance ]                  a command in the notation
    wait: 0.5                                     time passes; without it, it runs until nothing is going on
    feel: range_m=0.04                            what the body reports from now on
    miss:                                         from now on the gripper catches nothing
    link: down                                    the link to the body is lost, or up again
    stop:                                         the emergency stop
    --
    DO dance                                      the trace of what follows the lessons, indented by depth
    DO considers A, B                             operators that applied, where there were several
      by A                                        the one followed; ante, post, note: as such
    ...
    DO dance: succeeded
    ends: succeeded                               the focus
    reply Failed no_way                           what the person is told
    moved drive, turn                             motions that reached the body, in order
    said hello, goodbye                           what was spoken

`@1.0` is the time, s; lines of a second focus begin with its number ("2| "). Lessons are in force before the first
line; what they do themselves is not in the trace, nor is a focus in which nothing happens, nor the telling of a failure
in the robot's own words: the reply is. Of operators that apply, the one with the highest weight is always followed
first here, and of equal ones the first taught: chance has tests of its own.
"""

from __future__ import annotations

import difflib
import random
import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import pytest

from grammars.knowledge import born
from grammars.parse import parse
from grammars.vocabulary import from_policy
from kernel.action.call import MoveGrip, MoveLift, Rotate, Travel
from kernel.action.trace import Record
from kernel.memory.lesson import Content, Lesson, LessonKind, Rule
from kernel.memory.meaning import Command, Teach
from kernel.memory.notation import read, read_chain
from kernel.memory.reply import Answer, Failed, Refused, Reply

HERE: Final = Path(__file__).parent
LINE: Final = re.compile(r"(?P<key>[A-Za-z]+):\s*(?P<rest>.*)")
MOTIONS: Final = {Travel: "drive", Rotate: "turn", MoveLift: "lift", MoveGrip: "grip"}
UNTOLD: Final = (["ends: succeeded"], ["  EXCUSE", "  EXCUSE: succeeded", "ends: succeeded"])


class Heaviest(random.Random):
    """Always the first of the heaviest."""

    def choices(self, population: Sequence[Any], weights: Any = None, **_: Any) -> list[Any]:
        return [population[weights.index(max(weights))]]


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
    wanted = [line.rstrip() for line in expected.rstrip().splitlines() if line.strip()]
    assert got == wanted, "\n" + "\n".join(difflib.ndiff(wanted, got))


def prepared(steps: list[Any], make_robot: Callable[..., Any]) -> tuple[Any, dict[int, str]]:
    """A robot with the lessons in force from the start, and their labels."""
    lessons = [*born()]
    labels: dict[int, str] = {}
    for number, step in enumerate((s for s in steps if len(s["key"]) == 1), start=1):
        kind, content = lesson_of(step["rest"], lessons)
        lessons.append(Lesson(number, kind, content, step["rest"], "teacher"))
        labels[number] = step["key"]
    robot = make_robot(lessons)
    robot.mind._commons.chance = Heaviest()
    robot.tick()
    return robot, labels


def lines_of(text: str) -> str:
    """Notation with an item a line."""
    return "\n".join(part.strip() for part in text.split(";"))


def lesson_of(text: str, lessons: Sequence[Lesson]) -> tuple[LessonKind, Content]:
    if text.startswith(("trig:", "if:")):
        content: Any = read(lines_of(text))
        return "rule" if isinstance(content, Rule) else "procedure", content
    parsed = parse(text, from_policy(tuple(lessons)))
    assert isinstance(parsed.meaning, Teach), (text, parsed.kind)
    return parsed.meaning.kind, parsed.meaning.content


def act(robot: Any, key: str, rest: str, settle: bool) -> None:
    match key:
        case "wait":
            robot.pass_time(float(rest))
            return
        case "together":  # until nothing is going on
            robot.settle()
            return
        case "miss":
            robot.body.within_reach = False
            return
        case "link":
            robot.feel(connected=rest == "up")
        case "feel":
            changes = dict(part.split("=") for part in rest.split())
            robot.feel(**{k: None if v == "None" else float(v) for k, v in changes.items()})
        case "stop":
            robot.stop()
        case "net":
            robot.hear(Command(read_chain(lines_of(rest))), rest)
        case speaker:
            words = from_policy(robot.mind.policy)
            said_by = "" if speaker in ("you", "given") else speaker.lower()
            robot.hear(parse(rest, words, robot.mind.expecting).meaning, rest, said_by)
    if settle or key == "given":
        robot.settle(120)
    else:
        robot.tick()
    if key == "given":
        robot.trace.clear()
        robot.replies.clear()
        robot.moves.clear()
        robot.said.clear()


def told(robot: Any, labels: dict[int, str]) -> Iterator[str]:
    """The trace as lines, then the replies, then what the body did."""
    lines: dict[int, list[str]] = {}
    entries: list[tuple[float, int, str]] = []
    for record in robot.trace:
        if (line := line_of(record, labels)) is not None:
            lines.setdefault(record.focus, []).append(line)
            entries.append((record.at_s, record.focus, line))
    shown = [focus for focus in lines if focus and lines[focus] not in UNTOLD]
    now = 0.0
    began = next((record.at_s for record in robot.trace), 0.0)
    for at_s, focus, line in entries:
        if focus and focus not in shown:
            continue
        if (time := round(at_s - began, 1)) != now:
            yield f"@{time}"
            now = time
        yield f"{shown.index(focus) + 1}| {line}" if focus in shown[1:] else line
    for reply in robot.replies:
        yield reply_line(reply, labels)
    if robot.moved:
        yield "moved " + ", ".join(MOTIONS[type(command)] for command in robot.moved)
    if robot.said:
        yield "said " + ", ".join(robot.said)


def line_of(record: Record, labels: dict[int, str]) -> str | None:
    data: Any = record.data
    indent = "  " * data.get("depth", 0)
    match record.what:
        case "directive":
            return f"{indent}{data['tag']} {data['text']}".rstrip()
        case "directive_ended":
            found = f" ({data['found']})" if data.get("found") else ""
            return f"{indent}{data['tag']} {data['text']}".rstrip() + f": {data['verdict']}{found}"
        case "considered" if len(data["options"]) > 1:
            names = sorted(labels.get(n, "born") for n in data["options"])
            return f"{indent}{data['tag']} considers {', '.join(names)}"
        case "chosen":
            name = labels.get(data["lesson"])
            how = data["tag"].lower() if data["tag"] in ("ANTE", "POST", "NOTE") else "by"
            return f"{indent}  {how} {name}" if name else None
        case "verdict":
            return f"ends: {data['verdict']}"
        case "prohibited":
            return f"prohibited: {data['text']}"
        case "permitted" | "stopped":
            return record.what
        case "assumed" | "asked" | "answered" | "halted":
            return f"{record.what} {data['text']}"
        case "resource_lost":
            return f"lost {data['resource']}"
        case "lesson" | "retracted":
            return f"{record.what} {labels.get(data['ident'], '')}".rstrip()
    return None


def reply_line(reply: Reply, labels: dict[int, str]) -> str:
    match reply:
        case Failed(_, reason):
            return f"reply Failed {reason}"
        case Refused(_, by):
            return f"reply Refused {labels.get(by.ident, '')}".rstrip()
        case Answer(_, verdict):
            return f"reply Answer {verdict}"
    return f"reply {type(reply).__name__}"
