"""Facts: what somebody says is so."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.manners import NOT_TOO
from grammars.mentions import EVERY, OWNING, is_definite, is_person, is_time, may_be_person
from grammars.registry import sentence_form
from grammars.render.telling import SAYING
from grammars.sorts import is_abstract
from grammars.vocabulary import BORN, set_phrases
from kernel.memory.meaning import Fact
from kernel.net.graphlet import Graphlet, Term

EXAMPLES = (
    "Mary is a girl",
    "There is something very close.",
    "The bottle to the left of the green box is Advil.",
    "her name is janey",
    "this block is called pookie",
    "john is taller than mary",
    "Freddy is Janey's brother.",
    "the blue cup is john's",
    "Mary has a red hat.",
    "the blue block is not heavy",
    "the ball is behind you",
    "I'm very tired",
)

# What somebody does without ever being at it; such a saying is no deed that could be watched.
STATIVE: Final = frozenset(
    "know like love hate want need own prefer fear see mean get take".split()
)
PARTS: Final = "end start beginning point way case thing last limit".split()
PAST: Final = "past"  # it was done, and is no habit
STANDING: Final = ("stand", "lie", "sit", "hang", "lean", "rest", "live", "wait", "sleep", "float")
IT: Final = ("it", "that", "this")
LONGEST_QUOTE: Final = 6  # words somebody is told to have said; at more length it is gossip


@sentence_form("fact", "fact", EXAMPLES)
def fact(alist: AList) -> Fact:
    """The predicate with what is new in it; what is known already is looked up."""
    build = Build(telling=True)
    named = alist.find("named")
    if named is not None:
        return _named(build, named)
    if (taught := alist.find("taught_it")) is not None:
        with build.drawing(pattern=True):
            act = build.action(taught.first("action"))
            if not is_person(taught.first("np")) and not may_be_person(taught.first("np")):
                raise NoMeaningError("nobody who could tell")
            teller = build.thing(taught.first("np"), person=True)
            main = build.add("act", "teach", agt=teller, dest=build.oneself("you"), cmd=act)
            return Fact(build.graphlet(main))
    if (deed := alist.find("past_deed")) is not None:
        return _past_deed(build, deed)
    if (feeling := alist.find("feeling")) is not None:  # "I'm hungry"
        with build.drawing(pattern=False):
            hq = build.quality(build.oneself("me"), feeling, feeling.has("neg"))
            return Fact(build.graphlet(hq))
    if (pointed_out := alist.find("pointed_out")) is not None:
        if pointed_out.first("pred").first("kindof").slot("ako") in PARTS:
            raise NoMeaningError("this is the end")
        alist = AList(alist.name, (AList("clause", pointed_out.parts),))
    if (placed := alist.find("placed")) is not None:
        alist = AList(alist.name, (_placed(placed),))
    if (introduced := alist.find("introduced")) is not None:  # "this is my brother Tom"
        kindof = AList("kindof", tuple(p for p in introduced if p.name not in ("np", "name")))
        who = AList("np", tuple(introduced.all("name")))
        alist = AList(alist.name, (AList("clause", (who, AList("pred", (kindof,)))),))
    said = _each_told(alist)
    for one in said:
        _check_subject(one)
        _check_absence(one)
    with build.drawing(pattern=False):
        mains = [clause(build, one) for one in said]
        if (denied := alist.find("denied_so")) is not None:
            mains.append(_but(build, mains[0], denied))
        told = build.graphlet(mains[0])
    return Fact(told, tuple(build.finds))


def _each_told(alist: AList) -> list[AList]:
    """The clauses of a fact: of each of several subjects, of all that is told with "and"."""
    if (denied := alist.find("denied_so")) is not None:
        return [AList("clause", denied.parts[:-1])]
    said = alist.all("clause")
    if alist.has("it_is_so") and not said[0].has("neg"):  # two sentences
        raise NoMeaningError(str(alist))
    said += (AList("clause", part.parts) for part in alist.all("it_is_so"))
    return [each for one in said for each in _of_each(one)]


def _of_each(said: AList) -> list[AList]:
    """The same clause with each of several things: "Ann and Bob are tall"."""
    if (both := said.find("both_of", "several_np")) is None:
        return [said]
    at = said.parts.index(both)
    return [AList("clause", (*said.parts[:at], np, *said.parts[at + 1 :])) for np in both.all("np")]


def _but(build: Build, main: str, denied: AList) -> str:
    """ "It is not red but blue": what is said of the same thing after "but"."""
    links = build.sketch.terms[main].links
    thing = next(other for role, other in links if role in SAYING)
    return clause(build, AList("clause", denied.parts[-1:]), thing)


def _placed(placed: AList) -> AList:
    """ "On the shelf stands a vase" is "there is a vase on the shelf"; "on it is the vase" is "the vase is on it"."""
    stands = placed.find("stands")
    if stands is not None and stands.value not in STANDING:
        raise NoMeaningError(str(placed))
    place = placed.find("loc")
    if place is not None and any(map(is_abstract, place.all("np"))):
        raise NoMeaningError("in a mood")
    if (counted := placed.find("counted")) is not None:
        there = AList("counted", (*counted.parts, AList("rel", (placed.first("loc"),))))
        return AList("clause", (AList("exists", (there,)),))
    thing = placed.first("np")
    if place is None or is_time(place):
        if place is not None or not thing.all("rel"):
            raise NoMeaningError(str(placed))
        return AList("clause", (AList("exists", (thing,)),))
    if is_definite(thing):
        return AList("clause", (thing, AList("pred", (place,))))
    if thing.slot("det") not in ("a", "an", "some", "another", "no") and not thing.has("vague"):
        raise NoMeaningError(str(placed))
    there = AList("np", (*thing.parts, AList("rel", (place,))))
    return AList("clause", (AList("exists", (there,)),))


def _past_deed(build: Build, deed: AList) -> Fact:
    """What somebody did: "Rick grabbed the ball", "the ball was grabbed by Rick"."""
    done = deed.find("did_it", "action") or AList("action", deed.parts)
    if deed.has("np"):
        _check_subject(deed)
    with build.drawing(pattern=False):
        agent = build.thing(AList("np", tuple(deed.all("name"))), person=True)
        act = build.action(done)
        build.sketch.link(act, "agt", agent)
        build.add("mod", PAST, mod=act)
        build.sketch.change(act, negated=deed.has("neg"))
        told = build.graphlet(act)
    return Fact(told, tuple(build.finds))


def _check_absence(said: AList) -> None:
    """What there is none of, there is none of somewhere: "there is no milk in the fridge", but no free lunch at all."""
    exists = said.find("exists")
    thing = exists.find("np") if exists is not None else None
    if exists is None or thing is None or not (exists.has("neg") or thing.slot("det") == "no"):
        return
    places = [loc for rel in thing.all("rel") for loc in rel.all("loc")]
    if not any(is_definite(np) for loc in places for np in loc.all("np")):
        raise NoMeaningError(str(said))


def _check_subject(said: AList) -> None:
    """Refuse subjects of generic sentences and of small talk: "a girl", "girls", "I"; and what was said at length."""
    if len(said.slot("quote").split()) > LONGEST_QUOTE:
        raise NoMeaningError("gossip")
    pred = said.find("pred")
    if pred is not None and pred.has("isname"):
        raise NoMeaningError("a name; read as such")
    loc = None if pred is None else pred.find("loc")
    if loc is not None and any(map(is_abstract, loc.all("np"))):
        raise NoMeaningError("in a mood, under the weather")
    subject = said.find("np", "base_np")
    if subject is None:
        return
    if said.has("quote") and subject.has("pron"):  # "he said stop and I stopped"
        raise NoMeaningError("gossip")
    if subject.slot("vague") in EVERY and pred is not None and _is_judged(pred):
        raise NoMeaningError("everything is fine")
    if subject.slot("vague") == "everything" and (subject.has("rel") or said.has("does")):
        raise NoMeaningError("a rule; and everything happens for a reason")
    if subject.has("pron") and _is_remark(said, subject.slot("pron")):
        raise NoMeaningError("a remark")
    known = ("name", "det", "own", "owner", "pron", "vague")
    vague = subject.slot("vague")
    there = _stands_somewhere(said)
    generic = (
        not any(subject.has(part) for part in known)
        or (subject.slot("det") in ("a", "an") and not there)
        or subject.slot("det") in ("any", "no")
        or vague.startswith(("any", "who"))
        or subject.slot("ako") == "name"
        or (vague and pred is not None and pred.has("kindof"))
    )
    if generic or subject.slot("pron") in ("i", "me") or _is_saying(said, subject):
        raise NoMeaningError(str(said))


def _stands_somewhere(said: AList) -> bool:
    """ "A person is standing behind you" tells of one that is there now."""
    doing = said.find("going") or said
    place = doing.find("place")
    stands = doing.slot("gerund") or doing.slot("does")
    return (
        stands in STANDING
        and place is not None
        and any(loc.has("prep") for loc in place.all("loc"))
    )


def _is_remark(said: AList, pron: str) -> bool:
    """ "It's a small world", "that is a good question"; "it is raining", "you are hopeless" in a word nobody taught."""
    pred, going = said.find("pred"), said.find("going")
    if going is not None:
        verb = going.slot("gerund") or going.value or ""
        return BORN.readings(verb).keys().isdisjoint(("VERB", "STATE"))
    if pred is None:
        return False
    kindof, qual = pred.find("kindof"), pred.find("qual")
    if pron == "you" and kindof is not None and _is_judged(kindof):
        return True
    told_kind = pron in IT and kindof is not None and is_abstract(kindof)
    return told_kind or (qual is not None and (qual.value is not None or _is_verdict(pron, qual)))


def _is_verdict(pron: str, qual: AList) -> bool:
    """ "That's too loud": of what was done, as no thing is too fast."""
    way = qual.slot("hq")
    too = any(deg.value == "too" for deg in qual.all("deg"))
    return too and pron in IT and not NOT_TOO.keys().isdisjoint((way, f"{way}ly"))


def _is_judged(kindof: AList) -> bool:
    """ "You are a bad, bad boy": praise and blame."""
    said = {qual.slot("hq") or qual.value for qual in kindof.all("qual")}
    return not said.isdisjoint((*set_phrases()["GOOD"], *set_phrases()["BAD"]))


def _is_saying(said: AList, subject: AList) -> bool:
    """What somebody that only a pronoun tells of does to a thing that nothing is said of: "he knows the ropes"; and of
    the robot also to any such thing, as it knows best what it sees and likes: "you need a break"."""
    things = said.all("np")[1:]
    if said.slot("does") == "know":  # "Rick knows the drill"
        return any(thing.slot("det") == "the" and _is_bare(thing) for thing in things)
    if said.slot("does") not in STATIVE or not subject.has("pron"):
        return False
    kinds = ("the",) if subject.slot("pron") != "you" else ("the", "a", "an", "")
    return any(thing.slot("det") in kinds and _is_bare(thing) for thing in things)


def _is_bare(thing: AList) -> bool:
    return all(part.name in ("det", "ako", "akos") for part in thing)


def _named(build: Build, named: AList) -> Fact:
    """The name is a lexical item of the thing's own node, as in the paper's figures."""
    with build.drawing(pattern=False):
        whose = named.find("own_name")
        if whose is not None:
            own = whose.slot("own")
            if own not in OWNING:
                raise NoMeaningError("a name of the speaker or of the robot")
            thing = build.pronoun(OWNING[own])
        else:
            owner = named.find("owner")
            if (np := named.find("np")) is not None and np.slot("ako") == "name":
                raise NoMeaningError("the name of a name")
            if np is not None and np.has("pron") and "PLACE" in BORN.readings(named.slot("name")):
                raise NoMeaningError("it's Tuesday")
            thing = build.thing(named.first("np")) if owner is None else build.thing(owner)
    if not build.finds:
        raise NoMeaningError("a name for nothing in particular")
    word = named.all("name")[-1].value or ""
    return Fact(Graphlet((Term(thing, frozenset((word,))),), thing), tuple(build.finds))
