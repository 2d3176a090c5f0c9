"""Noun phrases: things by pronoun, name or description."""

from __future__ import annotations

from typing import Final

from grammars.manners import MORE_THAN_ONE, so_many
from grammars.morphology import article, comparative, gerund, past, plural, third_person
from grammars.render.names import CASES, PRONOUNS, Case, again, pronoun, proper
from grammars.render.qualities import degree, is_material, measured, much, quality
from grammars.render.telling import GROUPS, Telling, linked, word
from grammars.sorts import classes
from grammars.usage import BEHIND
from grammars.vocabulary import BORN
from kernel.net.graphlet import Term

_DETERMINERS: Final = frozenset("the this that these those every any all each some".split())
_PERSONS: Final = {"every": "everybody", "some": "somebody"}
_ABSOLUTE: Final = {"my": "mine", "your": "yours", "her": "hers", "their": "theirs", "our": "ours"}
_BE: Final = {"I": "am", "you": "are"}
_AT_HOME: Final = {f"a {where}": where for where in ("home", "school", "church", "work")}
# What one is doing still, and what one does all the time, where that tells which thing is meant.
_MEASURING: Final = ("weigh", "cost")
_ONGOING: Final = ("hold", "carry", "wear", "watch")
_FELT: Final = tuple("see hear want like love need have know own hate prefer mean smell".split())


def thing(telling: Telling, name: str, case: Case = "object") -> str:
    """The noun phrase for a node: the second time it is spoken of, a pronoun where only one thing can be meant."""
    if name == telling.gap:
        return ""
    if others := telling.also.pop(name, []):
        return " and ".join(thing(telling, each, case) for each in (name, *others))
    term = telling.term(name)
    if person := term.lex & {"you", "me"}:  # the speaker may have a name as well
        return pronoun(telling, min(person), case)
    if name in telling.mentioned:
        phrase = again(telling, term)
    else:
        kinds = [word(t) for t in telling.about(name, "ako") if not t.negated]
        phrase = _first(telling, term)
        telling.mention(name, "" if term.lex else next(iter(kinds), ""))
    if phrase in PRONOUNS:
        return PRONOUNS[phrase][CASES.index(case)]
    return f"{phrase}'s" if case == "possessive" else phrase


def owned(telling: Telling, own: Term) -> str:
    """Whose something is, as it is said after "is": mine, Mary's."""
    owner = thing(telling, linked(own, "of"), "possessive")
    return _ABSOLUTE.get(owner, owner)


def alike(telling: Telling, term: Term) -> str:
    """As big as the ball; the same size as the ball."""
    other = thing(telling, linked(term, "as"))
    if term.lex != {"same"}:
        return f"as {word(term)} as {other}"
    sort = [kind(telling, of) for of in telling.take(term.name, "ako")]
    return " ".join(("the same", *sort, "as", other))


def kind(telling: Telling, term: Term) -> str:
    """A kind with what it is compounded of: cereal box."""
    return " ".join([*(word(sub) for sub in telling.take(term.name, "sub")), word(term)])


def place(telling: Telling, term: Term) -> str:
    """Where: next to the wall; between two things; on the left."""
    landmarks = [thing(telling, other) for role, other in term.links if role == "wrt"]
    far = [measured(amt.literal or "1", word(amt)) for amt in telling.take(term.name, "amt")]
    if word(term) == "at":
        landmarks = [_AT_HOME.get(mark, mark) for mark in landmarks]
    if landmarks and word(term) == "within":
        return f"within {' '.join(far)} of {' and '.join(landmarks)}"
    if landmarks:
        return " ".join((*far, word(term), " and ".join(landmarks)))
    whole = " " in word(term) or word(term) in classes()["storeys"]
    return word(term) if whole else f"on the {word(term)}"


def described(telling: Telling, name: str) -> bool:
    """True where a noun phrase would say more of it than "something"."""
    return bool(telling.term(name).lex or telling.about(name, "ako", "hq", "loc", "own"))


