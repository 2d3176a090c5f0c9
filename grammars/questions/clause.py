"""A clause as it is asked and as it is told: what somebody does, did, may do or is, drawn as a net.

"Did Freddy tell you to lift it" and "what Freddy told you to lift" hold the same clause; what is asked for, and what of
it is missing, is the business of `wanted.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from grammars.alist import AList
from grammars.alternatives import one_each
from grammars.build import Build, NoMeaningError
from grammars.called import called
from grammars.comparing import seen_from_robot
from grammars.mutual import each_other
from grammars.questions.gaps import fill
from grammars.questions.states import state
from grammars.questions.topics import DEEDS
from grammars.relatives import predicate
from grammars.render.telling import SAYING
from grammars.vocabulary import BORN

YOU: Final = AList("np", (AList("pron", value="you"),))
# What stands for a deed without naming it: "do", "do that".
BLANK: Final = ("do_it", "do_that", "doing_it", "doing_that")
ALLOWED: Final = ("possible", "safe", "forbidden", "allowed")  # asked of the robot itself
SUBJECTS: Final = ("agt", *SAYING)
SEVERAL: Final = {
    "several": "action",
    "several_doing": "gerunding",
    "several_did": "did_it",
    "several_does": "action",
}
ORDERS: Final = ("ordered", "orders")  # what somebody told the robot, and may tell it
DESCRIBING: Final = ("ako", "akos", "sub", "qual", "one")
# What of a deed is asked, by the words that help its verb; "request": of the robot it would be a command.
BOUND: Final = {
    "able to": "know_how",
    "allowed to": "allowed",
    "permitted to": "allowed",
    "supposed to": "allowed",
    "meant to": "allowed",
    "forbidden to": "allowed",
}
MODAL: Final = {"must": "allowed", "should": "allowed", "may": "allowed", "shall": "allowed"}


@dataclass(frozen=True, slots=True)
class Said:
    """A clause drawn.

    Attributes:
        main: node of its predicate.
        inner: of the act in which a thing may be missing: what somebody is told to do.
        own: it is a deed of the robot's; its agent is left out.
        past: it was. going: it is going on.
        topic: what is asked of such a deed, by the verb that helps: whether it is allowed ...
    """

    main: str
    inner: str = ""
    own: bool = False
    past: bool = False
    going: bool = False
    topic: str = ""


def drawn(build: Build, asks: AList, agent: str = "") -> Said:
    """Draw a clause.

    Args:
        build: the drawing.
        asks: bracket with the clause's parts.
        agent: node of its subject, where that is what is asked for.
    """
    if (several := asks.find(*SEVERAL)) is not None:
        return _of_each(build, asks, several, agent)
    asks = seen_from_robot(asks)
    denied = asks.has("neg") or asks.has("negq")
    subject = asks.find("np")
    if subject is not None and (named := called(build, subject, asks)):
        return Said(named)
    build.negative = False
    if (exist := asks.find("exist")) is not None:
        main = _existing(build, exist)
        return Said(_deny(build, main, build.negative and not main.startswith("obj")))
    deemed = asks.find("deemed")  # "it is dangerous to touch the lamp"
    if deemed is not None and deemed.slot("hq") not in ALLOWED:
        hq = build.quality(build.action(deemed.first("action")), deemed)
        return Said(_deny(build, hq, asks.has("neg")))
    if (both := asks.find("both_of")) is not None:
        return _both(build, asks, both.all("np"))
    own = not agent and (subject is None or subject.slot("pron") == "you")
    deed = asks.find(*DEEDS, *BLANK, "spoken", "instructing")
    who = agent or ("" if own and deed is not None else build.thing(subject or YOU))
    denied = denied or build.negative  # "why is nothing red"
    if subject is not None and asks.has("neg") and not build.negative and who:
        build.not_all(who, subject)
    if (passive := asks.find("passive")) is not None:
        if asks.find("was_q", "has_q", "modal_q") is None and agent == "":
            raise NoMeaningError(str(asks))  # "is this seat taken" tells of no deed
        main = build.action(passive.first(*DEEDS))
        build.sketch.link(main, "obj", who)
        if (by := passive.find("np")) is not None:
            build.sketch.link(main, "agt", build.thing(by, person=True))
        return Said(_deny(build, main, denied), past=True)
    if deed is not None:
        return _deed(build, asks, who, own, denied)
    if (ordered := asks.find("ordered_q")) is not None:
        inner = _act(build, ordered, ordered.has("neg"))
        who = build.oneself("you") if own else who
        return Said(
            _deny(build, build.add("act", "tell", dest=who, cmd=inner), denied),
            inner,
            topic="ordered",
        )
    if (commanding := asks.find("commanding")) is not None:
        inner = _act(build, commanding, commanding.has("neg"))
        main = build.add("act", "tell", agt=who, dest=build.oneself("you"), cmd=inner)
        may = asks.has("modal_q") or asks.has("bound")
        return Said(_deny(build, main, denied), inner, topic="orders" if may else "ordered")
    _somebody(build, asks, asks.slot("bound"))
    return Said(_deny(build, state(build, asks, who), denied))


def _both(build: Build, asks: AList, subjects: list[AList]) -> Said:
    """ "Did Tim and Oscar come in": the same of each."""
    if told := each_other(asks, subjects):
        return drawn(build, told[0])
    rest = tuple(part for part in asks if part.name != "both_of")
    so = drawn(build, AList(asks.name, (subjects[0], *rest)))
    links = build.sketch.terms[so.main].links
    if one := next((name for role, name in links if role in SUBJECTS), ""):
        _alike(build, so.main, one, subjects[1:])
    else:  # "did you and Tim come in"
        for np in subjects[1:]:
            drawn(build, AList(asks.name, (np, *rest)))
    return so


def _of_each(build: Build, asks: AList, several: AList, agent: str) -> Said:
    """ "Did you grab the ball and the cup": the same with each."""
    rest = tuple(part for part in asks if part is not several)
    deed = AList(SEVERAL[several.name], one_each(several)[0].parts)
    so = drawn(build, AList(asks.name, (*rest, deed)), agent)
    of = so.inner or so.main
    obj = dict(build.sketch.terms[of].links).get("obj", "")
    _alike(build, of, obj, several.all("np")[1:])
    return so


def _alike(build: Build, main: str, one: str, others: list[AList]) -> None:
    """Say the same of each of the others as of this one."""
    term = build.sketch.terms[main]
    for np in others:
        thing = build.thing(np)
        links = {role: thing if name == one else name for role, name in term.links}
        build.add(term.kind, *term.lex, negated=term.negated, **links)


def by_robot(build: Build, act: str) -> None:
    """It is the robot who does so, with whatever things it does it."""
    term = build.sketch.terms[act]
    for name in list(build.board):
        same = build.sketch.terms[name]
        if same.kind == term.kind and same.lex == term.lex and not dict(same.links).get("agt"):
            build.sketch.link(name, "agt", build.oneself("you"))


def _deny(build: Build, node: str, denied: bool) -> str:
    if denied:
        build.sketch.change(node, negated=True)
    return node


def _act(build: Build, part: AList, denied: bool = False) -> str:
    """The act that a bracket holds, or one without a word: "do"."""
    if (spoken := part.find("spoken")) is not None:
        verb = next((one.name for one in spoken if one.name in ("say", "tell", "ask")), "say")
        act = build.add("act", verb)
        if (hearer := spoken.find("hearer", "listener")) is not None and hearer.parts:
            build.sketch.link(act, "dest", build.thing(hearer.find("np") or hearer, person=True))
        return _deny(build, act, denied)
    if (teaching := part.find("instructing")) is not None:
        act = build.add("act", "teach", dest=build.oneself("you"))
        if (taught := teaching.find(*DEEDS)) is not None:
            build.sketch.link(act, "cmd", build.action(taught))
        return _deny(build, act, denied)
    found = part.find(*DEEDS)
    if found is not None:
        act = build.action(found)
    else:
        act = build.add("act", ref="that" if part.has("do_that") or part.has("doing_that") else "")
    if found is not None and found.name == "did_it" and found.has("iobj"):
        verb = min(build.sketch.terms[act].lex, default="")
        if "GIVE" not in BORN.readings(verb):  # "gave you the key", not "moved you the key"
            raise NoMeaningError(str(found))
    return _deny(build, act, denied)


def _deed(build: Build, asks: AList, who: str, own: bool, denied: bool) -> Said:
    """What somebody does, did, may do or is about to do."""
    act = _act(build, asks, denied)
    modal, bound = asks.slot("modal_q"), asks.slot("bound")
    past = any(asks.has(name) for name in ("past_q", "has_q", "was_q", "did_it", "said_it"))
    going = asks.has("gerunding") or asks.has("doing_it") or asks.has("doing_that")
    if who:
        build.sketch.link(act, "agt", who)
        _somebody(build, asks, bound)
    topic = BOUND.get(bound, "doing") if bound else MODAL.get(modal, "request") if modal else ""
    return Said(act, act, own, past and not bound, going and not past, topic)


def _somebody(build: Build, asks: AList, bound: str) -> None:
    """Of whom it says what is allowed, or repeats what was said, the robot knows: others are not its business."""
    subject = asks.find("np") or YOU
    known = subject.has("name") or subject.has("pron") or subject.has("vague")
    thing = bool(bound) and subject.slot("pron") == "it"
    if (bound or asks.has("spoken")) and (not known or thing):
        raise NoMeaningError(str(asks))


def _existing(build: Build, exist: AList) -> str:
    """ "There is a cup on the table", "there are two boxes"."""
    if (clause_of := exist.find("related")) is not None:
        return related(build, clause_of)
    np = exist.find("np") or AList("np", tuple(part for part in exist if part.name in DESCRIBING))
    thing = build.thing(np)
    if number := exist.slot("num"):
        build.add("cnt", literal=number, cnt=thing)
    where = exist.find("pred") or AList("pred", tuple(exist.all("hereabouts", "loc")))
    return predicate(build, thing, where, negated=False) if where.parts else thing


def related(build: Build, np: AList) -> str:
    """Node of a thing that a clause describes: "the box that Tom brought"."""
    thing = build.thing(AList("np", tuple(part for part in np if part.name != "asks")))
    of_clause(build, np, thing)
    return thing


def of_clause(build: Build, np: AList, thing: str) -> None:
    """Say of a thing what a clause says that misses it."""
    so = drawn(build, np.first("asks"))
    fill(build, so.inner or so.main, thing, "", np)
    if so.own:
        build.sketch.link(so.main, "agt", build.oneself("you"))


def order_topic(so: Said) -> str:
    """The topic, if it is what somebody told the robot or may tell it."""
    return so.topic if so.topic in ORDERS else ""


def topic_of(build: Build, so: Said) -> str:
    """What of the robot's own doings is asked about; where it is nothing of that sort, its act gets its agent."""
    if topic := order_topic(so):
        return topic
    if so.own:
        topic = "did" if so.past else "doing" if so.going else so.topic.removeprefix("request")
    if so.own and not topic:
        by_robot(build, so.main)
    return topic
