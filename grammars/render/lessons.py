"""Operators, rules and facts as the sentences that teach them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from grammars.hedges import BELIEF, PREFERENCE
from grammars.morphology import plural
from grammars.render.alike import either
from grammars.render.clauses import conditions, naming
from grammars.render.operators import Wording, ways_out, worded
from grammars.render.telling import SAYING, Telling, Voice, is_predicate, linked, word
from grammars.render.things import thing
from grammars.vocabulary import BORN
from kernel.memory.lesson import Operator, Rule
from kernel.net.graphlet import Graphlet, Term

# By what a deed is narrowed down, in the order of forms/permission.py.
NARROWING: Final = ("mod", "amt", "cnt", "loc", "dest", "obj", "dir")
CHOOSING: Final = ("DO", "FIND", "CHK", "ACH")  # of several operators one is chosen
_HEDGES: Final = {value: words for words, value in reversed(BELIEF.items())} | {1.0: ""}


def hedge(belief: float) -> str:
    """The adverb for a belief; of an adapted one the nearest."""
    return _HEDGES[min(_HEDGES, key=lambda known: abs(known - belief))]


def taught(contents: tuple[Operator | Rule, ...], voice: Voice) -> str:
    """The sentence that teaches one lesson, or several that differ in one place: "never touch the cup or the mug"."""
    said = [
        worded(content, voice) if isinstance(content, Operator) else _rule(content, voice)
        for content in contents
    ]
    first, *others = said
    if len(contents) == 2 and _is_only(*contents):
        return str(replace(first, lead=f"{first.lead} only"))
    if others and first.lead not in {one.lead for one in others}:
        # "you may touch this, but never that"
        return ", but ".join(map(str, said))
    differing = [
        name
        for name in ("about", "given", "rest")
        if any(getattr(one, name) != getattr(first, name) for one in others)
    ]
    if not differing:
        return str(first)
    ways = [isinstance(one, Operator) and one.trigger.tag in CHOOSING for one in contents]
    if differing == ["rest"] and all(ways):  # "to celebrate, turn around or sing"
        return str(first) + "".join(f" or {_without_lead(one.rest)}" for one in others)
    if len(contents) == 2 and _is_contrary(*contents):
        return f"{first}, otherwise {_without_lead(others[0].rest)}"
    if len(differing) > 1 or differing == ["rest"]:
        return ", and ".join(map(str, said))
    name = differing[0]
    return str(replace(first, **{name: either([getattr(one, name) for one in said])}))


def _is_contrary(one: Operator | Rule, other: Operator | Rule) -> bool:
    """The second is in force just where the first is not: what the one notes the other denies."""
    if not (isinstance(one, Operator) and isinstance(other, Operator)):
        return False
    if one.trigger.tag != "NOTE" or other.trigger.tag != "NOTE":
        return False
    so, not_so = one.trigger.graphlet, other.trigger.graphlet
    if so is None or not_so is None or so.head is None:
        return False
    turned = replace(so.head, negated=not so.head.negated)
    return {turned if term is so.head else term for term in so} == set(not_so)


def _is_only(one: Operator | Rule, other: Operator | Rule) -> bool:
    """The second forbids what the first allows in general: "you may only touch the red block"."""
    if not (isinstance(one, Operator) and isinstance(other, Operator)):
        return False
    may, never = one.trigger.graphlet, other.trigger.graphlet
    if (one.trigger.tag, other.trigger.tag) != ("ALLOW", "ANTE") or may is None or never is None:
        return False
    if other.enablement or other.unless or len(other.chain.plays) > 1:
        return False
    narrow = next((role for role in NARROWING if _narrowed(may, role)), "")
    left = [role for role in NARROWING if role != narrow]
    same = all(_narrowed(may, role) == _narrowed(never, role) for role in left)
    return bool(narrow) and same and _words(may) == _words(never) and not _narrowed(never, narrow)


def _words(graphlet: Graphlet) -> frozenset[str]:
    """Of the deed."""
    return graphlet.head.lex if graphlet.head is not None else frozenset()


def _narrowed(graphlet: Graphlet, role: str) -> list[str]:
    """What a deed is narrowed down by in that role, in the words that tell of it."""
    if role in ("obj", "dest"):
        name = linked(graphlet.head, role) if graphlet.head is not None else ""
        return sorted(
            word(t)
            for t in graphlet
            if name and name in {t.name, *dict(t.links).values()} and t.name != graphlet.main
        )
    return sorted(word(t) for t in graphlet if linked(t, role) == graphlet.main)


def _without_lead(rest: str) -> str:
    """What is to be done, without "you could"."""
    words = rest.removeprefix(", ").split(" ")
    while words[0] in ("you", "I", "will", "always", *PREFERENCE):
        del words[0]
    return " ".join(words)


def _rule(content: Rule, voice: Voice) -> Wording:
    condition, conclusion = content.condition, content.conclusion
    if content.is_alias:
        meant = word(conclusion.terms[0])
        the = "the " if " " in meant and "NOUN" in BORN.readings(meant.rpartition(" ")[2]) else ""
        return Wording("", f"{word(condition.terms[0])} means", "", f" {the}{meant}")
    telling = Telling((condition,), (conclusion, *content.unless), voice)
    about = conditions(telling, condition)
    said = conditions(telling, conclusion, hedge(content.belief))
    return Wording("if", about, "", f", {said}{ways_out(telling, content.unless)}")


def generic(content: Rule) -> str:
    """A rule from one kind to a kind or quality in few words, "girls are usually female"; "" for others."""
    left, right = content.condition.terms, content.conclusion.terms
    if content.unless or len(left) != 1 or len(right) != 1:
        return ""
    of, said = left[0], right[0]
    roles = {role for role, _ in said.links}
    if (
        not linked(of, "ako")
        or of.negated
        or not roles <= {"ako", "hq"}
        or of.links[0][1] != said.links[0][1]
    ):
        return ""
    adverb = hedge(content.belief)
    denied = "not" if said.negated else ""
    what = plural(word(said)) if "ako" in roles else word(said)
    return " ".join(filter(None, (plural(word(of)), "are", denied, adverb, what)))


def fact(content: Graphlet, finds: tuple[Graphlet, ...], voice: Voice) -> str:
    """The sentence that tells a fact about the things looked up."""
    main = content.head
    if main and not finds and len(content.terms) > 1 and not is_predicate(main):
        content, finds = _named(content, main)
    subjects = [other for role, other in main.links if role in SAYING] if main else []
    if main and subjects and not _is_nobody(content) and _is_new(content, finds, subjects[0]):
        told = content.denied() if main.negated else content
        telling = Telling((*finds, told), (), voice)
        are = "are" if telling.several(subjects[0]) else "is"
        said = thing(telling, subjects[0])
        first = f"there {are} {f'no {_bare(said)}' if main.negated else said}"
        return " and ".join((first, *_there_too(telling, content, finds)))
    belief = main.belief if main else 1.0
    if main and not is_predicate(main):
        return str(naming(Telling(finds, (content,), voice), main, told=True))
    telling = Telling(finds, (content,), voice)
    if belief == BELIEF["most"] and any(map(telling.several, subjects)):
        return f"most of {conditions(telling, content)}"
    return conditions(
        telling, content, "possibly" if belief == BELIEF["possibly"] else hedge(belief)
    )


def _there_too(telling: Telling, content: Graphlet, finds: tuple[Graphlet, ...]) -> Iterator[str]:
    """What else there is: "there is a cup on the table and there is a plate on the table"."""
    for term in content:
        name = next((other for role, other in term.links if role in SAYING), "")
        new = name and term.name not in telling.stated and name not in telling.mentioned
        if new and _is_new(content, finds, name):
            yield f"there {'are' if telling.several(name) else 'is'} {thing(telling, name)}"


def _is_nobody(content: Graphlet) -> bool:
    """What is denied of every person: "nobody is hungry"."""
    main, *more = (content.head, *(term for term in content if term is not content.head))
    persons = [term for term in more if word(term) == "person" and linked(term, "ako")]
    return main is not None and main.negated and more == persons


def _bare(phrase: str) -> str:
    """The noun phrase without its article."""
    return phrase.removeprefix("an ").removeprefix("a ")


def _named(content: Graphlet, main: Term) -> tuple[Graphlet, tuple[Graphlet, ...]]:
    """A name, and what was given it, which are kept as one."""
    others = tuple(term for term in content.terms if term is not main)
    described = Graphlet((replace(main, lex=frozenset()), *others), main.name)
    return Graphlet((replace(main, ref=""),), main.name), (described,)


def _is_new(content: Graphlet, finds: tuple[Graphlet, ...], name: str) -> bool:
    """A thing of some kind that was not known before: "a red block"."""
    told = Telling((content,))
    found = any(find.main == name for find in finds)
    named = told.term(name).lex or told.term(name).ref or told.about(name, "own")
    return bool(told.about(name, "ako")) and not found and not named
