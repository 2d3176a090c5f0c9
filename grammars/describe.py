"""What a sentence was taken for, as plain data: the part of `sayso parse --json` that comes from its meaning."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from grammars.measures import summed
from grammars.reading import Parsed
from kernel.action.chain import Chain
from kernel.memory.lesson import Operator, Rule, graphlets
from kernel.memory.meaning import (
    Command,
    Control,
    Fact,
    Identity,
    Meaning,
    Question,
    Revision,
    Teach,
)
from kernel.net.graphlet import Graphlet

NOT_ACTIONS = ("FIND", "PUNT", "NOTE")


def describe(parsed: Parsed) -> dict[str, Any]:
    """Fields of service.md's table; reading back and notation are added by whoever prints it."""
    meaning = parsed.meaning
    content = meaning.content if isinstance(meaning, Teach) else None
    chain = _chain(meaning)
    return {
        "text": parsed.text,
        "kind": parsed.kind,
        "words": sorted(
            (_words(meaning) | _told_by_role(parsed) | _added(parsed)) - _implied(parsed)
        ),
        "steps": None if chain is None else _steps(chain),
        "parallel": chain is not None and chain.parallel,
        "negated": any(term.negated for graphlet in _graphlets(meaning) for term in graphlet),
        "preference": content.preference if isinstance(content, Operator) else None,
        "belief": content.belief if isinstance(content, Rule) else None,
        "trigger": _trigger(meaning) if isinstance(meaning, Teach) else [],
        "ask": meaning.ask if isinstance(meaning, Question) else None,
        "unknown_words": list(parsed.unknown_words),
        "alternatives": parsed.alternatives,
    }


def _chain(meaning: Meaning) -> Chain | None:
    """The chain of a meaning that has one."""
    if isinstance(meaning, Command | Revision):
        return meaning.chain
    if isinstance(meaning, Teach) and isinstance(meaning.content, Operator):
        return meaning.content.chain
    return None


def _steps(chain: Chain) -> int:
    return sum(directive.tag not in NOT_ACTIONS for directive in chain.directives())


def _graphlets(meaning: Meaning) -> Iterator[Graphlet]:
    """Every graphlet of a meaning."""
    match meaning:
        case Fact(fact, finds):
            yield from (*finds, fact)
        case Question(about=about, chain=chain):
            yield about
            yield from chain.graphlets() if chain is not None else ()
        case Control(about=about, more=more) if about is not None:
            yield from (about, *more)
        case Revision(chain, instead_of, of):
            yield from chain.graphlets()
            yield from (part for part in (instead_of, of) if part is not None)
        case Command(chain):
            yield from chain.graphlets()
        case Teach():
            for content in meaning.contents:
                yield from graphlets(content)


def _words(meaning: Meaning) -> set[str]:
    """Lemmas, numbers and words of quoted speech, one word each."""
    words = set(meaning.name.split()) if isinstance(meaning, Identity) else set()
    chain = _chain(meaning)
    if chain is not None and any(chain.tagged("WAIT")):
        words.add("wait")
    for graphlet in _graphlets(meaning):
        for term in graphlet:
            words |= {word for lex in term.lex for word in lex.split()}
            if term.literal is not None:
                words |= set(term.literal.lower().split())
    return words


def _told_by_role(parsed: Parsed) -> set[str]:
    """Words that are a role in the net and no term: what belongs to somebody."""
    return {"belong"} if any(part.name == "owner_of" for part in parsed.alist.walk()) else set()


def _added(parsed: Parsed) -> set[str]:
    """Numbers and units that were added up: "two feet and three inches"."""
    mixed = [amt for amt in parsed.alist.walk() if amt.name == "amt" and len(amt.all("unit")) > 1]
    return {part.value or "" for amt in mixed for part in amt if part.name in ("num", "unit")}


def _implied(parsed: Parsed) -> set[str]:
    """Words that a sentence of one word leaves out: "forward" and "reverse" are driving."""
    bare = any(part.name == "bare" for part in parsed.alist.walk())
    bare = bare or len(parsed.text.split()) == 1
    sums = {summed(amt).slot("num") for amt in parsed.alist.walk() if amt.name == "amt"}
    summed_up = sums - {part.value for part in parsed.alist.walk() if part.name == "num"}
    return ({"drive", "turn", "raise", "lift"} if bare else set()) | summed_up


def _trigger(taught: Teach) -> list[str]:
    """Lemmas of the triggers' main nodes."""
    triggers = [x.trigger.graphlet for x in taught.contents if isinstance(x, Operator)]
    heads = [graphlet.head for graphlet in triggers if graphlet is not None]
    return sorted({word for head in heads if head is not None for word in head.lex})