def description(telling: Telling, name: str, noun: str) -> tuple[str, str, str]:
    """Words before the noun, the noun, and words after it; consumes what is told.

    Args:
        telling: the state.
        name: the thing.
        noun: what to say where no kind is given.
    """
    kinds = [t for t in telling.about(name, "ako") if not t.negated]
    telling.hold_back(kinds)
    plain, after, denied = [], list[str](), list[str]()
    for term in telling.take(name, "hq"):
        other = linked(term, "than")
        if term.negated:
            denied.append(quality(telling, term))
        elif regards := telling.take(term.name, "loc"):  # "closest to you"
            words = [quality(telling, term), *(place(telling, about) for about in regards)]
            after.append(f"that is {' '.join(words)}")
        elif linked(term, "as"):
            after.append(f"that is {alike(telling, term)}")
        elif other:
            after.append(f"that is {comparative(word(term))} than {thing(telling, other)}")
        elif is_material(term) or (word(term) in BEHIND and not telling.about(term.name, "deg")):
            after.append(f"that is {quality(telling, term)}")
        else:
            plain.append(quality(telling, term))
    if denied:
        after.insert(0, f"that is not {' or '.join(denied)}")
    for term in telling.take(name, "loc"):
        after.append(
            f"that is not {place(telling, term)}" if term.negated else place(telling, term)
        )
    for term in telling.take(name, "ako"):
        owners = [linked(own, "of") for own in telling.take(name, "own")]
        whose = thing(telling, owners[0], "possessive") if owners else ""
        said = f"{whose} {kind(telling, term)}" if whose else with_kind(telling, term)
        after.append(f"that is not {said}")
    after += [
        f"that is not {owned(telling, own)}" for own in telling.take(name, "own") if own.negated
    ]
    after += [_done_to(telling, term, name) for term in _doings(telling, name)]
    after += [_done_there(telling, loc) for loc in _places_of(telling, name)]
    after += [_at_it(telling, term) for term in _own_doings(telling, name)]
    nouns = [kind(telling, term) for term in kinds] or [noun]
    return " ".join(plain), nouns[0], " ".join([*(f"that is a {n}" for n in nouns[1:]), *after])


def _places_of(telling: Telling, name: str) -> list[Term]:
    """What is there or was done there, where that says which thing is meant: "the box the cat is in"."""
    found = [loc for loc in telling.about(name, "wrt") if telling.is_of(name, loc.name)]
    telling.hold_back(found)
    return found


def _done_there(telling: Telling, loc: Term) -> str:
    """ "Tom sat on", "the cat is in"."""
    act = telling.term(linked(loc, "loc"))
    if act.kind != "act":
        who = thing(telling, act.name, "subject")
        return f"{who} {_BE.get(who, 'is')} {word(loc)}"
    telling.hold_back([act])
    return f"{_done_to(telling, act, '')} {word(loc)}"


def _done_to(telling: Telling, term: Term, gap: str) -> str:
    """ "You are holding", "Mary gave me", "I put on the table": the thing itself is missing."""
    who, verb = thing(telling, linked(term, "agt"), "subject"), word(term)
    if verb in _ONGOING:
        does = f"{_BE.get(who, 'is')} {gerund(verb)}"
    elif verb in _FELT:
        stated = verb if who in _BE else third_person(verb)
        does = f"{'do' if who in _BE else 'does'} not {verb}" if term.negated else stated
    else:
        does = f"did not {verb}" if term.negated else past(verb)
    obj = linked(term, "obj")
    what = thing(telling, obj) if obj and obj != gap else ""
    dest = thing(telling, linked(term, "dest")) if linked(term, "dest") else ""
    where = [place(telling, loc) for loc in telling.take(term.name, "loc")]
    return " ".join(filter(None, (who, does, what, dest, *where)))


