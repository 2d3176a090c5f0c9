"""Questions by their construction: a question word, and the clause around it, of which that is a part.

"Which cup did Freddy tell you to lift" is the clause "Freddy told you to lift" and the cup that is missing in it.
"""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.mentions import PLACES
from grammars.pacing import TIMES
from grammars.questions.clause import DESCRIBING, YOU, Said, by_robot, drawn, order_topic, topic_of
from grammars.questions.gaps import fill
from grammars.questions.topics import not_allowed
from grammars.relatives import predicate
from grammars.remarks import MENTAL
from kernel.memory.meaning import Ask, Question
from kernel.net.graphlet import Graphlet

ASKS: Final[dict[str, Ask]] = {
    "who": "who", "whom": "who", "whose": "who", "what": "what", "which": "which",
    "how many": "howmany", "how much": "howmany", "how often": "howmany", "how many times": "howmany",
    "how many more": "howmany",
    "where": "where", "when": "when", "at what time": "when", "how": "how",
}  # fmt: skip
SUPPOSED: Final = ("supposed to", "meant to")
BARE: Final = ("who", "whom", "what", "which", "how many")  # that may stand alone
ABLE: Final = ("know_how", "allowed", "request")
SINCE: Final = "since when"


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
    return Question(ask, build.graphlet(so.main), wanted, order_topic(so))


def howmany(build: Build, body: AList) -> Question:
    """ "How many cups are there", "how many cups are on the table"."""
    ask, wanted, thing = asked_thing(build, body.first("wh"))
    if ask != "howmany":
        raise NoMeaningError(str(body))
    pred = body.find("pred")
    main = thing if pred is None else predicate(build, thing, pred, negated=False)
    return Question(ask, build.graphlet(main), wanted)


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
    topic = topic_of(build, so)
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
    topic = topic_of(build, so)
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
    topic = topic_of(build, so)
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
    topic = topic_of(build, so)
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
    topic = "know_how" if word == "how" and so.own and act else topic_of(build, so)
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
    topic = topic_of(build, so)
    if topic == "doing":
        return Question("where", build.graphlet(so.main), "", topic)
    obj = next((other for role, other in build.sketch.terms[so.main].links if role == "obj"), "")
    if so.past and so.own and not obj:
        return Question("where", build.graphlet(so.main), "", "did")
    loc = build.add("loc", loc=obj if so.past and so.own else so.main)
    return Question("where", build.graphlet(loc), loc)
