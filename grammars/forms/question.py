"""Questions: what is asked, the net it is about, and the node that is wanted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.mentions import compounded
from grammars.registry import sentence_form
from grammars.topics import DEEDS, TOPICS, does_so, of_topic, on_occasion
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
)


@sentence_form("question", "question", EXAMPLES)
def question(alist: AList) -> Question:
    """The question; everything described is in the one net it is about."""
    body = alist.parts[0]
    build = Build()
    with build.drawing(pattern=True):
        asked = of_topic(build, body) if body.name in TOPICS else SO[body.name](build, body)
        if (occasion := alist.find("occasion")) is not None:
            return replace(asked, about=on_occasion(build, asked.about, occasion))
        return asked


def _what(build: Build, body: AList) -> Question:
    """ "What is in front of you": a thing is wanted; "what is a robin": what is known of it."""
    if (place := body.find("pred_place")) is not None:
        wanted = build.add("obj")
        return Question("what", build.graphlet(build.predicate(wanted, place, False)), wanted)
    if (qual := body.find("qual")) is not None:
        wanted = build.add("obj")
        return Question("what", build.graphlet(build.quality(wanted, qual)), wanted)
    things = body.all("np")
    if (doing := body.find("state_verb", "gerund")) is not None:
        agent = build.thing(things[0]) if things else build.oneself("you")
        wanted = build.add("obj")
        verb = doing.value or "have"
        return Question(
            "what", build.graphlet(build.add("act", verb, agt=agent, obj=wanted)), wanted
        )
    if not things:
        raise NoMeaningError(str(body))
    thing = build.thing(things[0])
    return Question("what", build.graphlet(thing), thing)


def _holding(build: Build, body: AList) -> Question:
    held = body.find("np")
    thing = build.add("obj") if held is None else build.thing(held)
    act = build.add("act", "hold", agt=build.oneself("you"), obj=thing)
    if held is None:
        return Question("what", build.graphlet(act), thing)
    return Question("yesno", build.graphlet(act))


def _color(build: Build, body: AList) -> Question:
    """ "What color is the block": the wanted quality is itself of a kind, as in the paper's figure."""
    thing = build.thing(body.find("np") or _owned(build, body))
    hq = build.add("hq", hq=thing)
    build.add("ako", body.slot("attribute"), ako=hq)
    return Question("what", build.graphlet(hq), hq)


def _how_much(build: Build, body: AList) -> Question:
    """ "How far is the wall": the degree of the quality is wanted."""
    np = body.find("np")
    thing = build.oneself("you") if np is None else build.thing(np)
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
    things = body.all("np")
    if (pred := body.find("pred")) is not None:
        wanted = build.add("obj")
        return Question("who", build.graphlet(build.predicate(wanted, pred, False)), wanted)
    if (done := body.find(*DEEDS)) is not None:
        wanted = build.add("obj")
        act = build.action(done)
        build.sketch.link(act, "agt", wanted)
        return Question("who", build.graphlet(act), wanted)
    if body.has("habit_s") or body.has("going"):
        wanted = build.add("obj")
        return Question("who", build.graphlet(clause(build, body, wanted)), wanted)
    if body.has("has") or (things and not body.has("is") and body.has("had")):
        raise NoMeaningError(str(body))
    thing = build.thing(things[0]) if things else build.oneself("you")
    return Question("who", build.graphlet(thing), thing)


def _whose(build: Build, body: AList) -> Question:
    things = body.all("np")
    wanted = build.add("obj")
    inner = body.find("owner2")
    thing = build.thing(things[-1] if things else (inner or body).first("np"))
    for qual in body.all("qual"):
        build.quality(thing, qual)
    if kind := body.slot("ako"):
        build.kind(thing, kind, compounded(body))
    return Question("who", build.graphlet(build.add("own", own=thing, of=wanted)), wanted)


