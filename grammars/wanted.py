"""Questions by their construction: a question word, and the clause around it, of which that is a part.

"Which cup did Freddy tell you to lift" is the clause "Freddy told you to lift" and the cup that is missing in it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from grammars.alist import AList
from grammars.asked import BLANK, DESCRIBING, YOU, Said, by_robot, drawn, of_clause
from grammars.build import Build, NoMeaningError
from grammars.gaps import fill
from grammars.mentions import EVERY, PLACES, compounded
from grammars.pacing import TIMES
from grammars.remarks import MENTAL
from grammars.sorts import kind
from grammars.topics import DEEDS, not_allowed
from kernel.memory.meaning import Ask, Question
from kernel.net.graphlet import Graphlet

ASKS: Final[dict[str, Ask]] = {
    "who": "who", "whom": "who", "whose": "who", "what": "what", "which": "which",
    "how many": "howmany", "how much": "howmany", "how often": "howmany", "how many times": "howmany",
    "how many more": "howmany",
    "where": "where", "when": "when", "at what time": "when", "how": "how",
}  # fmt: skip
ORDERS: Final = ("ordered", "orders")  # what somebody told the robot, and may tell it
SUPPOSED: Final = ("supposed to", "meant to")
BARE: Final = ("who", "whom", "what", "which", "how many")  # that may stand alone
ABLE: Final = ("know_how", "allowed", "request")
SINCE: Final = "since when"
IDLE: Final = frozenset("could would might shall".split())  # of others: nobody asks a robot


def whether(build: Build, asks: AList) -> Question:
    """Whether it is so: also "isn't it", "didn't you"."""
    mild = ("neg", "negq") if asks.find(*DEEDS) is not None else ("negq",)
    so = drawn(build, AList(asks.name, tuple(part for part in asks if part.name not in mild)))
    subject, modal = asks.find("np") or YOU, asks.slot("modal_q")
    others = not so.own and subject.slot("pron") != "i"
    unasked = (modal in IDLE and not so.past) or (modal == "may" and not subject.has("name"))
    idle = others and unasked
    if idle or (so.topic == "request" and so.own) or _says_nothing(build, so):
        raise NoMeaningError(str(asks))
    lesson = asks.find("instructing")
    if lesson is not None and lesson.find(*DEEDS) is not None:  # "did Mary teach you to bow"
        taught = dict(build.sketch.terms[so.main].links)["cmd"]
        return Question("yesno", build.graphlet(taught), "", "taught")
    if so.own and so.going and build.sketch.terms[so.main].lex:  # "are you holding it" is no deed
        by_robot(build, so.main)
        return Question("yesno", build.graphlet(so.main))
    topic = _topic(build, so)
    whole = subject.has("whole") or subject.slot("vague") in EVERY
    if not topic and whole:  # "are both of the cups empty"
        about = build.sketch.terms[so.main].links
        name = next(
            (other for role, other in about if role in ("agt", "hq", "loc", "own", "ako")), ""
        )
        if not name:  # "were everybody folded"
            raise NoMeaningError(str(asks))
        build.sketch.change(name, ref="every")
        topic = "every"
    return Question("yesno", build.graphlet(so.main), "", topic)


def _order_topic(so: Said) -> str:
    """The topic, if it is what somebody told the robot or may tell it."""
    return so.topic if so.topic in ORDERS else ""


def _says_nothing(build: Build, so: Said) -> bool:
    """ "Did you say": what is said is missing."""
    term = build.sketch.terms[so.inner or so.main]
    return "say" in term.lex and not {"obj", "dest"} & {role for role, _ in term.links}


def _topic(build: Build, so: Said) -> str:
    """What of the robot's own doings is asked about; where it is nothing of that sort, its act gets its agent."""
    if topic := _order_topic(so):
        return topic
    if so.own:
        topic = "did" if so.past else "doing" if so.going else so.topic.removeprefix("request")
    if so.own and not topic:
        by_robot(build, so.main)
    return topic


def asked_thing(build: Build, wh: AList) -> tuple[Ask, str, str]:
    """Question word, node wanted, and the thing in question; they differ in "whose cup"."""
    word = wh.slot("wh_word")
    described = tuple(part for part in wh if part.name in DESCRIBING)
    bare = len(wh.parts) == 1
    if (word in ("who", "whom") and described) or (bare and word not in BARE):
        raise NoMeaningError(str(wh))
    np = wh.find("np") or AList("np", described)
    if wh.has("np"):  # "which of the boxes" is which box
        np = AList("np", tuple(part for part in np if part.name != "det"))
    number = wh.slot("num")
    thing = build.thing(np) if np.parts else build.add("obj")
    if number:
        build.add("cnt", literal=number, cnt=thing)
    if word == "whose":
        owner = build.add("obj")
        build.add("own", own=thing, of=owner)
        return "who", owner, thing
    return ASKS[word], thing, thing