def _doings(telling: Telling, name: str) -> list[Term]:
    """What somebody does to the thing, where that says which one: "the block you are holding", "the cup Mary has"."""
    found = [
        term
        for term in telling.about(name, "obj")
        if linked(term, "agt") and not telling.is_main(term.name)
        if telling.term(linked(term, "agt")).lex or telling.is_main(name)
    ]
    telling.hold_back(found)
    return found


def _own_doings(telling: Telling, name: str) -> list[Term]:
    """What the thing itself does, where that says which one and can be said in a word or two."""
    found = [
        term
        for term in telling.about(name, "agt")
        if {role for role, _ in term.links} <= {"agt", "obj"}
        and not telling.is_main(term.name)
        and not any(
            term.name in {o for r, o in other.links if r not in ("dir", "mod", "amt")}
            for other in telling.terms.values()
        )
    ]
    telling.hold_back(found)
    return found


def _at_it(telling: Telling, term: Term) -> str:
    """ "That is holding a cup", "that has a wheel"."""
    known = BORN.readings(word(term))
    stays = ("STATE" in known and "VERB" not in known) or word(term) in _MEASURING
    verb = third_person(word(term)) if stays else f"is {gerund(word(term))}"
    verb = f"does not {word(term)}" if term.negated else verb
    what = thing(telling, linked(term, "obj")) if linked(term, "obj") else ""
    ways = [word(way) for way in telling.take(term.name, "dir")]
    ways += [degree(telling, how.name) + word(how) for how in telling.take(term.name, "mod")]
    ways += map(much, telling.take(term.name, "amt"))
    return " ".join(filter(None, ("that", verb, what, *ways)))


def with_kind(telling: Telling, term: Term) -> str:
    """A kind behind its article."""
    noun = kind(telling, term)
    return f"{article(noun)} {noun}"


def _relation(telling: Telling, name: str) -> str:
    """ "My brother" before the name of one who is told apart so."""
    told_apart = [
        term for term in telling.about(name, "own", "ako") if telling.is_of(name, term.name)
    ]
    if {term.kind for term in told_apart} != {"own", "ako"}:
        return ""
    whose = thing(telling, linked(telling.take(name, "own")[0], "of"), "possessive")
    return f"{whose} {kind(telling, telling.take(name, 'ako')[0])} "


def _first(telling: Telling, term: Term) -> str:
    name, ref = term.name, term.ref
    if term.lex:
        return _relation(telling, name) + proper(word(term))
    if (ref in (*PRONOUNS, *GROUPS) or ref == "somebody") and not described(telling, name):
        return ref
    denied = any(said.negated for said in telling.about(name, "ako", "own"))  # "that is not my dad"
    owners = [] if denied else [linked(own, "of") for own in telling.take(name, "own")]
    whose = thing(telling, owners[0], "possessive") if owners else ""
    bare = "one" if ref == "one" or telling.about(name, "hq", "loc") else "thing"
    if ref in ("", "somebody", "some", "every") and not owners:
        bare = ""
    counts = [count.literal or "" for count in telling.take(name, "cnt")]
    numbers = list(map(so_many, counts))
    before, noun, after = description(telling, name, "thing" if numbers else bare)
    if ref in _PERSONS and noun == "person" and not before and not whose:
        return " ".join(filter(None, (_PERSONS[ref], after)))
    if not noun:
        vague = {"somebody": "somebody", "every": "everything"}.get(ref, "something")
        return " ".join(filter(None, (vague, before, after)))
    several = (bool(numbers) and counts != [MORE_THAN_ONE]) or ref in GROUPS
    several = several or bool(whose and ref == "each")
    phrase = " ".join(filter(None, (*numbers, before, plural(noun) if several else noun, after)))
    if whose and ref == "each":
        return f"each of {whose} {phrase}"
    if whose:
        return f"{whose} {phrase}"
    if ref == "one":
        return f"the {phrase}"
    if not ref and (numbers or noun in classes()["mass"] or (noun == "one" and not before)):
        return phrase
    if ref == "they":
        return f"the {phrase}"
    return f"{ref if ref in _DETERMINERS else article(phrase)} {phrase}"
