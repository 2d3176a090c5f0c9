"""What a question about the robot's own doings and lessons is about."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.conditions import condition
from grammars.relatives import predicate
from grammars.remarks import MENTAL
from kernel.memory.meaning import Ask, Question
from kernel.net.graphlet import Graphlet

# Bracket to question word and topic, for questions about the robot's own doings and lessons.
TOPICS: Final[dict[str, tuple[Ask, str]]] = {
    "why": ("why", "did"),
    "what_made": ("what", "why"),
    "what_would": ("what", "occasion"),
    "been": ("where", "did"),
    "takes": ("how", "takes"),
    "busy": ("what", "doing"),
    "intent": ("yesno", "doing"),
    "did_what": ("what", "did"),
    "know_about": ("what", "know_about"),
    "know_any": ("yesno", "know_about"),
    "know_how": ("yesno", "know_how"),
    "how": ("how", "know_how"),
    "taught": ("who", "taught"),
    "told": ("who", "taught"),
    "happens": ("what", "happens"),
    "means": ("what", "means"),
    "opposite": ("what", "opposite"),
    "mean_same": ("yesno", "means"),
    "what_before": ("what", "before"),
    "what_after": ("what", "after"),
    "abilities": ("what", "abilities"),
    "whoami": ("who", "identity"),
    "allowed": ("yesno", "allowed"),
    "when_did": ("when", "did"),
    "would": ("what", "would"),
}
DEEDS: Final = ("action", "gerunding", "did_it", "said_it")
KNOWING: Final = ("know", "remember", "learn", "forget")  # how to do something
WISHING: Final = ("want", "need", "like", "enjoy")  # a rest, a push
MEASURED: Final = ("how", "howmany", "when", "where")  # what may be so about
NEARLY: Final = ("roughly", "approximately", "about", "around")


def may_be_about(ask: Ask, how: str) -> bool:
    """ "Roughly how many", "exactly what": whether it may be asked so."""
    return ask in MEASURED or (how not in NEARLY and ask != "yesno")


def of_topic(build: Build, body: AList) -> Question:
    """A question about the robot's own doings and lessons."""
    ask, topic = TOPICS[body.name]
    if body.name == "why" and (body.has("pred") or body.has("does_q")):
        topic = "taught"  # what is so has no doer, but a source
    action = body.find("action")
    if topic == "know_how" and action is not None and action.slot("act") in MENTAL:
        raise NoMeaningError("how do you like your eggs")
    if body.name == "what_made" and action is not None and action.slot("act") == "think":
        raise NoMeaningError("what makes you think")
    if body.has("any_happens"):
        ask = "yesno"
    chain = body.find("chain")
    supposed = build.chain(chain) if chain is not None else None
    return Question(ask, _about(build, body), "", topic, supposed)


def _about(build: Build, body: AList) -> Graphlet:
    """The act, clause or thing that a question about the robot itself is about; "that" where none is named."""
    if (conds := body.find("conds")) is not None:
        return condition(build, conds)
    if (said := body.find("clause")) is not None:
        return build.graphlet(clause(build, said))
    if (does := body.find("does_q")) is not None:
        so = does_so(build, does, build.thing(body.first("np")))
        build.sketch.change(so, negated=body.has("neg"))
        return build.graphlet(so)
    if body.name == "takes" and (named := body.find("act")) is not None:  # "the dance"
        return build.graphlet(build.action(AList("action", (named,))))
    if (action := body.find(*DEEDS)) is not None:
        act = build.action(action)
        if any(part.name == "neg" for part in body):
            build.sketch.change(act, negated=True)
        return build.graphlet(act)
    if (pred := body.find("pred")) is not None:
        thing = build.thing(body.first("np"))
        return build.graphlet(predicate(build, thing, pred, negated=body.has("neg")))
    if (np := body.find("np")) is not None:
        thing = build.thing(np)
        if (teller := body.find("teller")) is not None:
            build.thing(teller.first("np"), person=True)
        return build.graphlet(thing)
    if word := body.slot("quote_word") or body.slot("openword") or body.slot("quote"):
        if body.name == "opposite":
            opposed = build.add("x", word.lower())
            build.add("ako", "opposite", ako=opposed)
            return build.graphlet(opposed)
        act = build.add("act", word.lower())
        if body.name == "mean_same":
            build.add("act", body.slot("openword").lower())
        return build.graphlet(act)
    if body.name == "whoami":
        return build.graphlet(build.oneself("me"))
    if body.name in ("busy", "been", "did_what", "abilities", "would"):
        return build.graphlet(build.add("act", agt=build.oneself("you")))
    words = (body.value or "").split() if body.name == "why" else ["that"]
    bare = "" if words in (["why"], ["why", "not"]) else "that"  # of whatever was said or done last
    return build.graphlet(build.add("act", ref=bare, negated="not" in words))


def does_so(build: Build, does: AList, agent: str) -> str:
    """ "Like cats", "like turning left", "know how to swim": node of what somebody does all the time."""
    verb = does.slot("state") or does.slot("states")
    skill, wish = does.find("action"), does.find("wish", "of_me")
    if (skill is not None and verb not in KNOWING) or (wish is not None and verb not in WISHING):
        raise NoMeaningError(str(does))
    if wish is not None and wish.name == "of_me":  # "do you want me to help"
        mine = build.action(wish.first("action"))
        build.sketch.link(mine, "agt", build.oneself("me"))
        return build.add("act", verb, agt=agent, obj=mine)
    if (deed := skill or wish or does.find("gerunding")) is not None:
        return build.add("act", verb, agt=agent, obj=build.action(deed))
    said = (AList("state", value=does.value),) if does.value else does.parts
    habit = AList("habit", said)
    return clause(build, AList("q", (habit,)), agent)


def not_allowed(build: Build) -> Question:
    """ "What are you not allowed to do"."""
    with build.drawing(pattern=True):
        return Question("yesno", build.graphlet(build.add("act", ref="that")), "", "allowed")


def obeys(build: Build, body: AList) -> Question:
    """ "Do you obey Tim": whether he may give orders."""
    who, act = build.thing(body.first("np"), person=True), build.add("act")
    main = build.add("act", "tell", agt=who, dest=build.oneself("you"), cmd=act)
    return Question("yesno", build.graphlet(main), "", "orders")


def when_learned(build: Build, body: AList) -> Question:
    """ "When did you learn to bow", "when did Olga teach you to bow"."""
    taught = _about(build, body).main
    if (teacher := body.find("teacher")) is not None:
        who = build.thing(teacher.first("np"), person=True)
        build.add("act", "teach", agt=who, dest=build.oneself("you"), cmd=taught)
    return Question("when", build.graphlet(taught), "", "taught")


def steps(build: Build, body: AList) -> Question:
    """ "How many steps are there in your dance", "what is the first step of the dance": they are told."""
    act = build.action(body.find("action") or AList("action", (body.first("act"),)))
    step = build.add("obj")
    build.kind(step, "step")
    if place := body.slot("ord"):
        build.add("hq", place, hq=step)
        return Question("what", build.graphlet(act), step, "know_how")
    return Question("howmany", build.graphlet(act), step, "know_how")
