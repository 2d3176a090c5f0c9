"""What was said and what became of it, in the order of time: `sayso log`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Final, Literal

import msgspec

from grammars.render import render
from kernel.memory.change import Change
from kernel.memory.lesson import Lesson

What = Literal["said", "learned", "retracted", "undone", "adapted"]
Spoken = tuple[float, str, str, str, str]  # a row of Store.utterances

MADE_ITSELF: Final = "made by itself"


class Entry(msgspec.Struct, frozen=True, kw_only=True):
    """One line of the log.

    Attributes:
        at_s: wall time, s since 1970.
        what: an utterance, or what a change did.
        who: the speaker or whoever asked for the change; "" if not identified, or if it was the robot's own doing.
        text: the words said; the lesson in English; the words that are undone.
        kind: of the sentence or the lesson; source: where the words came from.
        lesson: its number, 0 where there is none; before, after: the strength that moved.
    """

    at_s: float
    what: What
    who: str = ""
    text: str = ""
    kind: str = ""
    source: str = ""
    lesson: int = 0
    before: float | None = None
    after: float | None = None


def entries(
    utterances: Iterable[Spoken], changes: Sequence[Change], last: int
) -> tuple[Entry, ...]:
    """The last entries of both, oldest first. An utterance goes before what it changed."""
    said = [
        Entry(at_s=at_s, what="said", who=speaker, text=text, kind=kind, source=source)
        for at_s, text, speaker, source, kind in utterances
    ]
    known = {lesson.ident: lesson for change in changes for lesson in change.learned}
    by_number = {change.ident: change for change in changes}
    done = [entry for change in changes[-last:] for entry in _of_change(change, known, by_number)]
    both = sorted([*said, *done], key=lambda entry: entry.at_s)
    return tuple(both[-last:])


def _of_change(
    change: Change, known: dict[int, Lesson], by_number: dict[int, Change]
) -> Iterator[Entry]:
    at_s, by = change.at_s, change.by
    for lesson in change.learned:
        yield _about("learned", at_s, by, lesson.ident, known)
    for number in change.retracted:
        yield _about("retracted", at_s, by, number, known)
    for adapted in change.adapted:
        about = _about("adapted", at_s, by, adapted.lesson, known)
        moved = {"before": adapted.before, "after": adapted.after}
        yield msgspec.structs.replace(about, **moved)
    for number in change.undone:
        other = by_number.get(number)
        yield Entry(at_s=at_s, what="undone", who=by, text=other.words if other else "")


def _about(what: What, at_s: float, who: str, ident: int, known: dict[int, Lesson]) -> Entry:
    lesson = known.get(ident)
    if lesson is None:  # it rests, or was born with
        return Entry(at_s=at_s, what=what, who=who, lesson=ident)
    text = render(lesson.content, "teacher")
    source = MADE_ITSELF if lesson.origins and what == "learned" else ""
    return Entry(
        at_s=at_s, what=what, who=who, text=text, kind=lesson.kind, source=source, lesson=ident
    )
