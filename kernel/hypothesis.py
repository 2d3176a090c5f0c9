"""Hypotheses: conditions that are entertained, as nodes, without being held (ours).

ACH[the gripper is closed] looks for operators that say how to bring that about, CHK and FIND for such that say how to
find it out. Their triggers are patterns, matched against nodes; but what is wanted or asked is not so, and must not be
taken for a fact. Its nodes are HYPOTHETICAL: no rule, no look-up, no enablement, no reaction sees them. Only the
trigger match of the step that entertains them does (Selection.supposed).
"""

from __future__ import annotations

from dataclasses import dataclass

from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import HYPOTHETICAL, Net, Node, instantiate


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """A condition entertained; drop it when nobody does any more.

    Attributes:
        node: its main node.
        nodes: those made for it. What the condition names and the binding knows is the real thing, and not among them.
        binding: of every name in it.
    """

    net: Net
    node: Node
    nodes: frozenset[Node]
    binding: Binding

    def drop(self) -> None:
        """Forget it; harmless when done twice."""
        for node in self.nodes:
            self.net.drop(node)


def suppose(graphlet: Graphlet, memory: WorkingMemory, binding: Binding) -> Hypothesis:
    """Entertain the graphlet, its known names bound to what they are bound to, "you" and "me" to the persons."""
    known = memory.persons(graphlet, binding)
    bound = instantiate(memory.net, graphlet, known)
    made = frozenset(node for name, node in bound.items() if name not in known)
    for node in made:
        memory.net.place(node, HYPOTHETICAL)
    return Hypothesis(memory.net, bound[graphlet.main], made, bound)
