"""The dry run: what would happen, found out on a copy of the mind and a body that is only imagined.

Nothing moves, nothing is stored, and the mind itself draws no chance, learns nothing and leaves no trace.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final, Protocol, Self

from kernel.action.call import Bid, BodyState, Speak
from kernel.action.chain import Chain
from kernel.action.verdict import Verdict
from kernel.bodies.forklift.kinematic import Kinematic
from kernel.commons import Commons
from kernel.memory.exchange import Inputs, Outputs
from kernel.memory.experience import Deed, Experience, Trouble
from kernel.memory.explanation import PlanStep
from kernel.memory.meaning import Command, Heard, Utterance
from kernel.memory.meant import grounded
from kernel.memory.recall import THINGS
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding
from kernel.net.node import Node

TICK_S: Final = 0.1  # coarse: nobody watches
FINE_S: Final = (
    10.0  # so far; what lies beyond is imagined in ticks of LATER_S, so that 60 s cost 200 ticks
)
LATER_S: Final = 0.5
MOST_S: Final = 60.0
WORD_S: Final = 0.35  # as long as the silent voice takes for a word


class Thinker(Protocol):
    """A mind that can try something out on a copy of itself."""

    speaker: str

    @property
    def experience(self) -> Experience:
        """What it did."""

    def imagined(self, inputs: Inputs) -> Self:
        """A copy that knows and senses the same, with nothing going on."""

    def suppose(self, fact: Graphlet) -> None:
        """Let it notice something that is not so."""

    def tick(self, inputs: Inputs) -> Outputs:
        """One cycle."""


@dataclass(frozen=True, slots=True)
class Imagined:
    """Attributes:
    steps: leaf deeds, by their beginning.
    trouble: why the command, or a reaction, came to nothing.
    whole_s: how long it took. unfinished: it was cut off there.
    """

    steps: tuple[PlanStep, ...]
    trouble: Trouble | None
    whole_s: float
    unfinished: bool


def imagine(mind: Thinker, what: Chain | Graphlet, body: BodyState, speaker: str = "") -> Imagined:
    """Command a chain, or let a fact be noticed, in imagination; at most 60 s of it.

    speaker: who commands; "" for whoever is speaking now.

    The heartbeat waits for it: in ticks of 0.1 s, later 0.5 s, that is a few ms for most, 0.1 s for the longest.
    """
    body = replace(body, done=frozenset(), failed={}, connected=True)
    start_s = body.at_s
    copy = mind.imagined(Inputs(start_s, body))
    forklift = Kinematic(body)
    heard: tuple[Heard, ...] = ()
    if isinstance(what, Chain):
        heard = (Heard(Utterance("", speaker or mind.speaker), Command(what)),)
    else:
        copy.suppose(what)
    speaking: dict[int, float] = {}
    outputs = Outputs(busy=True)
    passed_s = whole_s = 0.0
    while outputs.busy and passed_s < MOST_S:
        now_s, whole_s = start_s + passed_s, passed_s
        spoken = frozenset(ticket for ticket, until_s in speaking.items() if until_s <= now_s)
        state = replace(forklift.state, at_s=now_s)
        outputs = copy.tick(Inputs(now_s, state, heard, spoken))
        heard = ()
        speaking = {t: until_s for t, until_s in speaking.items() if t not in spoken}
        speaking |= _said(outputs.speech, now_s, speaking)
        tick_s = TICK_S if passed_s < FINE_S else LATER_S
        forklift.act(outputs.bids, tick_s)
        passed_s = round(passed_s + tick_s, 3)
    return _told(copy.experience, start_s, whole_s, outputs.busy)


def _said(speech: Sequence[Bid], now_s: float, speaking: dict[int, float]) -> dict[int, float]:
    """When the voice will have said what was added to its queue."""
    free_s = max([now_s, *speaking.values()])
    ends = {}
    for bid in speech:
        if isinstance(bid.command, Speak):
            free_s += WORD_S * len(bid.command.text.split())
            ends[bid.ticket] = free_s
    return ends


def _told(experience: Experience, start_s: float, whole_s: float, unfinished: bool) -> Imagined:
    deeds = list(experience)[::-1]
    above = {deed.parent for deed in deeds if not deed.is_around("ANTE", "POST")}
    leaves = [deed for deed in deeds if deed.number not in above and _began(deed)]
    steps = []
    for deed in leaves:
        ended_s = start_s + whole_s if deed.ended_s is None else deed.ended_s
        begin_s, end_s = _itself(deed, ended_s, [d for d in deeds if d.parent == deed.number])
        steps.append(
            PlanStep(deed.act, begin_s - start_s, end_s - start_s, deed.verdict or Verdict.STOPPED)
        )
    steps.sort(key=lambda step: step.begin_s)
    failed = [deed.trouble for deed in deeds if deed.parent == 0 and deed.trouble is not None]
    return Imagined(tuple(steps), next(iter(failed), None), whole_s, unfinished)


def _itself(deed: Deed, ended_s: float, around: Sequence[Deed]) -> tuple[float, float]:
    """When the deed itself began and ended, without what goes before and after it."""
    before = [d.ended_s or ended_s for d in around if d.is_around("ANTE")]
    after = [d.began_s for d in around if d.is_around("POST")]
    return max([deed.began_s, *before]), min([ended_s, *after])


def _began(deed: Deed) -> bool:
    """It took place, at least for a while."""
    return deed.trouble is None or deed.ended_s != deed.began_s


# -- the copy ------------------------------------------------------------------------------


def transplant(old: Commons, new: Commons, speaker: str) -> None:
    """Let a fresh mind know what the old one knows: lessons, told facts, who is speaking, what chance will bring.

    The policy is the old one itself: nothing is learned in imagination, as nothing is stored there.
    """
    old.memory.refresh()
    new.policy, new.operators = old.policy, old.operators
    new.memory.share(old.memory.rules)
    _retell(old.memory, new.memory)
    new.memory.person_speaking(speaker)
    new.chance.setstate(old.chance.getstate())


def _retell(old: WorkingMemory, new: WorkingMemory) -> None:
    """Every told fact again, about the same things."""
    same: dict[Node, Node] = {old.me: new.me}
    for group in list(old.told.values()):
        bound: Binding = {}
        said = [node for node in group if node.kind not in THINGS and node not in same]
        linked = [other for node in group for _, other in node.links]
        for node in (*group, *linked):
            if node not in said:
                bound[node.name] = _counterpart(node, old, new, same)
        if group[0] in said:
            fact = Graphlet(tuple(map(_term, said)), group[0].name)
            after, _ = new.tell(fact, bound)
            same |= {node: after[node.name] for node in said}


def _counterpart(
    node: Node, old: WorkingMemory, new: WorkingMemory, same: dict[Node, Node]
) -> Node:
    """The thing in the copy that this one is."""
    if node not in same:
        part = _part(node, new) if old.is_part(node) else None
        same[node] = part or new.net.new(node.kind, *sorted(node.lex - {"me"}))
    return same[node]


def _part(node: Node, new: WorkingMemory) -> Node | None:
    """The part of the body that is called so."""
    nouns = [word for kind in node.modifiers("ako") for word in sorted(kind.lex)]
    kinds = [kind for noun in nouns for kind in new.net.with_word(noun) if new.is_part(kind)]
    return next((thing for kind in kinds for thing in kind.to("ako")), None)


def _term(node: Node) -> Term:
    links = tuple(sorted((role, other.name) for role, other in node.links))
    return Term(node.name, frozenset(node.lex), node.literal, "", node.negated, node.belief, links)


def suppose(memory: WorkingMemory, fact: Graphlet) -> tuple[Node, ...]:
    """Nodes for a fact that is only supposed, about the things that are known."""
    known = grounded(fact, memory)
    bound = memory.instantiate(fact, known)
    return tuple(node for name, node in bound.items() if name not in known)
