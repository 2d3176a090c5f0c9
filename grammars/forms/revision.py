"""Revisions: corrections of the last command or lesson."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.registry import sentence_form
from kernel.action.chain import Chain, Directive, Play, sequence
from kernel.memory.editing import OTHER_WAY
from kernel.memory.meaning import Revision
from kernel.net.graphlet import Graphlet

EXAMPLES = (
    "no raise the lift instead",
    "when you cha-cha drive backwards first",
    "when you cha-cha say thank you at the end",
    "Actually, drive forward five inches instead of ten.",
    "not the red one the blue one",
    "you should say good evening instead of good day",
    "turn right instead of turning left",
    "make it slower",
    "no, the other way",
    "leave out the turn",
    "change the left turn to a right turn",
)


@sentence_form("revision", "revision", EXAMPLES)
def revision(alist: AList) -> Revision:
    """What to do, instead of what, when doing what."""
    build = Build()
    if alist.has("new_words"):
        return _words(build, alist)
    if (altered := alist.find("altered")) is not None:
        return Revision(_altered(build, altered))
    old, instead = alist.find("old"), alist.find("stepping", "gerunding", "action")
    with build.drawing(pattern=True):
        of = build.graphlet(build.action(old.first("action"))) if old is not None else None
    with build.drawing(pattern=True):
        if instead is None:
            instead = _other_amount(alist)
        replaced = build.graphlet(build.action(instead)) if instead is not None else None
    chain = alist.find("chain")
    if (replacing := alist.find("replacing")) is not None:
        chain = AList("chain", (AList("play", (AList("action", replacing.parts),)),))
    if chain is not None:
        steps = build.chain(chain)
    elif alist.has("stepping"):
        steps = Chain(())
    else:
        things = alist.all("np") or [_one(part) for part in alist.all("qual")]
        if not things:
            raise NoMeaningError(str(alist))
        replaced, steps = _things(build, things)
    return Revision(steps, replaced, of, last=alist.has("at_end"))


def _altered(build: Build, altered: AList) -> Chain:
    """A step of no verb: the last one, with these modifiers in the place of those that it had."""
    with build.drawing(pattern=True):
        act = build.add("act")
        if (num := altered.find("num")) is not None:
            build.add("amt", literal=num.value, amt=act)
        elif altered.has("other_way"):
            build.add("dir", OTHER_WAY, dir=act)
        else:
            build.modifiers(act, altered)
        return sequence(Directive("DO", build.graphlet(act)))


def _one(quality: AList) -> AList:
    """ "Red" is "the red one"."""
    return AList("np", (AList("det", value="the"), quality, AList("one", value="one")))


def _other_amount(alist: AList) -> AList | None:
    """The action with the amount it had before: "drive forward 5 inches instead of 10"."""
    was, chain = alist.find("num", "amt"), alist.find("chain")
    play = chain.all("play")[-1] if was is not None and chain is not None else None
    action = play.find("action") if play is not None else None
    now = action.find("amt") if action is not None else None
    if was is None or action is None or now is None:
        return None
    if was.name == "num":
        was = AList("amt", tuple(was if p.name == "num" else p for p in now.parts))
    return AList(action.name, tuple(was if p is now else p for p in action.parts))


def _words(build: Build, alist: AList) -> Revision:
    """Other words to be said."""
    parts = []
    for slot in ("new_words", "old_words"):
        with build.drawing(pattern=True):
            txt = build.add("txt", literal=alist.first(slot).slot("quote"))
            parts.append(build.graphlet(build.add("act", "say", obj=txt)))
    return Revision(sequence(Directive("DO", parts[0])), parts[1])


def _things(build: Build, things: list[AList]) -> tuple[Graphlet | None, Chain]:
    """Another thing: "not the red one the blue one"; the chain holds its look-up alone."""
    replaced = None
    if len(things) > 1:
        with build.drawing(pattern=True):
            replaced = build.graphlet(build.thing(things[0]))
    with build.drawing(pattern=False):
        build.thing(things[-1])
    if not build.finds:
        raise NoMeaningError("another thing that is the same")
    return replaced, Chain(tuple(Play((Directive("FIND", find),)) for find in build.finds))
