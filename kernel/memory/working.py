"""Working memory: the net, what was told and sensed, and which of it is in mind.

In mind is everything reachable from active and fading foci, the robot itself, the current user, what is sensed, and
told facts about anything among these (mind.md).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Final

from kernel.memory.born import part, speaker
from kernel.memory.contraries import ended_by
from kernel.memory.halo import Halo
from kernel.memory.instance import telling_words
from kernel.memory.promotion import Item, Promotions, Step
from kernel.memory.reach import Reach
from kernel.memory.rules import RuleBook
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding, matches
from kernel.net.node import BAND_1, BAND_2, HYPOTHETICAL, REMEMBERED, Net, Node, instantiate

TOLD_LIMIT: Final = 1000  # mind.md: told facts a session keeps


class WorkingMemory:
    """The three levels of memory over one net.

    Attributes:
        net: all nodes.
        me: the robot ("you" to a person); user: the node of the person speaking.
        told: facts by their main node, least recently mentioned first, with the nodes that carry them.
        promotions: conclusions that were used.
    """

    def __init__(self, roots: Callable[[], Iterable[Node]], parts: Iterable[str] = ()) -> None:
        """roots: nodes of the foci in attention; parts: nouns of the body ("gripper")."""
        self.net = Net()
        self.rules = RuleBook()
        self.halo = Halo(self.net, self.rules)
        self.promotions = Promotions(self.net, self.halo, self.rules)
        self.told: dict[Node, tuple[Node, ...]] = {}
        self._lost: list[Graphlet] = []
        self._reach = Reach(self.net, self.mention)
        self._roots = roots
        self._sensed: dict[str, tuple[Node, ...]] = {}
        self._sensed_names: Binding = {}
        self._stale = True
        self.me = self.net.new("self", "you")
        own = {noun: part(self.net, noun, self.me) for noun in parts}
        self._parts = {noun: thing for noun, (thing, *_) in own.items()}
        self._born = frozenset(node for nodes in own.values() for node in nodes)
        self._reach.keep(self._born)
        self._anyone = self._somebody("me")
        self.user = self._anyone

    def share(self, rules: RuleBook) -> None:
        """Conclude by the rules of another mind, which must not change meanwhile; before anything else is done."""
        self.rules = rules
        self.halo = Halo(self.net, rules)
        self.promotions = Promotions(self.net, self.halo, rules)
        self.changed()

    def changed(self) -> None:
        """Something was added or taken away: what is in mind is to be worked out anew."""
        self._stale = True

    def refresh(self) -> None:
        """Bring levels and halo up to date; cheap when nothing changed."""
        if not self._stale and not self.net.changes and not self.rules.changed:
            return
        self._stale = False
        self._reach.update(self._in_attention())
        while self.promotions and self.promotions.prune(telling_words(self.net.changes)):
            self._reach.update(self._in_attention())
        self.halo.update(self.net.take_changes())

    def resting_on(self, facts: Iterable[Node]) -> dict[Node, None]:
        """The facts with everything that is concluded from them."""
        found = dict.fromkeys(facts)
        pending = list(found)
        while pending:
            node = pending.pop()
            for other in (*self.halo.resting_on(node), *self.promotions.resting_on(node)):
                if other not in found:
                    found[other] = None
                    pending.append(other)
        return found

    def rebuild(self) -> None:
        """Work out afresh what is in mind and what follows; the outcome is that of `refresh`."""
        self.refresh()
        self._reach.rebuild(self._in_attention())
        self.halo.rebuild()

    def _in_attention(self) -> dict[Node, None]:
        roots = dict.fromkeys((self.me, self.user))
        roots |= dict.fromkeys(self._roots())
        for group in self._sensed.values():
            roots |= dict.fromkeys(group)
        return roots

    def promote(self, items: Iterable[Item], holder: dict[Node, None]) -> list[Step]:
        """Take conclusions that were used into working memory; see Promotions.promote."""
        steps = self.promotions.promote(items, holder)
        if steps:
            self.changed()
        return steps

    def persons(self, graphlet: Graphlet, binding: Binding) -> Binding:
        """The binding with "you" bound to the robot itself and "me" to the speaker."""
        found = dict(binding)
        for term in graphlet.terms:
            if term.name not in found and "you" in term.lex:
                found[term.name] = self.me
            elif term.name not in found and "me" in term.lex:
                found[term.name] = self.user
        return found

    def instantiate(self, graphlet: Graphlet, binding: Binding) -> Binding:
        """Nodes for what is not bound yet; see kernel.net.node.instantiate."""
        bound = instantiate(self.net, graphlet, self.persons(graphlet, binding))
        self.changed()
        return bound

    # -- what was told ---------------------------------------------------------------------

    def tell(self, fact: Graphlet, binding: Binding) -> tuple[Binding, tuple[Node, ...]]:
        """Take a fact for true: nodes for it (those it had already if it was told before), and what it contradicts
        is taken back.

        Returns:
            The binding, and the nodes that carry the fact, main first.
        """
        binding = self.persons(fact, binding)
        for ended in ended_by(fact, binding):
            for former in list(matches(ended, self.net, REMEMBERED, binding, 0.0)):
                self.retract(former[fact.main])
        for same in matches(fact, self.net, REMEMBERED, binding, 0.0):
            if same[fact.main] in self.told:
                self.mention(same[fact.main])
                for term in fact.terms:
                    if term.name not in binding:
                        self.net.believe(same[term.name], term.belief)
                self.changed()
                return same, self.told[same[fact.main]]
        bound = self.instantiate(fact, binding)
        group = tuple(dict.fromkeys(node for name, node in bound.items() if name not in binding))
        carrying = (bound[fact.main], *(n for n in group if n is not bound[fact.main]))
        self._remember(carrying)
        return bound, carrying

    def _remember(self, group: tuple[Node, ...]) -> None:
        self._reach.release(self.told.get(group[0], ()))
        self._reach.keep(group)
        self.told[group[0]] = group
        while len(self.told) > TOLD_LIMIT:
            oldest = next(iter(self.told))
            self._lost.append(describe(oldest))
            about = [other for node in self.told[oldest] for _, other in node.links]
            self.retract(oldest)
            self.forget(about)
        self.changed()

    def take_lost(self) -> list[Graphlet]:
        """Told facts that had to make room since the last call, for the log."""
        lost, self._lost = self._lost, []
        return lost

    def remember_description(self, nodes: Iterable[Node]) -> None:
        """Keep the nodes that describe something a fact is about, as long as any told fact is kept."""
        for node in nodes:
            if (
                any(role in ("ako", "hq", "own") for role, _ in node.links)
                and node not in self.told
            ):
                self._remember((node,))

    def mention(self, main: Node) -> None:
        """A told fact came up again: it is the most recent now."""
        if main in self.told:
            self.told[main] = self.told.pop(main)

    def retract(self, main: Node) -> None:
        """Take a told fact back. Things of it that others speak of as well stay."""
        group = self.told.pop(main, ())
        self._reach.release(group)
        for node in group:
            elsewhere = any(other not in group for _, other in node.into)
            if node is main or not (elsewhere or self._reach.is_kept(node)):
                self.net.drop(node)
        self.changed()

    def is_part(self, node: Node) -> bool:
        """Whether it is a part of the robot's own body."""
        return node in self._born

    def recall_fact(self, fact: Graphlet) -> Node:
        """Take a fact that was stored, and return its main node: its named things are those known by these names."""
        named: Binding = {}
        for term in fact.terms:
            if term.kind == "obj" and term.lex:
                word = min(term.lex)
                known = self._called(word)
                named[term.name] = known[0] if known else self.net.from_term(term)
        _, carrying = self.tell(fact, named)
        self._remember(tuple(dict.fromkeys((*self.told[carrying[0]], *named.values()))))
        return carrying[0]

    def forget(self, nodes: Iterable[Node]) -> None:
        """Drop nodes of a focus that has faded, but for what was told or sensed, what that is about, and what other
        foci mention."""
        held = set(self._roots())
        for node in nodes:
            is_person = node is self.me or node.kind == "user"
            concluded = node.level in (BAND_1, BAND_2)  # the halo's own
            if not (is_person or concluded or node in held or self._is_kept(node)):
                self.net.drop(node)
        self.changed()

    def _is_kept(self, node: Node) -> bool:
        """Told, sensed or born, or what something of that sort is about."""
        return self._reach.is_kept(node) or any(
            role != "cmd" and self._reach.is_kept(other) for role, other in node.into
        )

    # -- what is sensed --------------------------------------------------------------------

    def sense(
        self, key: str, fact: Graphlet, of: tuple[str, str] | None = None
    ) -> tuple[Node, ...]:
        """Hold a sensed fact under a key until `unsense`; return its nodes.

        Names that other held facts use mean the same nodes: "very close" modifies the "close" that is held.

        Args:
            key: of the fact, for its end.
            fact: what is so.
            of: a name in the fact, and the noun of the robot's own part that it means.
        """
        known = self.persons(fact, self._sensed_names)
        if of is not None:
            name, noun = of
            known[name] = self._parts[noun]
        bound = self.instantiate(fact, known)
        new = {name: node for name, node in bound.items() if name not in known}
        self._sensed_names |= new
        self._sensed[key] = tuple(new.values())
        self._reach.keep(self._sensed[key])
        self.changed()
        return self._sensed[key]

    def unsense(self, key: str) -> None:
        """The sensor does not say so any more."""
        gone = self._sensed.pop(key, ())
        self._reach.release(gone)
        for node in gone:
            self.net.drop(node)
        self._sensed_names = {n: node for n, node in self._sensed_names.items() if node not in gone}
        self.changed()

    # -- who is there ----------------------------------------------------------------------

    def person(self, name: str) -> Node:
        """Whoever is known by that name, or becomes so."""
        known = self._called(name)
        return known[0] if known else self._somebody(name)

    def _somebody(self, name: str) -> Node:
        person, kind = speaker(self.net, name)
        self._born |= {kind}
        self._reach.keep((kind,))
        return person

    def person_speaking(self, name: str) -> None:
        """Make the named person the current user; "" is somebody not identified."""
        person = self.person(name) if name else self._anyone
        if person is self.user:
            return
        self.net.unname(self.user, "me")
        self.net.name(person, "me")
        self.user = person
        self.changed()

    @property
    def speaker_names(self) -> frozenset[str]:
        """What the current user is called; empty where nobody knows."""
        return frozenset(self.user.lex - {"me"})

    def _called(self, name: str) -> list[Node]:
        found = [node for node in self.net.with_word(name) if node.kind in ("obj", "user")]
        return [node for node in found if node.level != HYPOTHETICAL]

    @property
    def depth(self) -> int:
        """Level up to which operators see."""
        return BAND_2
