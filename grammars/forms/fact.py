"""Facts: what somebody says is so."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.comparing import regarding
from grammars.dates import dated
from grammars.happenings import happened
from grammars.hedges import belief, belief_of, hedge_of
from grammars.mentions import EVERY, OWNING, is_definite, is_person, may_be_person
from grammars.mutual import of_each
from grammars.registry import sentence_form
from grammars.remarks import check_absence, check_subject
from grammars.render.telling import SAYING
from grammars.restating import restated
from grammars.sorts import is_abstract, kind
from grammars.vocabulary import BORN
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
    "Lily knows how to swim",
)

NAMES: Final = ("name", "nickname", "surname")
DREADING: Final = ("afraid", "scared", "frightened", "terrified", "allergic", "fond")


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
    if (skilled := alist.find("skilled")) is not None:
        return _skilled(build, skilled)
    if (deed := alist.find("past_deed")) is not None:
        return happened(build, deed)
    if (feeling := alist.find("feeling")) is not None:  # "I'm hungry"
        if (dreading := feeling.find("dreading")) is not None:
            return _dreading(build, dreading)
        with build.drawing(pattern=False):
            hq = build.quality(build.oneself("me"), feeling, feeling.has("neg"))
            return Fact(build.graphlet(hq))
    if (day := alist.find("dated")) is not None:
        with build.drawing(pattern=False):
            told = build.graphlet(dated(build, day))
        return Fact(told, tuple(build.finds))
    mostly = alist.has("most_so")
    alist = restated(alist)
    said = _each_told(alist)
    for one in said:
        if _is_anybody(one):
            raise NoMeaningError("a rule")
        check_subject(one)
        check_absence(one)
        if hedge_of(one) and one.first("np").has("pron"):
            raise NoMeaningError("small talk")  # "you are probably right"
    with build.drawing(pattern=False):
        mains = [clause(build, one) for one in said]
        build.sketch.change(mains[0], belief=belief("most") if mostly else belief_of(said[0]))
        if (denied := alist.find("denied_so", "also_so")) is not None:
            mains.append(_but(build, mains[0], denied))
        told = build.graphlet(mains[0])
    return Fact(told, tuple(build.finds))


def _skilled(build: Build, skilled: AList) -> Fact:
    """ "Lily knows how to swim", and nobody how to live: what the robot has a word for, of somebody in particular."""
    who, action = skilled.first("np"), skilled.first("action")
    known = BORN.readings(action.slot("act")).keys() & {"VERB", "STATE"}
    if not known or not (who.has("name") or is_definite(who)) or who.has("pron"):
        raise NoMeaningError(str(skilled))
    with build.drawing(pattern=False):
        agent = build.thing(who, person=True)
        verb = skilled.slot("states") or skilled.slot("state")
        denied = skilled.has("neg")
        knows = build.add("act", verb, negated=denied, agt=agent, obj=build.action(action))
        return Fact(build.graphlet(knows), tuple(build.finds))


def _dreading(build: Build, dreading: AList) -> Fact:
    """ "I am afraid of dogs"."""
    if dreading.slot("hq") not in DREADING or is_abstract(dreading.first("np")):
        raise NoMeaningError(str(dreading))
    with build.drawing(pattern=False):
        hq = regarding(build, build.oneself("me"), dreading)
        return Fact(build.graphlet(hq), tuple(build.finds))


def _is_anybody(said: AList) -> bool:
    """ "Someone who is crying is sad": whoever it is."""
    np, pred = said.find("np"), said.find("pred")
    if np is None or not np.has("vague") or np.slot("vague") in EVERY:
        return False
    if any(rel.has("made_of") for rel in np.all("rel")):
        return True
    told_apart = any(not rel.has("loc") for rel in np.all("rel"))
    return told_apart and pred is not None and (pred.has("qual") or pred.has("kindof"))


def _each_told(alist: AList) -> list[AList]:
    """The clauses of a fact: of each of several subjects, of all that is told with "and"."""
    if (also := alist.find("also_so")) is not None:
        end = also.parts.index(also.first("pred")) + 1
        return [AList("clause", also.parts[:end])]
    if (denied := alist.find("denied_so")) is not None:
        *said, instead = denied.parts
        return [_only_denied(AList("clause", tuple(said)), instead)]
    said = alist.all("clause")
    if (so := alist.find("it_is_so")) is not None:
        if not said[0].has("neg"):  # two sentences
            raise NoMeaningError(str(alist))
        said = [_only_denied(said[0], so.first("pred")), AList("clause", so.parts)]
    return [each for one in said for each in of_each(one)]


def _only_denied(said: AList, instead: AList) -> AList:
    """ "It is not a big dog but a cat" denies the dog, "not a red cup but a blue cup" the color."""
    pred = said.find("pred")
    one, other = (None if part is None else part.find("kindof") for part in (pred, instead))
    if pred is None or one is None or other is None or kind(one) == kind(other):
        return said
    plain = AList("kindof", tuple(part for part in one if part.name != "qual"))
    return AList("clause", tuple(AList("pred", (plain,)) if p is pred else p for p in said))


def _but(build: Build, main: str, denied: AList) -> str:
    """ "It is not red but blue": what is said of the same thing after "but"."""
    links = build.sketch.terms[main].links
    thing = next(other for role, other in links if role in SAYING)
    negated = denied.name == "also_so" and denied.parts[-2].name == "neg"
    return clause(build, AList("clause", denied.parts[-2 if negated else -1 :]), thing)


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
            if (np := named.find("np")) is not None and np.slot("ako") in NAMES:
                raise NoMeaningError("the name of a name")
            if np is not None and np.has("pron") and "PLACE" in BORN.readings(named.slot("name")):
                raise NoMeaningError("it's Tuesday")
            thing = build.thing(named.first("np")) if owner is None else build.thing(owner)
    if not build.finds:
        raise NoMeaningError("a name for nothing in particular")
    word = named.all("name")[-1].value or ""
    return Fact(Graphlet((Term(thing, frozenset((word,))),), thing), tuple(build.finds))
