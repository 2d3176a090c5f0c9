"""What is in mind: everything reachable from attention, worked out from what changed.

A node in mind brings what it points to, and what is kept (told, sensed, born) about it.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator

from kernel.net.node import REMEMBERED, WORKING, Net, Node


class Reach:
    """Sets the levels WORKING and REMEMBERED; leaves the halo's nodes, and what is above REMEMBERED, alone."""

    def __init__(self, net: Net, entered: Callable[[Node], None]) -> None:
        """entered: told of every kept node that comes into mind."""
        self._net, self._entered = net, entered
        self._roots: dict[Node, None] = {}
        self._mind: set[Node] = set()
        self._kept: dict[Node, int] = {}
        self._newly_kept: dict[Node, None] = {}
        self._released: dict[Node, None] = {}

    def keep(self, nodes: Iterable[Node]) -> None:
        """These come to mind with what they are about; may be said several times of a node."""
        for node in nodes:
            self._kept[node] = self._kept.get(node, 0) + 1
            self._newly_kept[node] = None

    def release(self, nodes: Iterable[Node]) -> None:
        """Undo `keep`, once."""
        for node in nodes:
            self._kept[node] -= 1
            if not self._kept[node]:
                del self._kept[node]
                self._released[node] = None

    def is_kept(self, node: Node) -> bool:
        """Whether it is kept at all."""
        return node in self._kept

    def update(self, roots: dict[Node, None]) -> None:
        """Follow the changes of the net that nobody has taken yet, and of what is in attention."""
        changes = self._net.changes
        lost = [node for node in self._roots if node not in roots]
        came = [node for node in roots if node not in self._mind]
        self._roots = roots
        suspects = [*lost, *self._released]
        for node in changes.dropped:
            if node in self._mind:
                self._mind.remove(node)
                suspects += [other for _, other in (*node.links, *node.into)]
        candidates = [n for n in (*changes.extended, *changes.altered) if n in self._net]
        self._leave(suspects)
        for node in (*candidates, *self._newly_kept):
            came += self._supported_by_neighbour(node)
        self._enter(came)
        for node in candidates:
            if node.level == WORKING and node not in self._mind:
                self._net.place(node, REMEMBERED)
        self._newly_kept.clear()
        self._released.clear()

    def rebuild(self, roots: dict[Node, None]) -> None:
        """Work everything out afresh."""
        before, self._mind = self._mind, set()
        self._roots = roots
        self._enter(roots, before)
        for node in before - self._mind:
            if node in self._net and node.level == WORKING:
                self._net.place(node, REMEMBERED)

    def _may_be(self, node: Node) -> bool:
        return node.level in (WORKING, REMEMBERED) and node in self._net

    def _supported_by_neighbour(self, node: Node) -> list[Node]:
        """What is to come into mind because of this node's links."""
        if node in self._mind:
            return [other for _, other in node.links]
        if node in self._kept and any(other in self._mind for _, other in node.links):
            return [node]
        return [node] if any(other in self._mind for _, other in node.into) else []

    def _enter(self, nodes: Iterable[Node], there_before: Container[Node] = ()) -> None:
        pending, mind, kept = list(nodes), self._mind, self._kept
        while pending:
            node = pending.pop()
            if node in mind or not self._may_be(node):
                continue
            mind.add(node)
            if node.level != WORKING:
                self._net.place(node, WORKING)
            if node in kept and node not in there_before:
                self._entered(node)
            pending += [other for _, other in node.links if other not in mind]
            pending += [other for _, other in node.into if other in kept and other not in mind]

    def _leave(self, suspects: list[Node]) -> None:
        """Put out of mind those that nothing in mind leads to any more, and in turn what only they led to."""
        safe: set[Node] = set()
        while suspects:
            node = suspects.pop()
            if node not in self._mind or node in safe:
                continue
            alone = self._unsupported(node, safe)
            for gone in alone:
                self._mind.remove(gone)
                if gone in self._net and gone.level == WORKING:
                    self._net.place(gone, REMEMBERED)
                suspects += [other for _, other in gone.links]
                suspects += [other for _, other in gone.into if other in self._kept]

    def _unsupported(self, node: Node, safe: set[Node]) -> list[Node]:
        """The node with all that leads to it, if no root does; empty if it is safe."""
        seen = {node: None}
        for here in (pending := [node]):
            if here in safe or (here in self._roots and self._may_be(here)):
                safe.add(node)
                return []
            for other in self._leading_to(here):
                if other not in seen:
                    seen[other] = None
                    pending.append(other)
        return list(seen)

    def _leading_to(self, node: Node) -> Iterator[Node]:
        for _, other in node.into:
            if other in self._mind:
                yield other
        if node in self._kept:
            for _, other in node.links:
                if other in self._mind:
                    yield other
