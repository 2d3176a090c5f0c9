"""Questions: what is asked, the net it is about, and the node that is wanted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from grammars.alist import AList
from grammars.asked import related
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.dates import day_asked
from grammars.mentions import compounded
from grammars.occasions import either_so, occasional, on_occasion, since_told
from grammars.registry import sentence_form
from grammars.relatives import predicate
from grammars.sorts import is_attribute, kind
from grammars.topics import may_be_about, obeys, of_topic, steps, what_stops, when_learned
from grammars.wanted import (
    ASKS,
    adverbial,
    asked_thing,
    cleft,
    fronted,
    how_known,
    same_thing,
    subject,
    wanted,
    what_for,
    what_thinks,
    whether,
    why,
)
from kernel.memory.meaning import Question

EXAMPLES = (
    "what is in front of you",
    "who is mary",
    "Where is the biggest block?",
    "which block is heavy",
    "are you holding a block",
    "did you turn left",
    "how many red blocks are there",
    "How many times did you turn?",
    "Why didn't you grab Mary?",
    "what are you doing",
    "what did you just do",
    "what do you know about mary",
    "Do you know how to dance?",
    "how do you cha-cha",
    "who taught you to dance",
    "Who told you that Mary is a girl?",
    "why not",
    "why is mary a person",
    "when did you turn left",
    "when did you learn to dance",
    "who told you not to grab mary",
    "are you allowed to grab mary",
    "what are you not allowed to do",
    "what happens when something is close",
    "what happens before you turn left",
    "what do you do after you turn left",
    "what would you do if I said turn left then grab the block",
    "what would you do if I said turn left while the gripper is empty",
    "what would you do if I said grab each blue block",
    "show me what you would do if something is very close",
    "which cup did Freddy tell you to lift",
    "did Mary tell you to turn left",
    "what are you afraid of",
    "where are you going",
    "how far did you drive",
    "how long did you wait",
    "when do you say hello",
    "is the gripper open or closed",
    "what are you not allowed to touch",
    "I wonder who may tell you to turn left",
)


@sentence_form("question", "question", EXAMPLES)
def question(alist: AList) -> Question:
    """The question; everything described is in the one net it is about."""
    roughly = alist.slot("roughly")
    body = alist.parts[1 if roughly else 0]
    build = Build()
    with build.drawing(pattern=True):
        asked = SO[body.name](build, body) if body.name in SO else of_topic(build, body)
        if roughly and not may_be_about(asked.ask, roughly):
            raise NoMeaningError(roughly)
        if (occasion := alist.find("occasion")) is not None:
            return replace(asked, about=on_occasion(build, asked.about, body, occasion))
        return asked


def _what(build: Build, body: AList) -> Question:
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


def _holding(build: Build, body: AList) -> Question:
    held = body.find("np")
    thing = build.add("obj") if held is None else build.thing(held)
    act = build.add("act", "hold", agt=build.oneself("you"), obj=thing)
    if held is None:
        return Question("what", build.graphlet(act), thing)
    return Question("yesno", build.graphlet(act))


def _color(build: Build, body: AList) -> Question:
    """ "What color is the block": the wanted quality is itself of a kind, as in the paper's figure."""
    attribute = body.slot("attribute")
    if not is_attribute(attribute) or attribute == "day":  # "what is Tom's sister"
        raise NoMeaningError(str(body))
    thing = build.thing(body.find("np") or _owned(build, body))
    hq = build.add("hq", hq=thing)
    build.add("ako", attribute, ako=hq)
    return Question("what", build.graphlet(hq), hq)


def _how_much(build: Build, body: AList) -> Question:
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


def _who(build: Build, body: AList) -> Question:
    thing = _meant(build, body)
    return Question("who", build.graphlet(thing), thing)


def _whose(build: Build, body: AList) -> Question:
    things = body.all("np")
    wanted = build.add("obj")
    inner = body.find("owner2")
    thing = build.thing(things[-1] if things else (inner or body).first("np"))
    for qual in body.all("qual"):
        build.quality(thing, qual)
    if called := kind(body):
        build.kind(thing, called, compounded(body))
    return Question("who", build.graphlet(build.add("own", own=thing, of=wanted)), wanted)


def _where(build: Build, body: AList) -> Question:
    if (both := body.find("both_of")) is not None:  # "where are Tim and Oscar"
        locs = [build.add("loc", loc=build.thing(np)) for np in both.all("np")]
        return Question("where", build.graphlet(locs[0]), locs[0])
    thing = _meant(build, body)
    if (place := body.find("loc")) is not None:
        build.place("loc", thing, place)
    loc = build.add("loc", loc=thing)
    return Question("where", build.graphlet(loc), loc)


