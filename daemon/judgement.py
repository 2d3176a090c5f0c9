"""Whether what happened is what was expected: pure, over the events of a turn and samples of the body's true pose."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from daemon import events as ev
from daemon.expectation import (
    ENDLESS,
    Arcs,
    AtOnce,
    Clause,
    Comment,
    EventForm,
    Expectation,
    Form,
    Happens,
    Holds,
    InOrder,
    Moves,
    Rests,
    Says,
    SaysNot,
    describe,
)
from daemon.motion import Run, Sample, arcs, groups, runs, still

TOUCH_S: Final = 0.2
"""Things that come one after the other may overlap by this much: a sample's spacing, a wheel that runs out."""
BRAKING_S: Final = 0.3
"""After a stop, rest is judged from here on."""

_Span = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Turn:
    """What happened between two input lines: the events, and samples of where the body really was."""

    events: tuple[ev.Event, ...] = ()
    samples: tuple[Sample, ...] = ()
    began_s: float = 0.0
    ended_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Outcome:
    """Whether a line held. missing: the clauses that did not; actual: what happened in that turn."""

    expectation: Expectation
    ok: bool
    missing: tuple[str, ...]
    actual: tuple[str, ...]

    def diff(self) -> str:
        """What was expected and did not happen, then what happened, a line each."""
        wanted = [f"- expected: {text}" for text in self.missing]
        got = [f"+ happened: {text}" for text in self.actual or ("nothing",)]
        return "\n".join(wanted + got)


def judge(expectations: Sequence[Expectation], turn: Turn) -> tuple[Outcome, ...]:
    """Check the lines of one turn.

    Lines are in order: what a line expects must not be over before what the line above it expects has begun.
    """
    view = _View(turn)
    actual = happened(turn)
    outcomes: list[Outcome] = []
    earliest = float("-inf")
    for wanted in expectations:
        missing: list[str] = []
        begins: list[float] = []
        for clause in wanted.clauses:
            if isinstance(clause, Comment):
                continue
            spans = [span for span in view.spans(clause) if span[1] >= earliest]
            if spans:
                begins.append(spans[0][0])
            else:
                missing.append(describe(clause))
        if begins and not missing:
            earliest = max(earliest, min(begins))
        outcomes.append(Outcome(wanted, not missing, tuple(missing), actual))
    return tuple(outcomes)


def happened(turn: Turn) -> tuple[str, ...]:
    """The turn in words, in order of time: speech, refusals, questions, motions, what is held now."""
    notes = [(run.began_s, _describe_run(run)) for run in runs(turn.samples)]
    for event in turn.events:
        match event:
            case ev.SayStarted(text=text):
                notes.append((event.t, f'says "{text}"'))
            case ev.Prohibited(by=by):
                notes.append((event.t, f"refuses ({by})"))
            case ev.Question(text=text):
                notes.append((event.t, f"asks: {text}"))
            case ev.Acknowledged():
                notes.append((event.t, "acknowledges"))
            case ev.NotUnderstood(text=text, reason=reason):
                notes.append((event.t, f'does not understand "{text}": {reason}'))
            case ev.Replied(ok=False, shown=shown):
                notes.append((event.t, f"answers: {shown}"))
            case ev.Stopped():
                notes.append((event.t, "stops"))
            case ev.Error(part=part, text=text):
                notes.append((event.t, f"error in {part}: {text}"))
    first, last = (turn.samples[0].held, turn.samples[-1].held) if turn.samples else ("", "")
    if first != last:
        notes.append((turn.ended_s, f"holds {last or 'nothing'}"))
    return tuple(text for _, text in sorted(notes, key=lambda note: note[0]))


def words_of(text: str) -> tuple[str, ...]:
    """Words without case and punctuation; an apostrophe inside a word stays.

    >>> words_of("I don't take orders, Rick!")
    ('i', "don't", 'take', 'orders', 'rick')
    """
    plain = text.lower().replace("\N{RIGHT SINGLE QUOTATION MARK}", "'")
    return tuple(re.findall(r"[^\W_]+(?:'[^\W_]+)*", plain))