def _where(build: Build, body: AList) -> Question:
    if (action := body.find(*DEEDS)) is not None:
        act = build.action(action)
        obj = next((other for role, other in build.sketch.terms[act].links if role == "obj"), "")
        if not obj:  # "where did you go"
            return Question("where", build.graphlet(act), "", "did")
        loc = build.add("loc", loc=obj)
        return Question("where", build.graphlet(loc), loc)
    loc = build.add("loc", loc=build.thing(body.first("np")))
    return Question("where", build.graphlet(loc), loc)


def _which(build: Build, body: AList) -> Question:
    described = tuple(p for p in body if p.name in ("ako", "akos", "sub", "qual", "one"))
    thing = build.thing(body.find("np") or AList("np", described))
    main = build.predicate(thing, body.first("pred"), negated=False)
    return Question("which", build.graphlet(main), thing)


def _either(build: Build, body: AList) -> Question:
    """ "Who is taller, John or Mary": whether the first is; asked as which."""
    one, other = (build.thing(np) for np in body.all("np"))
    hq = build.add("hq", body.slot("adjer"), hq=one, than=other)
    return Question("which", build.graphlet(hq), one)


def _yesno(build: Build, body: AList) -> Question:
    if (said := body.find("clause")) is not None:
        return Question("yesno", build.graphlet(clause(build, said)))
    subject = body.find("np")
    if (action := body.find(*DEEDS)) is not None:
        act = build.action(action)
        own = subject is None or subject.slot("pron") == "you"
        agent = build.oneself("you") if subject is None else build.thing(subject, person=True)
        build.sketch.link(act, "agt", agent)
        return Question("yesno", build.graphlet(act), "", "did" if own else "")
    if (exists := body.find("exists_q")) is not None:
        thing = build.thing(exists.first("np"))
        if (pred := exists.find("pred")) is not None:
            return Question("yesno", build.graphlet(build.predicate(thing, pred, False)))
        return Question("yesno", build.graphlet(thing))
    if body.has("pred") or body.has("going"):
        return Question("yesno", build.graphlet(clause(build, body)))
    agent = build.oneself("you") if subject is None else build.thing(subject)
    if (does := body.find("does_q")) is not None:
        return Question("yesno", build.graphlet(does_so(build, does, agent)))
    if (complement := body.find("complement")) is not None:
        hq = build.quality(agent, complement)
        build.add("loc", "of", loc=hq, wrt=build.thing(complement.first("np")))
        return Question("yesno", build.graphlet(hq))
    things = body.all("np")
    if not things or body.has("name"):
        raise NoMeaningError(str(body))
    verb = "see" if body.has("seen") else "have"
    owned = build.thing(things[-1])
    owner = agent if len(things) > 1 else build.oneself("you")
    return Question("yesno", build.graphlet(build.add("act", verb, agt=owner, obj=owned)))


def _howmany(build: Build, body: AList) -> Question:
    described = tuple(p for p in body if p.name in ("ako", "akos", "sub", "qual", "one"))
    if (action := body.find(*DEEDS)) is not None:
        act = build.action(action)
        if described:  # "how many blocks did you pick up"
            build.sketch.link(act, "obj", build.thing(AList("np", described)))
        return Question("howmany", build.graphlet(act), "", "did")
    thing = build.thing(AList("np", described))
    if (pred := body.find("pred")) is not None:
        main = build.predicate(thing, pred, negated=False)
    elif body.has("gerund") or body.has("state_verb"):
        verb = body.slot("gerund") or body.slot("state_verb") or "have"
        main = build.add("act", verb, agt=build.oneself("you"), obj=thing)
    elif (owner := body.find("np")) is not None:
        main = build.add("act", "have", agt=build.thing(owner), obj=thing)
    else:
        main = thing
    return Question("howmany", build.graphlet(main), thing)


SO: Final[dict[str, Callable[[Build, AList], Question]]] = {
    "what": _what,
    "holding": _holding,
    "color": _color,
    "how_much": _how_much,
    "who": _who,
    "whose": _whose,
    "where": _where,
    "which": _which,
    "either": _either,
    "yesno": _yesno,
    "howmany": _howmany,
}