def _either(build: Build, body: AList) -> Question:
    """ "Who is taller, John or Mary": whether the first is; asked as which."""
    word = body.first("which_one").slot("wh_word") if body.has("which_one") else "which"
    one, other = (build.thing(np) for np in body.all("np"))
    most = body.find("the_most") or body
    hq = build.add("hq", most.slot("adjer") or most.slot("adjest"), hq=one, than=other)
    return Question(ASKS.get(word, "which"), build.graphlet(hq), one)


def _yesno(build: Build, body: AList) -> Question:
    if (said := body.find("clause")) is not None:
        return Question("yesno", build.graphlet(clause(build, said)))
    if (asks := body.find("asks")) is not None:
        return whether(build, asks)
    if (done := body.find("gerunding")) is not None:  # "have you finished turning"
        return Question("yesno", build.graphlet(build.action(done)), "", "did")
    if (way := body.find("action")) is not None:  # "you know how to waltz, don't you"
        return Question("yesno", build.graphlet(build.action(way)), "", "know_how")
    subject = body.find("np")
    agent = build.oneself("you") if subject is None else build.thing(subject)
    if body.has("pred"):  # "are all birds animals"
        return Question("yesno", build.graphlet(clause(build, body)))
    things = body.all("np")
    if not things or body.has("name"):
        raise NoMeaningError(str(body))
    verb = "see" if body.has("seen") else "have"
    owned = build.thing(things[-1])
    owner = agent if len(things) > 1 else build.oneself("you")
    return Question("yesno", build.graphlet(build.add("act", verb, agt=owner, obj=owned)))


def _howmany(build: Build, body: AList) -> Question:
    ask, wanted, thing = asked_thing(build, body.first("wh"))
    if ask != "howmany":
        raise NoMeaningError(str(body))
    pred = body.find("pred")
    main = thing if pred is None else predicate(build, thing, pred, negated=False)
    return Question(ask, build.graphlet(main), wanted)


def _seeing(build: Build, body: AList) -> Question:
    """ "Can you see the ball": whether it does."""
    both = body.find("both_of") or AList("both_of")
    agent, *things = [build.thing(np) for np in (*body.all("np"), *both.all("np"))]
    see, *_ = [build.add("act", body.slot("perceiving"), agt=agent, obj=each) for each in things]
    build.modifiers(see, body)
    return Question("yesno", build.graphlet(see))


def _how_is(build: Build, body: AList) -> Question:
    hq = build.add("hq", hq=build.thing(body.first("np")))
    return Question("how", build.graphlet(hq), hq)


def _named(build: Build, body: AList) -> Question:
    """ "What do you call this", "what is the dog called": what it is, or who."""
    thing = build.thing(body.first("np"))
    return Question("what", build.graphlet(thing), thing)


def _which_is(build: Build, body: AList) -> Question:
    thing = _meant(build, body)
    return Question("which", build.graphlet(thing), thing)


def _which_way(build: Build, body: AList) -> Question:
    loc = build.add("loc", loc=build.thing(body.first("np")))
    return Question("which", build.graphlet(loc), loc)


def _why(build: Build, body: AList) -> Question:
    if body.has("asks"):
        return why(build, body)
    return of_topic(build, body)


SO: Final[dict[str, Callable[[Build, AList], Question]]] = {
    "what": _what,
    "holding": _holding,
    "color": _color,
    "how_much": _how_much,
    "who": _who,
    "whose": _whose,
    "where": _where,
    "either": _either,
    "yesno": _yesno,
    "howmany": _howmany,
    "why": _why,
    "what_for": what_for,
    "what_thinks": what_thinks,
    "how_known": how_known,
    "what_stops": what_stops,
    "seeing": _seeing,
    "how_is": _how_is,
    "named_what": _named,
    "which_is": _which_is,
    "cleft": cleft,
    "obeys": obeys,
    "either_so": either_so,
    "same_thing": same_thing,
    "which_way": _which_way,
    "steps": steps,
    "occasional": occasional,
    "since_told": since_told,
    "when_learned": when_learned,
    "day_so": day_asked,
    "what_day": day_asked,
    "subject": subject,
    "wanted": wanted,
    "adverbial": adverbial,
    "fronted": fronted,
}
