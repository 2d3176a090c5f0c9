"""Questions: what is asked, the net it is about, and the node that is wanted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause, condition
from grammars.registry import sentence_form
from kernel.memory.meaning import Ask, Question
from kernel.net.graphlet import Graphlet

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
# Bracket to question word and topic, for questions about the robot's own doings and lessons.
TOPICS: Final[dict[str, tuple[Ask, str]]] = {
    "why": ("why", "did"),
    "busy": ("what", "doing"),
    "did_what": ("what", "did"),
    "know_about": ("what", "know_about"),
    "know_how": ("yesno", "know_how"),
    "how": ("how", "know_how"),
    "taught": ("who", "taught"),
    "told": ("who", "taught"),
    "happens": ("what", "happens"),
    "means": ("how", "means"),
    "what_before": ("what", "before"),
    "what_after": ("what", "after"),
    "abilities": ("what", "abilities"),
    "whoami": ("who", "identity"),
    "allowed": ("yesno", "allowed"),
    "when_learned": ("when", "taught"),
    "when_did": ("when", "did"),
    "would": ("what", "would"),
}


@sentence_form("question", "question", EXAMPLES)
def question(alist: AList) -> Question:
    """The question; everything described is in the one net it is about."""
    body = alist.parts[0]
    build = Build()
    with build.drawing(pattern=True):
        if body.name in TOPICS:
            ask, topic = TOPICS[body.name]
            if body.name == "why" and body.has("pred"):
                topic = "taught"  # what is so has no doer, but a source
            chain = body.find("chain")
            supposed = build.chain(chain) if chain is not None else None
            return Question(ask, _about(build, body), "", topic, supposed)
        return SO[body.name](build, body)


def _about(build: Build, body: AList) -> Graphlet:
    """The act, clause or thing that a question about the robot itself is about; "that" where none is named."""
    if (conds := body.find("conds")) is not None:
        return condition(build, conds)
    if (said := body.find("clause")) is not None:
        return build.graphlet(clause(build, said))
    if (action := body.find("action", "gerunding")) is not None:
        act = build.action(action)
        if any(part.name == "neg" for part in body):
            build.sketch.change(act, negated=True)
        return build.graphlet(act)
    if (pred := body.find("pred")) is not None:
        return build.graphlet(build.predicate(build.thing(body.first("np")), pred, negated=False))
    if (np := body.find("np")) is not None:
        return build.graphlet(build.thing(np))
    if (word := body.slot("quote_word")) or (word := body.slot("quote")):
        return build.graphlet(build.add("act", word.lower()))
    if body.name == "whoami":
        return build.graphlet(build.oneself("me"))
    if body.name in ("busy", "did_what", "abilities", "would"):
        return build.graphlet(build.add("act", agt=build.oneself("you")))
    words = (body.value or "").split() if body.name == "why" else ["that"]
    bare = "" if words in (["why"], ["why", "not"]) else "that"  # of whatever was said or done last
    return build.graphlet(build.add("act", ref=bare, negated="not" in words))


def _what(build: Build, body: AList) -> Question:
    """ "What is in front of you": a thing is wanted; "what is a robin": what is known of it."""
    if (place := body.find("pred_place")) is not None:
        wanted = build.add("obj")
        return Question("what", build.graphlet(build.predicate(wanted, place, False)), wanted)
    if (qual := body.find("qual")) is not None:
        wanted = build.add("obj")
        return Question("what", build.graphlet(build.quality(wanted, qual)), wanted)
    things = body.all("np")
    if body.has("state_verb"):
        agent = build.thing(things[0]) if things else build.oneself("you")
        wanted = build.add("obj")
        verb = body.slot("state_verb") or "have"
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
        build.kind(thing, kind, body.slot("sub"))
    return Question("who", build.graphlet(build.add("own", own=thing, of=wanted)), wanted)


def _where(build: Build, body: AList) -> Question:
    loc = build.add("loc", loc=build.thing(body.first("np")))
    return Question("where", build.graphlet(loc), loc)


def _which(build: Build, body: AList) -> Question:
    described = tuple(p for p in body if p.name in ("ako", "akos", "sub", "qual", "one"))
    thing = build.thing(body.find("np") or AList("np", described))
    main = build.predicate(thing, body.first("pred"), negated=False)
    return Question("which", build.graphlet(main), thing)


def _yesno(build: Build, body: AList) -> Question:
    if (action := body.find("action")) is not None:
        subject = body.find("np")
        act = build.action(action)
        agent = build.oneself("you") if subject is None else build.thing(subject, person=True)
        build.sketch.link(act, "agt", agent)
        return Question("yesno", build.graphlet(act), "", "did" if subject is None else "")
    if (exists := body.find("exists_q")) is not None:
        thing = build.thing(exists.first("np"))
        if (pred := exists.find("pred")) is not None:
            return Question("yesno", build.graphlet(build.predicate(thing, pred, False)))
        return Question("yesno", build.graphlet(thing))
    does = body.find("does_q")
    if body.find("pred") is not None or body.has("going"):
        you = body.find("np") is None
        subject_name = build.oneself("you") if you else ""
        return Question("yesno", build.graphlet(clause(build, body, subject_name)))
    things = body.all("np")
    agent = build.thing(things[0]) if things and (does or len(things) > 1) else build.oneself("you")
    if does is not None:
        parts = tuple(AList("habit", (does,)) if does.value else does for _ in (0,))
        habit = AList("habit", parts[0].parts)
        return Question("yesno", build.graphlet(clause(build, AList("q", (habit,)), agent)))
    if things and not body.has("name"):
        owned = build.thing(things[-1])
        return Question("yesno", build.graphlet(build.add("act", "have", agt=agent, obj=owned)))
    raise NoMeaningError(str(body))


def _howmany(build: Build, body: AList) -> Question:
    if (action := body.find("action")) is not None:
        return Question("howmany", build.graphlet(build.action(action)), "", "did")
    described = tuple(p for p in body if p.name in ("ako", "akos", "sub", "qual", "one"))
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
    "yesno": _yesno,
    "howmany": _howmany,
}
