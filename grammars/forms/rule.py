"""Rules: what follows from what, and how surely."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.conditions import condition, exception, stated
from grammars.hedges import belief, hedge_of
from grammars.registry import sentence_form
from grammars.sorts import classes, kind
from grammars.vocabulary import BORN
from kernel.memory.lesson import Rule
from kernel.memory.meaning import Teach
from kernel.net.graphlet import Graphlet

EXAMPLES = (
    "If something is a girl it is a person.",
    "a girl is a person",
    "if something has wheels it is a vehicle",
    "heavy things are dangerous",
    "robins are not mammals",
    "Girls are usually female.",
    "If a person is from Brazil, he likely speaks Portuguese.",
    "big blocks are definitely heavy",
    "a cup is heavy if it is full",
)

NEVER: Final = "never"
# "A lot of people": so many, and no kind of thing.
MUCH: Final = ("lot", "bunch", "couple", "ton", "load", "number", "bit", "majority")


@sentence_form("rule", "rule", EXAMPLES)
def rule(alist: AList) -> Teach:
    """A rule whose condition is a clause or the subject of a generic sentence."""
    build = Build()
    generic, conclusion = alist.find("generic"), alist.find("conclusion")
    if (stuff := alist.find("stuff")) is not None:
        generic = _stuff(stuff, alist.first("pred"))
    if generic is not None and kind(generic) in MUCH:
        raise NoMeaningError("a lot of people")
    habit = alist.find("habit", "habit_s")
    if generic is not None and generic.has("akos") and habit is not None and habit.has("states"):
        raise NoMeaningError(str(alist))  # "actors hears bells"
    if generic is not None and _is_left_over(generic):
        raise NoMeaningError("what remains")
    if generic is not None and "one" in (generic.slot("ako"), generic.value):
        raise NoMeaningError("nobody in particular")
    if generic is not None:
        condition_, thing = _kind(build, generic)
        said = alist
    elif conclusion is not None:
        condition_, thing = _conditions(build, alist, conclusion)
        said = conclusion
    else:
        raise NoMeaningError(str(alist))
    parts = [part for part in (alist, generic, said) if part is not None]
    hedge = next(filter(None, map(hedge_of, parts)), "")
    with build.drawing(pattern=True):
        main = clause(build, said, thing)
        if hedge == NEVER:  # "dogs never bite"
            build.sketch.change(main, negated=True)
        then = build.graphlet(main)
    if _is_order(conclusion):
        raise NoMeaningError("what is to be done")
    if _is_small_talk(condition_, then):
        raise NoMeaningError("small talk")
    if generic is not None and all(term.negated for term in condition_ if term.links):
        raise NoMeaningError("nothing in particular")  # "anything that is not red is blue"
    if any(term.ref in ("he", "she", "they") for term in condition_) or _is_name(said):
        raise NoMeaningError("somebody in particular")
    pred = said.find("pred")
    if generic is not None and pred is not None and any(q.value for q in pred.all("qual")):
        raise NoMeaningError("of a quality that nobody taught")  # "diamonds are forever"
    if generic is not None and pred is not None and _is_proverb(pred):
        raise NoMeaningError("a proverb")
    if generic is not None and _same_said(condition_, then):
        raise NoMeaningError("what is done is done")
    described = condition_.names
    anybody = conclusion is not None and _is_anybody(conclusion.first("np", "base_np"))
    about = {n for n in then.mentioned if n.startswith("obj")}
    if not anybody and about.isdisjoint(condition_.mentioned):
        raise NoMeaningError("the conclusion is about something else")
    then = Graphlet(tuple(term for term in then if term.name not in described), then.main)
    rule_ = Rule(condition_, then, exception(build, alist), belief(hedge))
    return Teach("rule", rule_)


def _is_proverb(pred: AList) -> bool:
    """ "Dogs are a man's best friend": somebody's, and nobody's in particular."""
    kinds = pred.all("kindof")
    owners = [owner for kindof in kinds for owner in kindof.all("owner", "np")]
    return any(owner.slot("det") in ("a", "an") for owner in owners)


def _stuff(stuff: AList, pred: AList) -> AList:
    """ "Soup is hot" is said of a stuff, "cup is hot" of nothing."""
    passing = any(qual.slot("hq") in classes()["placed"] for qual in pred.all("qual"))
    whose = any(part.name in ("own", "owner", "np") for part in pred.walk())
    if passing or whose or stuff.value not in classes()["mass"]:
        raise NoMeaningError(str(stuff))  # "food is ready", "music is my life"
    return AList("generic", (AList("ako", value=stuff.value),))


def _is_left_over(generic: AList) -> bool:
    """ "What is left is right"."""
    bare = all(part.name == "qual" for part in generic)
    return bare and any("DIR" in BORN.readings(qual.slot("hq")) for qual in generic)


def _is_anybody(np: AList) -> bool:
    """ "Somebody is cooking" may follow from what is about no person."""
    return np.has("vague") or (np.slot("det") == "a" and np.slot("ako") == "person")


def _is_order(conclusion: AList | None) -> bool:
    """ "If you see a cat, you stop": a reaction."""
    if conclusion is None or not (conclusion.has("habit") or conclusion.has("habit_s")):
        return False
    told = any(conclusion.has(part) for part in ("hedge", "neg", "may"))
    return not told and conclusion.first("np", "base_np").slot("pron") == "you"


def _is_small_talk(condition_: Graphlet, then: Graphlet) -> bool:
    """It is about the two who talk and what they see: "if you are reading this I love you"."""
    said = {name for name in condition_.mentioned | then.mentioned if name.startswith("obj")}
    robot, here = (
        {term.name for term in (*condition_, *then) if term.lex & lex or term.ref in refs}
        for lex, refs in (({"you"}, ()), ({"you", "me"}, ("this", "that")))
    )
    return said <= here and not said <= robot


def _same_said(one: Graphlet, other: Graphlet) -> bool:
    return {(t.kind, t.lex) for t in one} >= {(t.kind, t.lex) for t in other}


def _conditions(build: Build, alist: AList, conclusion: AList) -> tuple[Graphlet, str]:
    """What must be so, and the subject of a conclusion that stands before it: "a cup is heavy if it is full"."""
    conds, subject = alist.first("conds"), conclusion.find("np", "base_np")
    first = next(part for part in alist if part in (conds, conclusion))
    if first is conds or subject is None or subject.has("pron") or subject.has("name"):
        return condition(build, conds), ""
    with build.drawing(pattern=True):
        build.topic = thing = build.thing(subject)
        if build.negative:
            raise NoMeaningError("nothing in particular")
        described = {*build.board}
        must = stated(build, conds)
        new = [term for term in must if term.name not in described]
        if not any(thing == other for term in new for _, other in term.links):
            raise NoMeaningError("the condition is about something else")
        return must, thing


def _is_name(said: AList) -> bool:
    """What is said is somebody's name, and such names follow from nothing; "French" may."""
    pred = said.find("pred")
    called = pred.find("isname") if pred is not None else None
    return called is not None and "PLACE" not in BORN.readings(called.slot("name"))


def _kind(build: Build, generic: AList) -> tuple[Graphlet, str]:
    """The subject of a generic sentence as a condition: of what kind, else of what quality."""
    with build.drawing(pattern=True):
        thing = build.thing(AList("np", generic.parts or (AList("akos", value=generic.value),)))
        said = [build.sketch.terms[name] for name in build.board]
        vague = generic.has("vague")  # "whoever is crying": what tells him apart is the condition
        for role in ("agt", "hq", "ako", "loc") if vague else ("ako", "hq", "loc", "agt", "obj"):
            for term in said:
                if (role, thing) in term.links:
                    return build.graphlet(term.name), thing
    raise NoMeaningError(str(generic))
