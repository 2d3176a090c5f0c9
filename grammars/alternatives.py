"""What is said with "or", as sentences that say one thing each: "never touch the stove or the oven" is two lessons.

The grammar marks where an alternative begins: `or_whole` is one to all of the bracket it stands in, the others to what
`REPLACES` says of the parts before them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Final

from grammars.alist import AList
from grammars.clauses import DENIALS
from grammars.denying import otherwise
from grammars.errors import NoMeaningError
from grammars.sorts import is_nothing
from kernel.memory.lesson import LessonKind, Operator, Rule, graphlets
from kernel.memory.meaning import Teach
from kernel.memory.notation import write
from kernel.net.graphlet import Graphlet

WHOLE: Final = "or_whole"
# What an alternative takes the place of: parts of these names; none: the last part; SUBJECT: all but the first.
SUBJECT: Final = "subject"
REPLACES: Final = {
    "or_head": ("ako", "akos", "sub"),
    "or_act": ("act", "dir"),
    "or_verb": ("does",),
    "or_done": ("done_to", "none_to"),
    "or_last": (),
    "or_rest": (SUBJECT,),
}
ALSO: Final = "and_rest"  # what else the subject does: "if something is close and moves"
OTHERWISE: Final = (
    "otherwise"  # a second lesson, of what is to be done where the condition is not so
)
MARKS: Final = frozenset((WHOLE, ALSO, OTHERWISE, *REPLACES))
# What a lesson is to do or to conclude is one thing; there only what is waited for may be this or that.
ONE: Final = frozenset(("chain", "play", "conclusion", "whether"))
CHOSEN: Final = frozenset(("chain", "play"))
LEARNED: Final = ("procedure", "finding")  # of several ways one is chosen
WATCHED: Final = frozenset(("until", "waiting"))
APART: Final = 1000
MOST: Final = 8  # lessons in one sentence


def is_single(said: AList) -> bool:
    """Nothing in it is this or that, but for what is waited for."""
    if said.name in WATCHED:
        return True
    return said.name not in MARKS and all(map(is_single, said.parts))


def alternatives(said: AList, one: frozenset[str] = ONE) -> list[AList]:
    """The same bracket once for each of its alternatives.

    one: brackets that are one thing. What may be done in this way or that ("to celebrate, turn around or sing") is
    taught twice.

    Raises:
        NoMeaningError: they stand where one thing is wanted, or are too many.
    """
    if is_single(said) and not said.has("several"):
        return [said]
    one -= CHOSEN if said.name in LEARNED else frozenset()
    if said.name in one or (said.name == "chain" and len(said.parts) > 1):
        raise NoMeaningError(str(said))
    found: list[AList] = []
    for body in _bodies(said):
        made: list[tuple[AList, ...]] = [()]
        for part in body:
            made = [(*before, *more) for before in made for more in _of_part(part, one)]
        found += [AList(said.name, parts, said.value) for parts in made]
    if len(found) > MOST:
        raise NoMeaningError(str(said))
    return list(dict.fromkeys(found))


def neither(said: AList) -> AList:
    """ "Anything that is not red or blue" is neither: it is not red, and not blue."""
    parts = []
    for part in said:
        denied = part.name == "rel" and part.has("neg") and not is_single(part)
        parts += alternatives(part) if denied else [neither(part)]
    return AList(said.name, tuple(parts), said.value)


def _of_part(part: AList, one: frozenset[str]) -> list[tuple[AList, ...]]:
    """Each alternative of a part, as the parts that stand in its place. What is denied of both is denied of each: "if
    you are not holding a cup or a mug"."""
    if part.name == "several":  # "never touch the cup and the mug"
        return [(action,) for action in one_each(part)]
    if (also := part.find(ALSO)) is not None:
        first = AList(part.name, tuple(inner for inner in part if inner is not also))
        second = AList(part.name, (_again(part.parts[0]), *also.parts))
        return [(*a, *b) for a in _of_part(first, one) for b in _of_part(second, one)]
    found = alternatives(part, one)
    if part.name == "clause" and _is_denied(part):
        return [tuple(found)]
    return [(other,) for other in found]


def _again(subject: AList) -> AList:
    """The subject once more."""
    if subject.has("pron") or subject.has("name"):
        return subject
    return AList("np", (AList("pron", value="they"),))


def _is_denied(clause: AList) -> bool:
    subject, *rest = clause.parts
    if all(map(is_single, rest)):
        return False
    nobody = is_nothing(subject)
    return nobody or any(clause.has(denial) for denial in DENIALS)


def _bodies(said: AList) -> Iterator[tuple[AList, ...]]:
    """Its parts, for each alternative that stands directly in it."""
    if (contrary := said.find(OTHERWISE)) is not None:
        yield from otherwise(said, contrary, alternatives(said.first("conds")))
        return
    rest = tuple(part for part in said if part.name != WHOLE)
    for body in (rest, *(part.parts for part in said.all(WHOLE))):
        yield from _replaced(body)


def _replaced(body: tuple[AList, ...]) -> Iterator[tuple[AList, ...]]:
    at = next((at for at, part in enumerate(body) if part.name in REPLACES), None)
    if at is None:
        yield body
        return
    before, (mark, *after) = body[:at], body[at:]
    names = REPLACES[mark.name]
    if names == (SUBJECT,):
        kept = before[:1]
    elif names:
        kept = tuple(part for part in before if part.name not in names)
    else:
        kept = before[:-1]
    yield from _replaced((*before, *after))
    yield from _replaced((*kept, *mark.parts, *after))


def one_each(several: AList) -> list[AList]:
    """ "Grab the box and the ball": the same done to each."""
    things = several.all("np") or several.all("dest") or several.all("dir")
    same = [part for part in several if part not in things]
    return [AList("action", (same[0], thing, *same[1:])) for thing in things]


def together(taught: Iterable[Teach]) -> Teach:
    """The lessons of one sentence; those that differ only in when they do not hold are one."""
    kept: dict[str, Operator | Rule] = {}
    kind: LessonKind | None = None
    for number, one in enumerate(taught):
        kind = one.kind
        bare = replace(one.content, unless=())
        known = kept.setdefault(write(bare), one.content)
        if known is not one.content:
            more = tuple(_apart(graphlet, bare, number) for graphlet in one.content.unless)
            kept[write(bare)] = replace(known, unless=(*known.unless, *more))
    if kind is None:
        raise NoMeaningError("nothing")
    first, *others = kept.values()
    return Teach(kind, first, tuple(others))


def _apart(graphlet: Graphlet, bare: Operator | Rule, number: int) -> Graphlet:
    """The exception with names of its own for all that the lesson itself does not mention."""
    shared = {name for known in graphlets(bare) for name in known.mentioned}
    names = {}
    for name in graphlet.mentioned - shared:
        kind, _, at = name.rpartition("-")
        names[name] = f"{kind}-{int(at) + number * APART}"
    return graphlet.renamed(names)
