"""Lessons and meanings as text, canonical: equal nets give equal text, whatever sentence they came from."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any, TypeVar

from kernel.action.chain import Chain, Directive, Loop, Part, Play, sequence
from kernel.memory.lesson import Content, Operator, Rule, graphlets
from kernel.memory.meaning import (
    Choice,
    Command,
    Control,
    Fact,
    Feedback,
    Identity,
    Meaning,
    Question,
    Revision,
    Social,
    Teach,
)
from kernel.memory.reading import Reader
from kernel.net.canon import canonical_names
from kernel.net.graphlet import Graphlet
from kernel.net.notation import write_terms

Written = Content | Chain
W = TypeVar("W", bound=Written)
_RULE = "-" * 15


def write(content: Written) -> str:
    """Canonical notation of a rule, operator, fact or chain."""
    return "\n".join(_lines(canonical(content)))


def canonical(content: W) -> W:
    """The same content with canonical names, unordered parts sorted and empty terms left out."""
    # Names first, so that what has no order is compared by what a name is in the whole, not in its part.
    content = _sorted(_renamed(content, canonical_names(list(_graphlets(content)))))
    return _renamed(content, canonical_names(list(_graphlets(content))))


def write_meaning(meaning: Meaning) -> tuple[str, ...]:
    """Canonical texts of a meaning, for people and for comparing two sentences."""
    match meaning:
        case Command(chain):
            return (write(chain),)
        case Fact(fact, finds):
            looks = [Directive("FIND", find) for find in finds]
            return (write(sequence(*looks, Directive("NOTE", fact))),)
        case Teach():
            return tuple(sorted(map(write, meaning.contents)))
        case Question(ask, about, wanted, topic, chain):
            names = canonical_names([about])
            head = f"ASK {ask} {topic}".rstrip() + (f" {names[wanted]}" if wanted else "")
            return (head, write(about), *((write(chain),) if chain else ()))
        case Feedback(good, stop):
            return ("good" if good else "bad", *(("stop",) if stop else ()))
        case Identity(name, robot):
            return (f"{'obj' if robot else 'user'}-1 -lex- {name}",)
        case Social(act):
            return (act,)
        case Control(act, about, _, told, more):
            again = write_meaning(told) if told else ()
            acts = (about, *more) if about else ()
            return (act, *map(write, acts), *again)
        case Choice(described):
            return (write(described),)
        case Revision(chain, instead_of, of, last, beside, later, moved):
            parts = [(beside or "instead of", instead_of), ("of", of)]
            said = tuple(f"{label}:\n{write(g)}" for label, g in parts if g)
            flags = (("last", last), ("later", later), ("moved", moved))
            return (write(chain), *said, *(flag for flag, is_so in flags if is_so))


def read(text: str) -> Content:
    """Read what `write` wrote.

    Raises:
        NotationError: with the line and what was expected there.
    """
    return Reader(text).content()


def read_chain(text: str) -> Chain:
    """Read a chain alone.

    Raises:
        NotationError: as `read`.
    """
    reader = Reader(text)
    chain = reader.chain()
    reader.end()
    return chain


def _graphlets(content: Written) -> Iterator[Graphlet]:
    return content.graphlets() if isinstance(content, Chain) else graphlets(content)


def _renamed(content: W, names: dict[str, str]) -> W:
    renamed: W = mapped(content, lambda graphlet: _tidy(graphlet.renamed(names)))
    return renamed


def mapped(content: Any, change: Callable[[Graphlet], Graphlet]) -> Any:
    """The same content with every graphlet changed."""
    match content:
        case Graphlet():
            return change(content)
        case Directive(tag, graphlet):
            return Directive(tag, change(graphlet) if graphlet else None)
        case Chain(plays):
            return Chain(
                tuple(
                    Play(
                        tuple(mapped(p, change) for p in play.required),
                        tuple(mapped(p, change) for p in play.auxiliary),
                    )
                    for play in plays
                )
            )
        case Loop():
            return replace(
                content,
                body=mapped(content.body, change),
                until=change(content.until) if content.until else None,
                whilst=change(content.whilst) if content.whilst else None,
                each=change(content.each) if content.each else None,
            )
        case Rule():
            return replace(
                content,
                condition=change(content.condition),
                conclusion=change(content.conclusion),
                unless=tuple(map(change, content.unless)),
            )
        case Operator():
            return replace(
                content,
                trigger=mapped(content.trigger, change),
                chain=mapped(content.chain, change),
                enablement=tuple(map(change, content.enablement)),
                unless=tuple(map(change, content.unless)),
            )
    raise TypeError(content)


def _tidy(graphlet: Graphlet) -> Graphlet:
    kept = [t for t in graphlet.terms if t != replace(t, lex=frozenset(), literal=None, ref="", negated=False,
                                                       belief=1.0, links=())]  # fmt: skip
    kept.sort(key=lambda t: (t.name != graphlet.main, int(t.name.rpartition("-")[2])))
    return Graphlet(tuple(kept), graphlet.main)


def _sorted(content: Any) -> Any:
    """Put what has no order (exceptions, parts of a play) into one: by its text with the names blotted out.

    Where these are alike, the names they share with what has an order decide ("it is close" of two things).
    """
    shared: dict[str, str] = {}
    if isinstance(content, Rule):
        shared = canonical_names([content.condition, content.conclusion])
    elif isinstance(content, Operator) and content.trigger.graphlet:
        shared = canonical_names([content.trigger.graphlet])

    def order(parts: Iterable[Any]) -> tuple[Any, ...]:
        return tuple(sorted(parts, key=lambda part: _blotted(part, shared)))

    def inner(part: Part) -> Part:
        if isinstance(part, Loop):
            return replace(part, body=chain(part.body))
        return chain(part) if isinstance(part, Chain) else part

    def chain(value: Chain) -> Chain:
        plays = []
        for play in value.plays:
            required, auxiliary = (
                order([inner(part) for part in parts]) for parts in (play.required, play.auxiliary)
            )
            plays.append(Play(required, auxiliary))
        return Chain(tuple(plays))

    match content:
        case Chain():
            return chain(content)
        case Rule():
            return replace(content, unless=order(content.unless))
        case Operator():
            return replace(
                content,
                chain=chain(content.chain),
                enablement=order(content.enablement),
                unless=order(content.unless),
            )
    return content


def _blotted(part: Graphlet | Part, shared: dict[str, str]) -> tuple[str, list[str]]:
    as_chain = part if isinstance(part, Chain) else None
    as_chain = sequence(part) if isinstance(part, Loop) else as_chain
    if isinstance(part, Graphlet):
        parts = [part]
    elif isinstance(part, Directive):
        parts = [part.graphlet] if part.graphlet else []
    else:
        parts = list(part.graphlets())
    names = canonical_names(parts) if parts else {}
    links = [shared.get(name, "") for name in names]
    if as_chain is not None:
        return "\n".join(_chain_lines(_renamed(as_chain, names))), links
    head = part.tag if isinstance(part, Directive) else ""
    return head + "\n".join(line for g in parts for line in write_terms(g.renamed(names))), links


def _lines(content: Written) -> list[str]:
    match content:
        case Graphlet():
            return write_terms(content)
        case Chain():
            return _chain_lines(content)
        case Rule(condition, conclusion, unless, belief):
            return [
                *_block("if:   ", write_terms(condition)),
                *(line for g in unless for line in _block("unless: ", write_terms(g))),
                *_block("then: ", write_terms(conclusion)),
                f"belief: {belief}",
            ]
        case Operator(trigger, chain, enablement, unless, preference):
            return [
                *_block("trig: ", _directive_lines(trigger)),
                *(line for g in enablement for line in _block("with: ", write_terms(g))),
                *(line for g in unless for line in _block("unless: ", write_terms(g))),
                f"pref: {preference}",
                _RULE,
                *_chain_lines(chain),
            ]


def _block(head: str, lines: list[str]) -> list[str]:
    return [head + lines[0], *(" " * len(head) + line for line in lines[1:])]


def _directive_lines(directive: Directive) -> list[str]:
    if directive.graphlet is None:
        return [f"{directive.tag}[ ]"]
    lines = _block(f"{directive.tag}[ ", write_terms(directive.graphlet))
    return [*lines[:-1], lines[-1] + " ]"]


def _chain_lines(chain: Chain) -> list[str]:
    lines: list[str] = []
    for play in chain.plays:
        if play.only is not None and not isinstance(play.only, Chain):
            lines += _part_lines(play.only)
            continue
        inner = [line for part in play.required for line in _part_lines(part)]
        if play.auxiliary:
            inner += ["WITH", *(line for part in play.auxiliary for line in _part_lines(part))]
        lines += ["PLAY{", *("  " + line for line in inner), "}"]
    return lines


def _part_lines(part: Part) -> list[str]:
    if isinstance(part, Directive):
        return _directive_lines(part)
    if isinstance(part, Loop):
        return ["LOOP{", *("  " + line for line in _loop_lines(part)), "}"]
    return ["CHAIN{", *("  " + line for line in _chain_lines(part)), "}"]


def _loop_lines(loop: Loop) -> list[str]:
    lines = [] if loop.times is None else [f"times: {loop.times}"]
    for name, graphlet in (("until", loop.until), ("while", loop.whilst), ("each", loop.each)):
        lines += _block(f"{name}: ", write_terms(graphlet)) if graphlet else []
    return [*lines, *_chain_lines(loop.body)]
