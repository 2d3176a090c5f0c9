"""A file of lessons, understood as a whole before any of it is taught."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from daemon.control.messages import NAME_LENGTH
from daemon.lessonfile import Line
from daemon.lessons import Row
from grammars.errors import NotUnderstoodError
from grammars.knowledge import born
from grammars.parse import parse
from grammars.replies import say
from grammars.vocabulary import Vocabulary, extended, from_policy
from kernel.managing import whole
from kernel.memory.lesson import Lesson, LessonKind
from kernel.memory.meaning import Fact, Meaning, Teach
from kernel.memory.notation import canonical, write


@dataclass(frozen=True, slots=True)
class Wrong:
    """A line that cannot be taught, and what to do about it."""

    line: Line
    why: str


@dataclass(frozen=True, slots=True)
class Plan:
    """What is to be taught, in the order in which each sentence can be understood.

    Attributes:
        new: to be said, with what they teach; known: lines whose nets are in force already.
        wrong: where there are any, nothing is to be taught.
    """

    new: tuple[tuple[Line, tuple[Lesson, ...]], ...]
    known: tuple[Line, ...]
    wrong: tuple[Wrong, ...]


@dataclass
class _Reading:
    """Words as they become known, line by line."""

    vocabulary: Vocabulary

    def learn(self, lessons: tuple[Lesson, ...]) -> None:
        """Know their words, as the robot will when the line is said (daemon/loop.py)."""
        self.vocabulary = extended(self.vocabulary, lessons)


def plan(lines: Sequence[Line], rows: Iterable[Row]) -> Plan:
    """Read every line with the words the lessons in force and the other lines bring.

    Lines that are not understood yet wait for those that are: the order of a file does not matter.
    """
    in_force = [row.lesson for row in rows if row.counts]
    known = Counter(map(_key, in_force))
    reading = _Reading(from_policy([*born(), *in_force]))
    new: list[tuple[Line, tuple[Lesson, ...]]] = []
    repeated: list[Line] = []
    wrong: list[Wrong] = []
    waiting, before = list(lines), len(lines) + 1
    while waiting and len(waiting) < before:
        before, waiting = len(waiting), _pass(waiting, reading, known, new, repeated, wrong)
    wrong += [Wrong(line, _puzzled(line, reading.vocabulary)) for line in waiting]
    return Plan(tuple(new), tuple(repeated), tuple(sorted(wrong, key=lambda w: w.line.number)))


def _pass(
    lines: list[Line],
    reading: _Reading,
    known: Counter[tuple[str, str]],
    new: list[tuple[Line, tuple[Lesson, ...]]],
    repeated: list[Line],
    wrong: list[Wrong],
) -> list[Line]:
    """Sort the lines that are understood now; the others."""
    waiting = []
    for line in lines:
        try:
            meaning = parse(line.text, reading.vocabulary).meaning
        except NotUnderstoodError:
            waiting.append(line)
            continue
        lessons = lessons_of(meaning, line.text)
        if len(line.speaker or "") > NAME_LENGTH:
            wrong.append(Wrong(line, f"a name has at most {NAME_LENGTH} characters"))
        elif not lessons:
            kind = type(meaning).__name__.lower()
            wrong.append(Wrong(line, f"a {kind} is no lesson: say it to the robot (`sayso say`)"))
        elif all(known[_key(lesson)] > 0 for lesson in lessons):
            known.subtract(map(_key, lessons))
            repeated.append(line)
        else:
            reading.learn(lessons)
            new.append((line, lessons))
    return waiting


def lessons_of(meaning: Meaning, words: str) -> tuple[Lesson, ...]:
    """The lessons a sentence teaches or the fact it tells, not stored; none for all else."""
    match meaning:
        case Teach() as taught:
            return tuple(
                Lesson(0, taught.kind_of(each), canonical(each), words) for each in taught.contents
            )
        case Fact() as fact:
            return (Lesson(0, "fact", whole(fact), words),)
    return ()


def changed(rows: Sequence[Row]) -> Iterator[tuple[Row, str]]:
    """Lessons in force whose words mean something else now, or nothing; and what they mean."""
    lessons = [(row, row.lesson) for row in rows if row.counts and row.words and not row.origins]
    vocabulary = from_policy([*born(), *(lesson for _, lesson in lessons)])
    for row, lesson in lessons:
        now, kind = _now(row.words, vocabulary)
        if _key(lesson) not in map(_key, now):
            yield row, kind


def _now(words: str, vocabulary: Vocabulary) -> tuple[tuple[Lesson, ...], LessonKind | str]:
    """What the words teach, and of which kind; or nothing and why not."""
    try:
        parsed = parse(words, vocabulary)
    except NotUnderstoodError:
        return (), "no longer understood"
    lessons = lessons_of(parsed.meaning, words)
    return lessons, lessons[0].kind if lessons else f"now a {parsed.kind}"


def _key(lesson: Lesson) -> tuple[str, str]:
    return lesson.kind, write(lesson.content)


def _puzzled(line: Line, vocabulary: Vocabulary) -> str:
    try:
        parse(line.text, vocabulary)
    except NotUnderstoodError as error:
        return say(error).shown
    return ""