def subject(build: Build, body: AList) -> Question:
    """ "Who moved the ladder", "which cup belongs to Lucy", "how many cups are empty"."""
    ask, wanted, thing = asked_thing(build, body.first("wh"))
    so = drawn(build, body, thing)
    return Question(ask, build.graphlet(so.main), wanted, _order_topic(so))


def wanted(build: Build, body: AList) -> Question:
    """ "Which cup did you lift", "what are you afraid of", "how many degrees did you turn"."""
    wh = body.first("wh")
    asks = body.find("asks")
    if asks is None:  # "what room are you in"
        ask, wanted, thing = asked_thing(build, wh)
        return Question(ask, _there(build, body, body.slot("strand"), thing), wanted)
    if wh.has("unit"):
        return _amount(build, wh, asks)
    if (
        wh.slot("wh_word") == "what"
        and len(wh.parts) == 1
        and (done := _anything(build, body, asks))
    ):
        return done
    ask, wanted, thing = asked_thing(build, wh)
    if wh.slot("wh_word") == "how many" and len(wh.parts) == 1:
        raise NoMeaningError(str(wh))
    anybody = (asks.find("np") or YOU).slot("det") in ("a", "an")
    if anybody and asks.has("modal_q"):  # "how many roads must a man walk down"
        raise NoMeaningError(str(asks))
    so = drawn(build, asks)
    fill(build, so.inner or so.main, thing, body.slot("strand"), asks)
    topic = _topic(build, so)
    if topic == "doing" and build.sketch.terms[so.main].lex == {"hold"}:  # which is no deed
        by_robot(build, so.main)
        topic = ""
    counted = ask == "howmany" and topic == "did"
    return Question(ask, build.graphlet(so.main), "" if counted else wanted, topic)


def _there(build: Build, body: AList, word: str, mark: str) -> Graphlet:
    """What is asked about is in, on, under ... that."""
    return build.graphlet(
        build.add("loc", PLACES.get(word, word), loc=build.thing(body.first("np")), wrt=mark)
    )


def _anything(build: Build, body: AList, asks: AList) -> Question | None:
    """ "What did Tom do": the act itself is wanted."""
    commanding = asks.find("commanding")
    blank = any((commanding or asks).has(name) for name in ("do_it", "doing_it"))
    if not blank or body.has("strand"):
        return None
    so = drawn(build, asks)
    if not so.own and commanding is None:  # "what does a wrench do": what is known of it
        agent = dict(build.sketch.terms[so.main].links)["agt"]
        return Question("what", build.graphlet(agent), "", "know_about")
    topic = _topic(build, so)
    if (
        topic == "allowed"
        and asks.slot("bound") in SUPPOSED
        and not asks.has("neg")
        and not asks.has("negq")
    ):
        topic = "doing"
    if so.own and so.topic == "request":  # "what else can you do"
        if asks.has("neg") or asks.has("negq"):  # "what can't you do"
            return not_allowed(build)
        return Question("what", build.graphlet(so.main), "", "abilities")
    return Question("what", build.graphlet(so.main), so.inner, topic)


def _amount(build: Build, wh: AList, asks: AList) -> Question:
    so = drawn(build, asks)
    if wh.slot("wh_word") != "how many" or not so.inner:
        raise NoMeaningError(str(wh))
    amt = build.add("amt", wh.slot("unit"), amt=so.inner)
    topic = _topic(build, so)
    lasts = wh.slot("unit") in TIMES
    topic = ("lasting" if lasts else "extent") if topic == "did" else topic
    return Question("howmany", build.graphlet(so.main), amt, topic)


def fronted(build: Build, body: AList) -> Question:
    """ "On which shelf is the hammer", "to whom does the cup belong"."""
    ask, wanted, thing = asked_thing(build, body.first("wh"))
    front = body.slot("fronting")
    if (asks := body.find("asks")) is None:
        return Question(ask, _there(build, body, front, thing), wanted)
    so = drawn(build, asks)
    fill(build, so.inner or so.main, thing, front, asks)
    topic = _topic(build, so)
    return Question(ask, build.graphlet(so.main), wanted, topic)


