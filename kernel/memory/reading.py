"""Reading the notation of lessons: recursive descent over tokens."""

from __future__ import annotations

import re

from kernel.action.chain import Chain, Directive, Loop, Part, Play
from kernel.errors import NotationError
from kernel.memory.lesson import Content, Operator, Rule
from kernel.net.graphlet import Graphlet
from kernel.net.notation import Token, read_terms, tokens


class Reader:
    """Recursive descent over the tokens of one lesson."""

    def __init__(self, text: str) -> None:
        self.left = list(tokens(text))[::-1]

    def content(self) -> Content:
        """The whole text as one rule, operator or fact."""
        first = self.left[-1] if self.left else None
        if first is not None and first.kind == "section":
            content: Content = self._rule() if first.text == "if" else self._operator()
        else:
            content = self._graphlet()
        self.end()
        return content

    def end(self) -> None:
        """Raise NotationError if anything is left."""
        if self.left:
            raise self._wrong("the end")

    def _rule(self) -> Rule:
        condition = self._section("if")
        unless = self._sections("unless")
        conclusion = self._section("then")
        return Rule(condition, conclusion, unless, self._number("belief"))

    def _operator(self) -> Operator:
        self._take("section", "trig")
        trigger = self._directive()
        enablement = self._sections("with")
        unless = self._sections("unless")
        preference = self._number("pref")
        self._take("rule")
        return Operator(trigger, self.chain(), enablement, unless, preference)

    def _section(self, name: str) -> Graphlet:
        self._take("section", name)
        return self._graphlet()

    def _sections(self, name: str) -> tuple[Graphlet, ...]:
        found = []
        while self._next_is("section", name):
            found.append(self._section(name))
        return tuple(found)

    def _number(self, name: str) -> float:
        self._take("section", name)
        token = self._take("item")
        if not re.fullmatch(r"\d+(\.\d+)?", token.text):
            raise NotationError(token.line, token.text, f"a number after {name}:")
        return float(token.text)

    def chain(self) -> Chain:
        """The plays from here on."""
        plays = []
        while self._next_is("open"):
            if self._next_is("open", "PLAY{"):
                self._take("open")
                required = self._parts()
                auxiliary: tuple[Part, ...] = ()
                if self._next_is("word"):
                    self._take("word")
                    auxiliary = self._parts()
                self._take("close", "}")
                plays.append(Play(required, auxiliary))
            elif self._next_is("open", "LOOP{"):
                plays.append(Play((self._loop(),)))
            else:
                plays.append(Play((self._directive(),)))
        return Chain(tuple(plays))

    def _loop(self) -> Loop:
        self._take("open")
        times = None
        if self._next_is("section", "times"):
            self._take("section")
            token = self._take("item")
            if not token.text.isdecimal():
                raise NotationError(token.line, token.text, "a whole number after times:")
            times = int(token.text)
        until, whilst, each = (
            self._section(name) if self._next_is("section", name) else None
            for name in ("until", "while", "each")
        )
        body = self.chain()
        self._take("close", "}")
        return Loop(body, times, until, whilst, each)

    def _parts(self) -> tuple[Part, ...]:
        found: list[Part] = []
        while self._next_is("open"):
            if self._next_is("open", "CHAIN{"):
                self._take("open")
                found.append(self.chain())
                self._take("close", "}")
            elif self._next_is("open", "LOOP{"):
                found.append(self._loop())
            else:
                found.append(self._directive())
        return tuple(found)

    def _directive(self) -> Directive:
        token = self._take("open")
        if not token.text.endswith("["):
            raise NotationError(token.line, token.text, "a directive such as DO[")
        graphlet = self._graphlet() if self._next_is("item") else None
        self._take("close", "]")
        return Directive(token.text[:-1], graphlet)

    def _graphlet(self) -> Graphlet:
        items = []
        while self._next_is("item"):
            items.append(self.left.pop())
        if not items:
            raise self._wrong("a node, such as act-1 -lex- drive")
        return read_terms(items)

    def _next_is(self, kind: str, text: str = "") -> bool:
        return bool(self.left) and self.left[-1].kind == kind and text in ("", self.left[-1].text)

    def _take(self, kind: str, text: str = "") -> Token:
        if not self._next_is(kind, text):
            raise self._wrong(text or kind)
        return self.left.pop()

    def _wrong(self, expected: str) -> NotationError:
        token = self.left[-1] if self.left else Token("word", "", 0)
        return NotationError(token.line, token.text, expected)
