"""Acts of somebody's into nets: "Mary is watching", "you see Mom coming", "he speaks Portuguese"."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import VERB_SLOTS
from grammars.sorts import is_abstract, kind, usages
from grammars.timing import it_is, timed
from grammars.usage import particles, put_nowhere
from grammars.vocabulary import BORN

if TYPE_CHECKING:
    from grammars.build import Build

TOOLS: Final = ("drill", "ropes", "score")
SIGHTS: Final = {
    f"{verb} sight of": verb[:1] == "l" for verb in ("catch", "catches", "lose", "loses")
}
ASKING_FOR: Final = ("asks for", "ask for")
WISHES: Final = ("like", "want", "need", "prefer")
BACK: Final = {"backward": "back", "forward": "ahead"}
THINGS: Final = ("it", "this", "that", "these", "those")
PAST: Final = "past"
ADDRESSING: Final = ("speak", "talk")
BIDDEN: Final = {"asked": "ask", "told": "tell"}
SPEAKING: Final = (*ADDRESSING, "tell", "ask")


def doing(build: Build, part: AList, agent: str, objects: list[AList], negated: bool) -> str:
    """Draw what the agent does; the node of the act."""
    going = part.find("going")
    body = part
    if part.name.startswith("habit"):
        objects = part.all("np")
    elif going is not None and not part.has("does"):
        body, objects = going, going.all("np")
    verb = next((body.slot(s) for s in VERB_SLOTS if body.has(s)), body.value or "")
    if verb == "have" and not objects:
        raise NoMeaningError(str(part))
    if put_nowhere(verb, body, objects[0] if objects else None):
        raise NoMeaningError(str(part))
    if verb in ASKING_FOR:
        verb = "ask for"
    if verb in SIGHTS:  # "you lose sight of me"
        verb, negated = "see", negated or SIGHTS[verb]
    verb, way, body = _with_particle(verb, body)
    links: dict[str, str] = {"agt": agent}
    if verb in WISHES and not objects and not body.has("dest"):  # "whenever you like"
        raise NoMeaningError(str(part))
    if not objects and {"needing", "venting"} <= usages(verb):  # "until nothing thanks"
        raise NoMeaningError(str(part))
    if objects and ("alone" in usages(verb) or (verb == "know" and not _is_knowable(objects[0]))):
        raise NoMeaningError(str(part))
    if objects and build.telling and "telling" not in usages(verb) and is_abstract(objects[0]):
        raise NoMeaningError(str(part))
    if objects:
        links["dest" if verb in ("ask", "tell") else "obj"] = build.thing(objects[0])
    elif body.has("name"):
        links["obj"] = build.thing(body, person=False)
    if (iobj := body.find("iobj")) is not None:
        if "GIVE" not in BORN.readings(verb):
            raise NoMeaningError(str(part))
        links["dest"] = build.thing(iobj.first("np"), person=True)
    if (dest := body.find("dest")) is not None:
        telling = verb in ("ask", "tell") or "GIVE" in BORN.readings(verb)
        if dest.has("every") or (telling and dest.has("whither")):
            raise NoMeaningError(str(dest))
        links["dest"] = build.aside(dest.first("np"))
    act = build.add("act", verb, negated=negated or build.negative, **links)
    rest, times = timed(body) if build.pattern and not build.trigger else (body, [])
    build.modifiers(act, rest)
    if way:
        build.add("dir", way, dir=act)
    for time in times:
        it_is(build, time)
    if (without := part.find("not_doing")) is not None:  # "comes in without knocking"
        other = build.action(without)
        build.sketch.link(other, "agt", agent)
        build.sketch.change(other, negated=True)
    if part.has("does") and part.has("num"):  # "the clock strikes twelve"
        build.add("amt", literal=part.slot("num"), amt=act)
    if going is not None and part.has("does") and objects:
        build.add(
            "act",
            going.slot("gerund") or going.value or "",
            agt=links.get("obj", links.get("dest", "")),
        )
    return act


def _with_particle(verb: str, body: AList) -> tuple[str, str, AList]:
    """The verb, the direction that is part of it, and the bracket without what is said so: "Tom picks up the box"."""
    for at, part in enumerate(body):
        if part.name != "dir":
            continue
        known = particles().get(f"{verb} {BACK.get(part.value or '', part.value)}")
        if known is not None:
            return (*known, AList(body.name, (*body.parts[:at], *body.parts[at + 1 :]), body.value))
        if [after.name for after in body.parts[at + 1 : at + 2]] == ["np"]:
            raise NoMeaningError(str(body))  # "looks up the stairs"
    return verb, "", body


def undergone(build: Build, part: AList, done: AList, negated: bool) -> str:
    """Draw what is done to somebody, by whom is said or not: "you are pushed", "the box is picked up by Tom"."""
    doer = done.find("done_by_np")
    links = {} if doer is None else {"agt": build.thing(doer.first("np"))}
    thing = build.thing(part.first("np", "base_np"))
    verb, said = BIDDEN.get(done.slot("act"), done.slot("act")), done.slot("dir")
    if said:
        if f"{verb} {said}" not in particles():
            raise NoMeaningError(str(part))
        verb, said = particles()[f"{verb} {said}"]
    spoken = verb in SPEAKING
    if done.has("to_one") != (verb in ADDRESSING) or (not spoken and "alone" in usages(verb)):
        raise NoMeaningError(str(part))
    links["dest" if spoken else "obj"] = thing
    act = build.add("act", verb, negated=negated or build.negative, **links)
    if said:
        build.add("dir", said, dir=act)
    return act


def had(build: Build, part: AList, act: str) -> str:
    """The node of the act, of which it is said, where a fact tells so, that it is over: "I had a dog"."""
    if part.has("had") and build.telling:
        in_the_past(build, act)
    return act


def in_the_past(build: Build, act: str) -> None:
    """Say of a deed that it was done, and is no habit."""
    build.add("mod", PAST, mod=act)


def _is_knowable(np: AList) -> bool:
    """People, animals and the like may be known, and what is no thing at all: nobody "knows the drill"."""
    tool = kind(np) in TOOLS and np.slot("det") == "the"
    return not tool and np.slot("pron") not in THINGS