def adverbial(build: Build, body: AList) -> Question:
    """ "Where did you put the cup", "when will you be done", "how long did Tom wait"."""
    wh, asks = body.first("wh_adv"), body.first("asks")
    word = wh.slot("wh_when")
    opinion = asks.slot("modal_q") == "would"
    if opinion and any(part.name == "speech" and part.has("quote") for part in asks.walk()):
        raise NoMeaningError(str(body))  # "how long would you say you've had it"
    so = drawn(build, asks)
    act = bool(so.inner)
    yours = (asks.find("np") or YOU).slot("pron") == "you"
    if word == "how" and yours and build.sketch.terms[so.main].lex & MENTAL:
        raise NoMeaningError("how do you like your eggs")
    if word == "where":
        return _where(build, so)
    how = wh.find("how_adv")
    lasting = how is not None and how.has("lasting")
    if lasting and so.own and so.topic in ABLE and wh.first("how_adv").slot("lasting") == SINCE:
        return Question("when", build.graphlet(so.main), "", "taught")
    ask: Ask = ASKS.get(word, "which") if word else "how"
    topic = "know_how" if word == "how" and so.own and act else _topic(build, so)
    if ask == "when" and so.own and topic in ("", "allowed"):
        topic = "occasion"
    much = how is not None and how.has("much")
    if much and not (so.own or asks.has("does_q")):  # "how much did the ticket set you back"
        raise NoMeaningError(str(body))
    if how is not None and not how.has("lasting") and build.sketch.terms[so.main].kind != "act":
        raise NoMeaningError(str(body))
    if how is not None and how.has("adv") and topic not in ("did", "doing", "know_how"):
        wanted = build.add("deg", deg=build.add("mod", how.slot("adv"), mod=so.main))
        return Question(ask, build.graphlet(so.main), wanted, topic)
    if lasting and topic == "" and not act:
        return Question("when", build.graphlet(so.main), "", "taught")
    if how is not None and topic == "did":
        topic = "lasting" if lasting else "extent"
    return Question(ask, build.graphlet(so.main), "", topic)


def _where(build: Build, so: Said) -> Question:
    """Where something was put is where it is now."""
    if build.sketch.terms[so.main].kind in ("loc", "ako"):  # "where is the cup on the table": which
        raise NoMeaningError("where is it there")
    topic = _topic(build, so)
    if topic == "doing":
        return Question("where", build.graphlet(so.main), "", topic)
    obj = next((other for role, other in build.sketch.terms[so.main].links if role == "obj"), "")
    if so.past and so.own and not obj:
        return Question("where", build.graphlet(so.main), "", "did")
    loc = build.add("loc", loc=obj if so.past and so.own else so.main)
    return Question("where", build.graphlet(loc), loc)


def what_for(build: Build, body: AList) -> Question:
    """ "What did you turn left for"; "what are you waiting for" asks for something else."""
    asks = body.first("asks")
    deed = asks.find(*DEEDS, *BLANK)
    if deed is None or not (deed.has("np") or deed.has("dir") or deed.name in BLANK):
        raise NoMeaningError(str(body))
    return replace(why(build, body), ask="what", topic="why")


def how_known(build: Build, body: AList) -> Question:
    """ "How do you know that Tim is tall": who said so."""
    return replace(why(build, body), ask="who", topic="taught")


def what_thinks(build: Build, body: AList) -> Question:
    """ "What makes you think the jar is heavy": who said so."""
    return replace(why(build, body), ask="what", topic="taught")


def cleft(build: Build, body: AList) -> Question:
    """ "Was it Tom who moved the box"."""
    clefted = body.first("clefted")
    who = build.thing(clefted.first("np"), person=True)
    so = drawn(build, AList("asks", tuple(part for part in body if part.name != "clefted")), who)
    return Question("yesno", build.graphlet(so.main), "", _order_topic(so))


def same_thing(build: Build, body: AList) -> Question:
    """ "Is this the box you dropped"."""
    thing, one = build.thing(body.first("np")), body.first("related")
    for qual in one.all("qual"):
        build.quality(thing, qual)
    if not (called := kind(one)):
        raise NoMeaningError(str(body))
    build.kind(thing, called, compounded(one))
    of_clause(build, one, thing)
    return Question("yesno", build.graphlet(thing))


def why(build: Build, body: AList) -> Question:
    """Why the robot did it, or why it is so."""
    asks = body.first("asks")
    so = drawn(build, asks)
    if so.own:
        return Question("why", build.graphlet(so.main), "", "did")
    return Question("why", build.graphlet(so.main), "", _order_topic(so) or "taught")
