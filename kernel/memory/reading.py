"""Reading the notation of lessons: recursive descent over tokens."""

from __future__ import annotations

import re

from kernel.action.chain import Chain, Directive, Play
from kernel.errors import NotationError
from kernel.memory.lesson import Content, Operator, Rule
from kernel.net.graphlet import Graphlet
from kernel.net.notation import Token, read_terms, tokens


class Reader:
    """Recursive descent over the tokens of one lesson."""

    def __init__(self, text: str) -> None:
        self.left = list(tokens(text))[::-1]

    def content(self) -> Content:
        first = self.left[-1] if self.left else None
        if first is not None and first.kind == "section":
            content: Content = self.rule() if first.text == "if" else self.operator()
        else:
            content = self.graphlet()
        self.end()
        return content

    def end(self) -> None:
        if self.left:
            raise self.wrong("the end")

    def rule(self) -> Rule:
        condition = self.section("if")
        unless = self.sections("unless")
        conclusion = self.section("then")
        return Rule(condition, conclusion, unless, self.number("belief"))

    def operator(self) -> Operator:
        self.take("section", "trig")
        trigger = self.directive()
        enablement = self.sections("with")
        unless = self.sections("unless")
        preference = self.number("pref")
        self.take("rule")
        return Operator(trigger, self.chain(), enablement, unless, preference)

    def section(self, name: str) -> Graphlet:
        self.take("section", name)
        return self.graphlet()

    def sections(self, name: str) -> tuple[Graphlet, ...]:
        found = []
        while self.next_is("section", name):
            found.append(self.section(name))
        return tuple(found)

    def number(self, name: str) -> float:
        self.take("section", name)
        token = self.take("item")
        if not re.fullmatch(r"\d+(\.\d+)?", token.text):
            raise NotationError(token.line, token.text, f"a number after {name}:")
        return float(token.text)

    def chain(self) -> Chain:
        plays = []
        while self.next_is("open"):
            if self.next_is("open", "PLAY{"):
                self.take("open")
                required = self.parts()
                auxiliary: tuple[Directive | Chain, ...] = ()
                if self.next_is("word"):
                    self.take("word")
                    auxiliary = self.parts()
                self.take("close", "}")
                plays.append(Play(required, auxiliary))
            else:
                plays.append(Play((self.directive(),)))
        return Chain(tuple(plays))

    def parts(self) -> tuple[Directive | Chain, ...]:
        found: list[Directive | Chain] = []
        while self.next_is("open"):
            if self.next_is("open", "CHAIN{"):
                self.take("open")
                found.append(self.chain())
                self.take("close", "}")
            else:
                found.append(self.directive())
        return tuple(found)

    def directive(self) -> Directive:
        token = self.take("open")
        if not token.text.endswith("["):
            raise NotationError(token.line, token.text, "a directive such as DO[")
        graphlet = self.graphlet() if self.next_is("item") else None
        self.take("close", "]")
        return Directive(token.text[:-1], graphlet)

    def graphlet(self) -> Graphlet:
        items = []
        while self.next_is("item"):
            items.append(self.left.pop())
        if not items:
            raise self.wrong("a node, such as act-1 -lex- drive")
        return read_terms(items)

    def next_is(self, kind: str, text: str = "") -> bool:
        return bool(self.left) and self.left[-1].kind == kind and text in ("", self.left[-1].text)

    def take(self, kind: str, text: str = "") -> Token:
        if not self.next_is(kind, text):
            raise self.wrong(text or kind)
        return self.left.pop()

    def wrong(self, expected: str) -> NotationError:
        token = self.left[-1] if self.left else Token("word", "", 0)
        return NotationError(token.line, token.text, expected)