class _View:
    """A turn with its motions and its speech worked out once. Every question is answered by spans of time, earliest
    first; none for no."""

    def __init__(self, turn: Turn) -> None:
        self._turn = turn
        self._whole = (turn.began_s, turn.ended_s)
        self._runs = runs(turn.samples)
        self._speech = tuple(_speech(turn))
        stops = [event.t for event in turn.events if isinstance(event, ev.Stopped)]
        self._rest_from_s = max(stops) + BRAKING_S if stops else float("-inf")

    def spans(self, clause: Clause) -> list[_Span]:
        """When the clause holds."""
        if isinstance(clause, InOrder):
            return self._in_order(clause)
        if isinstance(clause, AtOnce):
            return self._at_once(clause)
        if isinstance(clause, Comment):
            return [self._whole]
        return self._form(clause)

    def _form(self, form: Form, pieces: bool = False) -> list[_Span]:
        match form:
            case Says(texts):
                wanted = {words_of(text) for text in texts}
                return [span for said, span in self._speech if wanted & set(_sentences(said))]
            case SaysNot(text):
                return self._throughout(not any(_contains(said, text) for said, _ in self._speech))
            case Happens(what):
                return [(event.t, event.t) for event in self._turn.events if _is(what, event)]
            case Rests():
                return self._throughout(still(self._turn.samples, self._rest_from_s))
            case Holds(text):
                return self._throughout(_holds(self._turn.samples, text))
            case Arcs(side):
                return [(run.began_s, run.ended_s) for run in arcs(self._runs, side)]
            case Moves(kind, low, high):
                found = groups(self._runs, kind, pieces)
                if not found and low <= 0 and high < ENDLESS:
                    return [self._whole]
                return [(run.began_s, run.ended_s) for run in found if low <= run.amount <= high]

    def _throughout(self, so: bool) -> list[_Span]:
        return [self._whole] if so else []

    def _at_once(self, clause: AtOnce) -> list[_Span]:
        common = self._form(clause.parts[0])
        for part in clause.parts[1:]:
            both = [(max(a[0], b[0]), min(a[1], b[1])) for a in common for b in self._form(part)]
            common = [span for span in both if span[0] < span[1]]
        return sorted(common)

    def _in_order(self, clause: InOrder) -> list[_Span]:
        parts = _merged(clause.parts)
        kinds = Counter(part.kind for part in parts if isinstance(part, Moves))
        began, ended = None, float("-inf")
        for part in parts:
            if isinstance(part, AtOnce):
                spans = self._at_once(part)
            else:
                spans = self._form(part, pieces=isinstance(part, Moves) and kinds[part.kind] > 1)
            if (
                isinstance(part, SaysNot | Rests | Holds) and spans
            ):  # true of the whole turn, or of its end
                continue
            later = [span for span in spans if span[0] >= ended - TOUCH_S]
            if not later:
                return []
            first = min(later, key=lambda span: span[1])
            began = first[0] if began is None else began
            ended = first[1]
        return [self._whole if began is None else (began, ended)]


def _merged(parts: Sequence[Form | AtOnce]) -> list[Form | AtOnce]:
    """Two left turns in a row are one motion to whoever watches the body: their amounts are added."""
    merged: list[Form | AtOnce] = []
    for part in parts:
        last = merged[-1] if merged else None
        if isinstance(part, Moves) and isinstance(last, Moves) and part.kind == last.kind:
            merged[-1] = Moves(part.kind, last.low + part.low, last.high + part.high)
        else:
            merged.append(part)
    return merged


def _speech(turn: Turn) -> Iterator[tuple[str, _Span]]:
    """What was said, and from when to when; what stop cut short was not said. Speech may outlast its turn."""
    open_since: dict[str, float] = {}
    for event in turn.events:
        if isinstance(event, ev.SayStarted):
            open_since[event.text] = event.t
        elif isinstance(event, ev.SayEnded):
            began_s = open_since.pop(event.text, turn.began_s)
            if not event.cut:
                yield event.text, (began_s, event.t)
    for text, began_s in open_since.items():
        yield text, (began_s, turn.ended_s)


def _sentences(said: str) -> Iterator[tuple[str, ...]]:
    """All of it, and each of its sentences."""
    yield words_of(said)
    for sentence in re.split(r"(?<=[.!?])\s+", said):
        yield words_of(sentence)


def _contains(said: str, text: str) -> bool:
    words, wanted = words_of(said), words_of(text)
    starts = range(len(words) - len(wanted) + 1)
    return any(words[start : start + len(wanted)] == wanted for start in starts)


def _is(what: EventForm, event: ev.Event) -> bool:
    if what == "asks":
        return isinstance(event, ev.Question)
    if what == "acknowledges":
        return isinstance(event, ev.Acknowledged | ev.Lesson)
    refusal = isinstance(event, ev.Replied) and event.kind in ("Refused", "Failed")
    return refusal or isinstance(event, ev.Prohibited)


def _holds(samples: Sequence[Sample], text: str) -> bool:
    held = samples[-1].held.split() if samples else []
    return not held if text == "nothing" else bool(held) and set(text.split()) <= set(held)


def _describe_run(run: Run) -> str:
    names = {
        "up": "lifts",
        "down": "lowers",
        "close": "closes the gripper",
        "open": "opens the gripper",
    }
    if run.kind in names:
        return f"{names[run.kind]} by {run.amount:.0f} permille"
    if run.kind in ("left", "right"):
        return f"turns {run.kind} {run.amount:.0f} degrees"
    return f"moves {run.kind} {run.amount:.1f} cm"
