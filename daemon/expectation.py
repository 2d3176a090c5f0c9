"""What a dialogue file expects of the robot: the checked forms of a `robot:` line, as values.

Pure: text to Expectation. Whether it came true is decided in daemon/judgement.py. What is none of the forms is a
comment for the reader.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final, Literal

from daemon.motion import MoveKind

EventForm = Literal["asks", "acknowledges", "refuses"]
ENDLESS: Final = float("inf")


@dataclass(frozen=True, slots=True)
class Says:
    """One of these texts is spoken, word for word but for case and punctuation."""

    texts: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SaysNot:
    """These words are not spoken, not even inside a longer sentence."""

    text: str


@dataclass(frozen=True, slots=True)
class Happens:
    """An event of this sort occurs."""

    what: EventForm


@dataclass(frozen=True, slots=True)
class Rests:
    """Nothing moves; where a stop was sent, from a moment after it."""


@dataclass(frozen=True, slots=True)
class Moves:
    """The body, lift or gripper moves so, by an amount in cm, degrees or permille between low and high."""

    kind: MoveKind
    low: float = 0.0
    high: float = ENDLESS


@dataclass(frozen=True, slots=True)
class Arcs:
    """The body turns while it travels."""

    side: Literal["left", "right"]


@dataclass(frozen=True, slots=True)
class Holds:
    """At the end the gripper holds a thing of this description; "nothing" for an empty one."""

    text: str


Form = Says | SaysNot | Happens | Rests | Moves | Arcs | Holds


@dataclass(frozen=True, slots=True)
class Comment:
    """Text for a reader; not checked."""

    text: str


@dataclass(frozen=True, slots=True)
class AtOnce:
    """There is a moment at which all parts go on."""

    parts: tuple[Form, ...]


@dataclass(frozen=True, slots=True)
class InOrder:
    """Each part begins when the one before it is over."""

    parts: tuple[Form | AtOnce, ...]


Clause = Form | InOrder | AtOnce | Comment


@dataclass(frozen=True, slots=True)
class Expectation:
    """One `robot:` line: all its clauses must hold."""

    text: str
    clauses: tuple[Clause, ...]

    @property
    def checked(self) -> bool:
        """Something in it is checked."""
        return not all(isinstance(clause, Comment) for clause in self.clauses)


_QUOTE: Final = re.compile(
    '["\N{LEFT DOUBLE QUOTATION MARK}]([^"\N{RIGHT DOUBLE QUOTATION MARK}]*)["\N{RIGHT DOUBLE QUOTATION MARK}]'
)
_AMOUNT: Final = r"(?:\s+(\d+(?:\.\d+)?)\s*\.\.\s*(\d+(?:\.\d+)?)\s*{unit})?"
_MOVES: Final = re.compile(r"moves (forward|backward)s?" + _AMOUNT.format(unit="cm"))
_TURNS: Final = re.compile(r"turns (left|right)" + _AMOUNT.format(unit="degrees"))
_ARCS: Final = re.compile(r"arcs (left|right)")
_SAYS: Final = re.compile(r"says \0(\d+)\0((?: or \0\d+\0)*)")
_SAYS_NOT: Final = re.compile(r"does not say \0(\d+)\0")
_HOLDS: Final = re.compile(r"holds (?:an? |the )?([\w' -]+)")
_TOGETHER: Final = "at the same time"
_PLAIN: Final[dict[str, Form]] = {
    "asks": Happens("asks"),
    "acknowledges": Happens("acknowledges"),
    "refuses": Happens("refuses"),
    "does not move": Rests(),
    "lifts": Moves("up"),
    "lowers": Moves("down"),
    "closes the gripper": Moves("close"),
    "opens the gripper": Moves("open"),
}


def expectation(text: str) -> Expectation:
    """Read a `robot:` line.

    >>> expectation('says "hi"; waves').clauses
    (Says(texts=('hi',)), Comment(text='waves'))
    """
    quotes: list[str] = []

    def keep(match: re.Match[str]) -> str:
        quotes.append(match[1])
        return f"\0{len(quotes) - 1}\0"

    masked = " ".join(_QUOTE.sub(keep, text.replace("\0", " ")).split())
    pieces = [piece.strip(" .,") for piece in masked.split(";")]
    pieces = [piece for piece in pieces if piece]
    if len(pieces) > 1 and pieces[-1].endswith(_TOGETHER) and " and " not in pieces[-1]:
        pieces = [f" {_TOGETHER} ".join([*pieces[:-1], pieces[-1].removesuffix(_TOGETHER)]).strip()]
    return Expectation(text, tuple(_clause(piece, quotes) for piece in pieces))


def _clause(piece: str, quotes: list[str]) -> Clause:
    parts = [_at_once(part, quotes) for part in re.split(r",? then ", piece)]
    known = tuple(part for part in parts if part is not None)
    if len(known) < len(parts):
        return Comment(re.sub(r"\0(\d+)\0", lambda match: f'"{quotes[int(match[1])]}"', piece))
    return known[0] if len(known) == 1 else InOrder(known)


def _at_once(part: str, quotes: list[str]) -> Form | AtOnce | None:
    pieces = re.split(
        rf"\s*,? {_TOGETHER}(?: as)?\b\s*", f" {part} ".replace(f" , {_TOGETHER}", f" {_TOGETHER}")
    )
    if len(pieces) == 2 and not pieces[1].strip():
        pieces = pieces[0].split(" and ")
        if len(pieces) == 1:
            return None
    forms = [_form(piece.strip(" ,"), quotes) for piece in pieces if piece.strip()]
    known = tuple(form for form in forms if form is not None)
    if len(known) < len(forms) or not known:
        return None
    return known[0] if len(known) == 1 else AtOnce(known)


def _form(text: str, quotes: list[str]) -> Form | None:
    if text in _PLAIN:
        return _PLAIN[text]
    if match := _MOVES.fullmatch(text) or _TURNS.fullmatch(text):
        kind: MoveKind = match[1]  # type: ignore[assignment]  # one of the four in the patterns
        if match[2] is None:
            return Moves(kind)
        low, high = float(match[2]), float(match[3])
        return Moves(kind, low, high) if low <= high else None
    if match := _ARCS.fullmatch(text):
        return Arcs("left" if match[1] == "left" else "right")
    if match := _SAYS.fullmatch(text):
        return Says(tuple(quotes[int(number)] for number in re.findall(r"\d+", text)))
    if match := _SAYS_NOT.fullmatch(text):
        return SaysNot(quotes[int(match[1])])
    if match := _HOLDS.fullmatch(text):
        return Holds(match[1].lower())
    return None


def describe(clause: Clause) -> str:
    """The clause in words, as a file writes it."""
    match clause:
        case Says(texts):
            return "says " + " or ".join(f'"{text}"' for text in texts)
        case SaysNot(text):
            return f'does not say "{text}"'
        case Happens(what):
            return what
        case Rests():
            return "does not move"
        case Arcs(side):
            return f"arcs {side}"
        case Holds(text):
            return f"holds {text}"
        case Moves():
            return _describe_moves(clause)
        case InOrder(parts):
            return ", then ".join(describe(part) for part in parts)
        case AtOnce(parts):
            return f" {_TOGETHER} ".join(describe(part) for part in parts)
        case Comment(text):
            return text


def _describe_moves(form: Moves) -> str:
    for text, plain in _PLAIN.items():
        if isinstance(plain, Moves) and plain.kind == form.kind:
            return text
    verb, unit = ("moves", "cm") if form.kind in ("forward", "backward") else ("turns", "degrees")
    amount = "" if form.high == ENDLESS else f" {form.low:g}..{form.high:g} {unit}"
    return f"{verb} {form.kind}{amount}"
