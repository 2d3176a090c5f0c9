"""The paper's text form of graphlets: items, tokens, reading terms. Lessons and meanings: kernel.memory.notation.

One item a line: `act-1 -lex- drive`, `      -dir-> act-1`. A value runs to the end of the line, or to the bracket that
closes its directive; one that could be mistaken for structure is written as a JSON string.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Literal

from kernel.errors import NotationError
from kernel.net.graphlet import Graphlet, Term

_ITEM = re.compile(
    r"(?:(?P<name>[a-z]+-\d+))?(?:\s*-(?P<role>[a-z]+)-(?P<arrow>>?)\s+(?P<value>.+))?"
)
_NODE_NAME = re.compile(r"[a-z]+-\d+")
_OPEN = re.compile(r"(?P<tag>[A-Z]+)(?P<bracket>[\[{])\s*")
_SECTION = re.compile(r"(?P<name>[a-z]+):\s*")

TokenKind = Literal["section", "open", "close", "item", "rule", "word"]


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of notation. text is the tag with its bracket ("DO["), the section, or the item."""

    kind: TokenKind
    text: str
    line: int


def tokens(text: str) -> Iterator[Token]:
    """Cut notation into tokens; values keep their inner blanks."""
    for number, raw in enumerate(text.splitlines(), 1):
        rest = raw.strip()
        if rest and not rest.strip("-"):
            yield Token("rule", rest, number)
            continue
        if match := _SECTION.match(rest):
            yield Token("section", match["name"], number)
            rest = rest[match.end() :]
        while match := _OPEN.match(rest):
            yield Token("open", match["tag"] + match["bracket"], number)
            rest = rest[match.end() :]
        closing = re.search(r"(?:^|\s)[\]}](?:\s*[\]}])*$", rest)
        tail = closing[0].split() if closing else []
        rest = rest[: closing.start()].strip() if closing else rest
        if rest:
            yield Token("word" if rest == "WITH" else "item", rest, number)
        for bracket in "".join(tail):
            yield Token("close", bracket, number)


def read_terms(items: Iterable[Token]) -> Graphlet:
    """The graphlet of these items; the first name is the main node.

    Raises:
        NotationError: an item is not `name -lex- word`, `-str- text`, `-ref- the`, `-neg- yes`, `-bel- 0.8` or
            `-role-> name`.
    """
    terms: dict[str, Term] = {}
    current = ""
    main = ""
    for token in items:
        match = _ITEM.fullmatch(token.text)
        if match is None or not (match["name"] or current) or not any(match.groups()):
            raise NotationError(token.line, token.text, "name -lex- word, or -role-> name")
        current = match["name"] or current
        main = main or current
        if match["role"]:
            term = terms.get(current, Term(current))
            terms[current] = _with(term, match["role"], bool(match["arrow"]), match["value"], token)
    if not main:
        raise NotationError(0, "", "at least one node")
    return Graphlet(tuple(terms.values()), main)


def _with(term: Term, role: str, is_link: bool, written: str, token: Token) -> Term:
    value = _unquote(written, token)
    if is_link:
        if not _NODE_NAME.fullmatch(value):
            raise NotationError(token.line, token.text, "the name of a node after ->")
        return replace(term, links=tuple(sorted({*term.links, (role, value)})))
    match role:
        case "lex":
            return replace(term, lex=term.lex | {value})
        case "str":
            return replace(term, literal=value)
        case "ref":
            return replace(term, ref=value)
        case "neg" if value == "yes":
            return replace(term, negated=True)
        case "bel" if re.fullmatch(r"[01](\.\d+)?", value):
            return replace(term, belief=float(value))
    raise NotationError(token.line, token.text, "-lex- -str- -ref- -neg- yes or -bel- number")


def write_terms(graphlet: Graphlet) -> list[str]:
    """Lines of a graphlet, main node first, then by number. Names are written as they are."""
    described = sorted(graphlet.terms, key=lambda t: (t.name != graphlet.main, _number(t.name)))
    lines: list[str] = []
    for term in described:
        items = _items(term)
        if not items:
            continue
        lines.append(f"{term.name} {items[0]}")
        lines += [" " * (len(term.name) + 1) + item for item in items[1:]]
    if not lines or not lines[0].startswith(graphlet.main + " "):
        lines.insert(0, graphlet.main)
    return lines


def _items(term: Term) -> list[str]:
    items = [f"-lex-  {_quote(word)}" for word in sorted(term.lex)]
    if term.literal is not None:
        items.append(f"-str-  {_quote(term.literal)}")
    if term.ref:
        items.append(f"-ref-  {_quote(term.ref)}")
    if term.negated:
        items.append("-neg-  yes")
    if term.belief != 1.0:
        items.append(f"-bel-  {term.belief:.6g}")
    return items + [f"-{role}-> {other}" for role, other in term.links]


def _number(name: str) -> int:
    return int(name.rpartition("-")[2] or 0)


def _quote(value: str) -> str:
    plain = value.strip() == value and value.isprintable() and not set(value) & set('[]{}"\\')
    return value if plain and value else json.dumps(value)


def _unquote(written: str, token: Token) -> str:
    if not written.startswith('"'):
        return written
    try:
        value = json.loads(written)
    except ValueError:
        raise NotationError(token.line, token.text, "a text in double quotes") from None
    return str(value)
