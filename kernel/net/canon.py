"""Canonical numbering: equal nets get equal names, whatever sentence they came from.

Colour refinement over the named terms of several graphlets at once (they share names), then a walk from the main
nodes in order. Terms that stay alike after refinement are interchangeable in nets made by sentences; one is taken.
"""

from __future__ import annotations

from collections.abc import Sequence

from kernel.net.graphlet import Graphlet, Term

# A node that modifies is named after its role, so that the cosmetic prefix cannot differ.
PREDICATE_ROLES = ("dir", "deg", "ako", "hq", "mod", "amt", "cnt", "sub", "own", "loc")

Key = tuple[object, ...]


def canonical_names(parts: Sequence[Graphlet]) -> dict[str, str]:
    """New name of every name mentioned in the parts, in reading order from their main nodes."""
    names = list(dict.fromkeys(name for part in parts for name in _mentioned(part)))
    out: dict[str, list[tuple[int, str, str]]] = {name: [] for name in names}
    into: dict[str, list[tuple[int, str, str]]] = {name: [] for name in names}
    own: dict[str, list[Key]] = {name: [] for name in names}
    for index, part in enumerate(parts):
        own[part.main].append((index, "main"))
        for term in part.terms:
            own[term.name].append((index, *_content(term)))
            for role, other in term.links:
                out[term.name].append((index, role, other))
                into[other].append((index, role, term.name))
    prefix = {name: _prefix(name, out[name]) for name in names}
    colour = _ranks({name: (prefix[name], *sorted(own[name], key=repr)) for name in names})
    colour = _refine(colour, out, into)
    while len(set(colour.values())) < len(names):
        tied = min(c for c in colour.values() if list(colour.values()).count(c) > 1)
        chosen = next(name for name in names if colour[name] == tied)
        colour = {name: 2 * c + (c == tied and name != chosen) for name, c in colour.items()}
        colour = _refine(colour, out, into)

    order: list[str] = []

    def visit(name: str) -> None:
        if name in order:
            return
        order.append(name)
        for neighbours in (out[name], into[name]):
            for _, _, other in sorted(neighbours, key=lambda n: (n[0], n[1], colour[n[2]])):
                visit(other)

    for part in parts:
        visit(part.main)
        for name in sorted(_mentioned(part), key=colour.__getitem__):
            visit(name)
    return {name: f"{prefix[name]}-{number}" for number, name in enumerate(order, 1)}


def _mentioned(part: Graphlet) -> list[str]:
    names = [part.main]
    for term in part.terms:
        names += [term.name, *(other for _, other in term.links)]
    return names


def _content(term: Term) -> Key:
    return (tuple(sorted(term.lex)), term.literal or "", term.ref, term.negated, term.belief)


def _prefix(name: str, links: list[tuple[int, str, str]]) -> str:
    roles = {role for _, role, _ in links}
    return next((role for role in PREDICATE_ROLES if role in roles), name.rpartition("-")[0])


def _ranks(keys: dict[str, Key]) -> dict[str, int]:
    order = {key: rank for rank, key in enumerate(sorted(set(map(repr, keys.values()))))}
    return {name: order[repr(key)] for name, key in keys.items()}


def _refine(
    colour: dict[str, int],
    out: dict[str, list[tuple[int, str, str]]],
    into: dict[str, list[tuple[int, str, str]]],
) -> dict[str, int]:
    while True:
        keys: dict[str, Key] = {
            name: (
                f"{colour[name]:06}",
                sorted((index, role, colour[other]) for index, role, other in out[name]),
                sorted((index, role, colour[other]) for index, role, other in into[name]),
            )
            for name in colour
        }
        finer = _ranks(keys)
        if len(set(finer.values())) == len(set(colour.values())):
            return finer
        colour = finer
