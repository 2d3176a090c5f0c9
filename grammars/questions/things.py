"""Questions about a thing: what and who it is, whose, where, of what color, how far away."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.mentions import compounded
from grammars.questions.clause import related
from grammars.questions.wanted import ASKS
from grammars.sorts import is_attribute, kind
from kernel.memory.meaning import Question


def what(build: Build, body: AList) -> Question:
    """ "What is a robin": what is known of it."""
    thing = _meant(build, body)
    return Question("what", build.graphlet(thing), thing)


def _meant(build: Build, body: AList) -> str:
    """Node of the thing a question is about, with what is said of it."""
    if (clause_of := body.find("related")) is not None:
        return related(build, clause_of)
    if (pointed := body.find("pointed")) is not None:  # "that on the chair"
        thing = build.thing(pointed)
        build.place("loc", thing, pointed.first("loc"))
        return thing
    np = body.find("np")
    if np is None:
        raise NoMeaningError(str(body))
    return build.thing(np)


def holding(build: Build, body: AList) -> Question:
    """ "What are you holding", "are you holding the cup"."""
    held = body.find("np")
    thing = build.add("obj") if held is None else build.thing(held)
    act = build.add("act", "hold", agt=build.oneself("you"), obj=thing)
    if held is None:
        return Question("what", build.graphlet(act), thing)
    return Question("yesno", build.graphlet(act))


def color(build: Build, body: AList) -> Question:
    """ "What color is the block": the wanted quality is itself of a kind, as in the paper's figure."""
    attribute = body.slot("attribute")
    if not is_attribute(attribute) or attribute == "day":  # "what is Tom's sister"
        raise NoMeaningError(str(body))
    thing = build.thing(body.find("np") or _owned(build, body))
    hq = build.add("hq", hq=thing)
    build.add("ako", attribute, ako=hq)
    return Question("what", build.graphlet(hq), hq)


def how_much(build: Build, body: AList) -> Question:
    """ "How far is the wall": the degree of the quality is wanted."""
    things = body.all("np")
    if things and things[0].slot("pron") == "it" and len(things) > 1:  # "how far is it to the door"
        things.pop(0)
    first, *others = [build.thing(np) for np in things] or [build.oneself("you")]
    for other in others:
        build.add("loc", "from", loc=first, wrt=other)
    thing = first
    hq = build.add("hq", body.slot("hq"), hq=thing)
    wanted = build.add("deg", deg=hq)
    return Question("how", build.graphlet(hq), wanted)


def _owned(_: Build, body: AList) -> AList:
    owner = body.find("owner")
    if owner is not None:
        return AList("np", owner.parts or (AList("name", value=owner.value),))
    return AList(
        "np", (AList("pron", value={"your": "you", "my": "me"}.get(body.slot("own"), "it")),)
    )


def who(build: Build, body: AList) -> Question:
    """ "Who is Mary", "who is that on the chair"."""
    thing = _meant(build, body)
    return Question("who", build.graphlet(thing), thing)


def whose(build: Build, body: AList) -> Question:
    """ "Whose cup is this", "who owns the red car"."""
    things = body.all("np")
    wanted = build.add("obj")
    inner = body.find("owner2")
    thing = build.thing(things[-1] if things else (inner or body).first("np"))
    for qual in body.all("qual"):
        build.quality(thing, qual)
    if called := kind(body):
        build.kind(thing, called, compounded(body))
    return Question("who", build.graphlet(build.add("own", own=thing, of=wanted)), wanted)


def where(build: Build, body: AList) -> Question:
    """ "Where is the cup": its place is wanted."""
    if (both := body.find("both_of")) is not None:  # "where are Tim and Oscar"
        locs = [build.add("loc", loc=build.thing(np)) for np in both.all("np")]
        return Question("where", build.graphlet(locs[0]), locs[0])
    thing = _meant(build, body)
    if (place := body.find("loc")) is not None:
        build.place("loc", thing, place)
    loc = build.add("loc", loc=thing)
    return Question("where", build.graphlet(loc), loc)


def either(build: Build, body: AList) -> Question:
    """ "Who is taller, John or Mary": whether the first is; asked as which."""
    word = body.first("which_one").slot("wh_word") if body.has("which_one") else "which"
    one, other = (build.thing(np) for np in body.all("np"))
    most = body.find("the_most") or body
    hq = build.add("hq", most.slot("adjer") or most.slot("adjest"), hq=one, than=other)
    return Question(ASKS.get(word, "which"), build.graphlet(hq), one)


def how_is(build: Build, body: AList) -> Question:
    """ "How is Mary": a quality of hers is wanted."""
    hq = build.add("hq", hq=build.thing(body.first("np")))
    return Question("how", build.graphlet(hq), hq)


def named(build: Build, body: AList) -> Question:
    """ "What do you call this", "what is the dog called": what it is, or who."""
    thing = build.thing(body.first("np"))
    return Question("what", build.graphlet(thing), thing)


def which_is(build: Build, body: AList) -> Question:
    """ "Which is the heavy one"."""
    thing = _meant(build, body)
    return Question("which", build.graphlet(thing), thing)


def which_way(build: Build, body: AList) -> Question:
    """ "Which way is the door"."""
    loc = build.add("loc", loc=build.thing(body.first("np")))
    return Question("which", build.graphlet(loc), loc)
