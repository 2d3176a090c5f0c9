"""The rules that fire now, by what they rest on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from kernel.memory.instance import Instance, Key
from kernel.memory.rules import RuleInForce
from kernel.net.node import Node


class Fired:
    """Instances by rule, by node, and by words of their exceptions."""

    def __init__(self) -> None:
        self._instances: dict[Key, Instance] = {}
        self._by_rule: dict[RuleInForce, dict[Instance, Key]] = {}
        self._by_node: dict[Node, dict[Instance, None]] = {}
        self._by_exception: dict[str, dict[Instance, None]] = {}

    def __contains__(self, ident: Key) -> bool:
        """Whether this rule fires with these nodes already."""
        return ident in self._instances

    def add(self, instance: Instance, ident: Key) -> None:
        """File an instance; ident: its rule and nodes."""
        self._instances[ident] = instance
        self._by_rule.setdefault(instance.rule, {})[instance] = ident
        for node in instance.binding.values():
            self._by_node.setdefault(node, {})[instance] = None
        for exception in instance.plan.unless:
            for word in exception.words:
                self._by_exception.setdefault(word, {})[instance] = None

    def remove(self, instance: Instance) -> None:
        """Take an instance out."""
        del self._instances[self._by_rule[instance.rule][instance]]
        discard(self._by_rule, instance.rule, instance)
        for node in instance.binding.values():
            discard(self._by_node, node, instance)
        for exception in instance.plan.unless:
            for word in exception.words:
                discard(self._by_exception, word, instance)

    def clear(self) -> None:
        """Take all out."""
        for index in (self._instances, self._by_rule, self._by_node, self._by_exception):
            index.clear()

    def by(self, rule: RuleInForce) -> Iterable[Instance]:
        """Those of a rule."""
        return self._by_rule.get(rule, ())

    def on(self, node: Node) -> Iterable[Instance]:
        """Those with this node in the match."""
        return self._by_node.get(node, ())

    def watching(self, word: str) -> Mapping[Instance, None]:
        """Those with an exception that the word concerns."""
        return self._by_exception.get(word, {})

    def resting_on(self, nodes: Iterable[Node], least_band: int) -> dict[Instance, None]:
        """Those of this band or a further one that rest on any of the nodes."""
        return {
            instance: None
            for node in nodes
            for instance in self._by_node.get(node, ())
            if instance.band >= least_band
        }


def discard(index: dict[Any, Any], key: object, item: object) -> None:
    """Take an item out of an index of dicts, and the key with the last one."""
    there = index.get(key)
    if there is not None:
        there.pop(item, None)
        if not there:
            del index[key]
