"""Revisions: corrections of the last command or lesson."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.pacing import HOLDING
from grammars.registry import sentence_form
from grammars.sorts import is_abstract, is_bare, is_said_to_persons
from grammars.steps import reordered, step_at, step_named
from grammars.verdicts import is_praise
from grammars.vocabulary import BORN
from kernel.action.chain import Chain, Directive, Play, sequence
from kernel.memory.editing import OTHER_WAY
from kernel.memory.meaning import Beside, Revision
from kernel.net.graphlet import Graphlet

EXAMPLES = (
    "no raise the lift instead",
    "when you cha-cha drive backwards first",
    "when you cha-cha say thank you at the end",
    "when you cha-cha, say hooray instead of thank you",
    "Actually, drive forward five inches instead of ten.",
    "go to the door instead of the wall",
    "not the red one the blue one",
    "I meant the yellow mug, not the white one.",
    "you should say good evening instead of good day",
    "turn right instead of turning left",
    "you should have turned right",
    "make it slower",
    "when you cha-cha do it slowly",
    "faster",
    "no, the other way",
    "do that again but with the gripper closed",
    "leave out the turn",
    "skip the last step",
    "leave out the second turn",
    "do the first step twice",
    "make the second turn slower",
    "swap the first two steps",
    "swap the turn and the wave",
    "the wave should come before the bow",
    "move the wave to the end",
    "it should be two turns, not one",
    "you were supposed to stop",
    "the first step of the dance should be turn left",
    "add a one second wait between the two steps",
    "change the left turn to a right turn",
)
# What is less of it.
SLOWER: Final = {
    "fast": "slowly",
    "quickly": "slowly",
    "slow": "fast",
    "slowly": "fast",
    "loudly": "quietly",
    "quietly": "loudly",
    "loud": "quietly",
    "quiet": "loudly",
    "hard": "gently",
    "gently": "hard",
}


@sentence_form("revision", "revision", EXAMPLES)
def revision(alist: AList) -> Revision:
    """What to do, instead of what, when doing what."""
    build = Build()
    alist, of = _as_way(alist), None
    if (whole := alist.find("old")) is not None:
        with build.drawing(pattern=True):
            of = build.graphlet(build.action(whole.find("action", "gerunding") or whole))
    if alist.has("new_words"):
        return _words(build, alist, of)
    if (keeping := alist.find("keeping")) is not None:
        return Revision(build.chain(_alone(keeping)))
    if (order := alist.find("reordering")) is not None:
        return reordered(build, order, of)
    if alist.has("same_deed") and not _is_alike(alist):
        raise NoMeaningError("do not worry, be happy")
    altered, beside = alist.find("altered"), alist.find("ahead_of", "behind", "amid")
    if altered is not None:
        if (was := alist.find("was")) is not None and was.find("qual", "owner") is not None:
            raise NoMeaningError("another sort of part")
        if of is not None and (of.head is None or not of.head.lex.isdisjoint(HOLDING)):
            raise NoMeaningError("no deed")
        step = _replaced(build, alist) if alist.has("stepping") else None
        return Revision(_altered(build, altered), step, of, later=alist.has("later"))
    replaced = _replaced(build, alist if beside is None else beside)
    chain = _new_steps(alist)
    if chain is not None:
        steps = build.chain(chain)
    elif alist.has("stepping"):
        steps = Chain(())
    else:
        replaced, steps = _things(build, alist)
    where: Beside = "" if beside is None else "after" if beside.name == "behind" else "before"
    if alist.has("at_start") and of is None:
        replaced, where = step_at(build, "first"), "before"
    adding = alist.has("adding") and replaced is None and of is None
    last, later = alist.has("at_end") or adding, alist.has("later")
    later = later and chain is not None and replaced is None and of is None and not last
    return Revision(steps, replaced, of, last, where, later)


def _is_alike(alist: AList) -> bool:
    """What is to be done has the verb of what is not: "don't turn left, turn right"."""
    new = alist.first("chain").parts[0].find("action")
    return new is not None and new.slot("act") == alist.first("action").slot("act") != ""


def _as_way(alist: AList) -> AList:
    """ "From now on dance slowly" is "when you dance do it slowly"; what the robot is born with has no lesson."""
    chain = alist.find("chain")
    deeds = [] if chain is None else [part for part in chain.walk() if part.name == "action"]
    if len(deeds) != 1 or not alist.has("later") or "MOTION" in BORN.readings(deeds[0].slot("act")):
        return alist
    if [part.name for part in deeds[0]] != ["act", "manner"]:
        return alist
    act, way = deeds[0].parts
    return AList(alist.name, (AList("old", (AList("action", (act,)),)), AList("altered", (way,))))


def _alone(part: AList) -> AList:
    """A chain of that alone."""
    return AList("chain", (AList("play", (part,)),))


def _new_steps(alist: AList) -> AList | None:
    """What is to be done: in so many words, or as what should have been, or by its name: "a turn"."""
    if (chain := (alist.find("replacing") or alist).find("chain")) is not None:
        bare = alist.has("plain_no") and _is_bare(chain)
        if bare or (_is_judged(alist) and not alist.has("later") and is_praise(alist)):
            raise NoMeaningError(str(alist))
        return chain
    if (named := alist.find("did_it", "replacing", "adding")) is not None:
        return _alone(AList("action", (named.find("action") or named).parts))
    return None


def _is_judged(alist: AList) -> bool:
    """It begins with a verdict, "too fast, slow down", which praise of what was done does not."""
    return alist.find("verdict", "praise", "blame") is not None


def _is_bare(chain: AList) -> bool:
    """Nothing but a verb to begin with: "no rest for the wicked", "no thank you"."""
    play = chain.find("play")  # of several chains there is none
    action = None if play is None else play.find("action")
    return action is not None and all(
        part.name in ("act", "place") or part.slot("pron") == "you" for part in action
    )


def _replaced(build: Build, alist: AList) -> Graphlet | None:
    """The description of the step that is meant: as it was, by its name, or by its place."""
    with build.drawing(pattern=True):
        if alist.name == "amid":
            steps = alist.all("stepping")
            return step_named(build, steps[-1]) if steps else step_at(build, "second")
        step = alist.find("stepping", "gerunding", "action") or _as_it_was(alist)
        if step is None:
            return None
        return step_named(build, step)


def _as_it_was(alist: AList) -> AList | None:
    """The new action with a part as it was before: "drive forward 5 inches instead of 10", "go to the door instead of
    the wall"."""
    was, steps = alist.find("was"), _new_steps(alist)
    action = steps.all("play")[-1].find("action") if was is not None and steps is not None else None
    if was is None or action is None:
        return None
    old = was.find(
        "place", "dest", "amt", "num", "cnt", "manner", "dir", "size", "np", "qual", "owner"
    )
    at = -1 if old is None else _place(action, old.name)
    if old is None or at < 0:
        raise NoMeaningError(str(alist))
    new = action.parts[at]
    if old.name == "num":
        old = AList("amt", tuple(old if p.name == "num" else p for p in new.parts))
    elif new.name == "dest" and old.name == "np":
        old = AList("dest", (old,))
    elif new.name == "iobj" and old.name == "np":
        old = AList("iobj", (old,))
    return AList(action.name, (*action.parts[:at], old, *action.parts[at + 1 :]))


def _place(action: AList, name: str) -> int:
    """Where in the action the part of that sort is that was named last; -1 if there is none."""
    sorts = {"np": ("np", "dest", "iobj"), "num": ("amt",)}.get(name, (name,))
    return max((at for at, part in enumerate(action) if part.name in sorts), default=-1)


def _altered(build: Build, altered: AList) -> Chain:
    """A step of no verb: the last one, with these modifiers in the place of those that it had."""
    if any(deg.value == "too" for deg in altered.walk()):  # that is how it was, and no wish
        raise NoMeaningError(str(altered))
    with build.drawing(pattern=not altered.has("place")):
        act = build.add("act")
        if (num := altered.find("num")) is not None:
            build.add("amt", literal=num.value, amt=act)
        elif altered.has("other_way"):
            build.add("dir", OTHER_WAY, dir=act)
        elif (not_so := altered.find("not_so")) is not None:
            way = SLOWER.get(not_so.slot("adv") or not_so.slot("hq"))
            if way is None:
                raise NoMeaningError(str(altered))
            more = AList("manner", (AList("faster", (AList("adv", value=way),)),))
            build.modifiers(act, AList("altered", (more,)))
        else:
            build.modifiers(act, altered)
        step = Directive("DO", build.graphlet(act))
    return Chain((*build.looked_up(), Play((step,))))


def _words(build: Build, alist: AList, of: Graphlet | None) -> Revision:
    """Other words to be said."""
    parts = []
    for slot in ("new_words", "old_words"):
        with build.drawing(pattern=True):
            said = alist.first(slot)
            txt = build.add("txt", literal=said.value or said.slot("quote") or said.slot("quoted"))
            parts.append(build.graphlet(build.add("act", "say", obj=txt)))
    return Revision(sequence(Directive("DO", parts[0])), parts[1], of)


def _one(described: AList) -> AList:
    """ "Red" is "the red one", "Mary's" is Mary's one."""
    whose = described if described.name == "owner" else AList("det", value="the")
    quality = (described,) if described.name == "qual" else ()
    return AList("np", (whose, *quality, AList("ako", value="one")))


def _thing(alist: AList) -> AList | None:
    """The thing that is named, by itself, as where to go, or by a quality or an owner alone."""
    part = alist.find("np", "dest", "qual", "owner")
    if part is None or part.name == "np":
        return part
    return part.find("np") if part.name == "dest" else _one(part)


def _things(build: Build, alist: AList) -> tuple[Graphlet | None, Chain]:
    """Another thing: "not the red one the blue one"; the chain holds its look-up alone."""
    was, new, replaced = alist.find("was"), _thing(alist), None
    old = None if was is None else _thing(was)
    if new is None:
        raise NoMeaningError(str(alist))
    if old is not None:
        with build.drawing(pattern=True):
            replaced = build.graphlet(build.thing(old))
    if is_said_to_persons(new) or (is_bare(new) and not new.has("one")) or is_abstract(new):
        raise NoMeaningError("sorry, wrong number")
    with build.drawing(pattern=False):
        build.thing(new)
    if not build.finds:
        raise NoMeaningError("another thing that is the same")
    return replaced, Chain(tuple(Play((Directive("FIND", find),)) for find in build.finds))
