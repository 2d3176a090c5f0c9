"""Running a focus: chains and plays as generators, resumed once a tick until they return a verdict."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kernel.action.chain import Chain, Directive, Play
from kernel.action.step import DIRECTIVES, Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Failure, Focus
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.recall import may_assume, missing, referents
from kernel.memory.reply import Reason
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import MODIFIER_ROLES, Node
from kernel.stepping import RunningStep
from kernel.using import use


class Frame:
    """One chain being run for a focus: its binding, and the operators that led to it."""

    def __init__(
        self, commons: Commons, focus: Focus, binding: Binding, within: tuple[Lesson, ...] = ()
    ) -> None:
        self.commons, self.focus, self.binding, self.within = commons, focus, binding, within

    @property
    def ordered(self) -> bool:
        """What is done here descends from the utterance; reactions and what a veto does instead are the robot's own."""
        operators = (lesson.content for lesson in self.within)
        return not any(
            isinstance(o, Operator) and (o.trigger.tag == "NOTE" or o.prohibits) for o in operators
        )

    def chain(self, chain: Chain) -> Run:
        """Play after play; a failure goes back to the nearest FIND that has another binding."""
        index = 0
        open_finds: list[tuple[int, Iterator[Binding]]] = []
        while index < len(chain.plays):
            play = chain.plays[index]
            if (find := _lone_find(play)) is not None:
                later = [d for p in chain.plays[index + 1 :] for d in Chain((p,)).directives()]
                options = self.options(find, later)
                binding = next(options, None)
                if binding is None:
                    self.explain("nothing_found", None, missing(find))
                    verdict = Verdict.FAILED
                else:
                    open_finds.append((index, options))
                    self.binding = binding
                    verdict = Verdict.SUCCEEDED
            else:
                verdict = yield from self.play(play)
            if verdict.ok:
                index += 1
                continue
            if verdict is Verdict.PUNTED:
                return verdict
            while open_finds:
                index, options = open_finds[-1]
                binding = next(options, None)
                if binding is not None:
                    self.binding = binding
                    index += 1
                    break
                open_finds.pop()
            else:
                return verdict
        return Verdict.SUCCEEDED

    def play(self, play: Play) -> Run:
        """All required parts side by side; the auxiliary ones end with them."""
        required: list[Run] = [self.part(part) for part in play.required]
        auxiliary: list[Run] = [self.part(part) for part in play.auxiliary]
        try:
            while True:
                for run in list(required):
                    try:
                        next(run)
                    except StopIteration as end:
                        required.remove(run)
                        if not end.value.ok:
                            verdict: Verdict = end.value
                            return verdict
                if not required:
                    return Verdict.SUCCEEDED
                for run in list(auxiliary):
                    try:
                        next(run)
                    except StopIteration:
                        auxiliary.remove(run)
                yield
        finally:
            for run in (*required, *auxiliary):
                run.close()

    def part(self, part: Directive | Chain) -> Run:
        """A directive, or a chain inside a play."""
        if isinstance(part, Chain):
            return self.chain(part)
        return self.directive(part)

    def directive(self, directive: Directive) -> Run:
        """Post the directive: its graphlet becomes nodes, its code runs."""
        code = DIRECTIVES.get(directive.tag)
        if code is None:
            self.explain("no_way", None, directive.tag)
            return Verdict.FAILED
        verdict = yield from code(RunningStep(self, directive))
        if verdict is Verdict.PUNTED and directive.tag != "PUNT":
            # What was punted is the chain below; this one may try another way.
            return Verdict.FAILED
        return verdict

    def options(self, find: Directive, later: Sequence[Directive]) -> Iterator[Binding]:
        """Bindings for a FIND, best first; something new only where nothing is known and it may be assumed."""
        graphlet = find.graphlet
        if graphlet is None or graphlet.main in self.binding:
            yield self.binding
            return
        memory = self.commons.memory
        found = False
        for binding in referents(graphlet, memory, self.binding, self.commons.settings.threshold):
            found = True
            use(self.commons, self.focus, (graphlet,), binding)
            self.mention(binding[graphlet.main])
            yield binding
        if not found and may_assume(graphlet, later):
            yield self.instantiate(graphlet)

    def mention(self, node: Node) -> None:
        """The node is in mind for as long as this focus, with what describes it."""
        self.commons.memory.net.touch(node)
        described = [other for role, other in node.into if role in MODIFIER_ROLES]
        self.focus.nodes |= dict.fromkeys((node, *described))
        self.commons.memory.changed()

    def instantiate(self, graphlet: Graphlet) -> Binding:
        """Nodes for the graphlet, made on behalf of the focus."""
        known = self.commons.memory.persons(graphlet, self.binding)
        bound = self.commons.memory.instantiate(graphlet, known)
        for name, node in bound.items():
            if name not in known:
                self.focus.nodes[node] = None
        return bound

    def explain(self, reason: Reason, act: Node | None, detail: str = "") -> None:
        """Note why the focus is failing; the first cause found stays."""
        if self.focus.failure is None:
            self.focus.failure = Failure(reason, act, detail)

    def within_operator(self, binding: Binding, lesson: Lesson) -> Frame:
        """A frame for an operator's chain, one level deeper."""
        return Frame(self.commons, self.focus, binding, (*self.within, lesson))


def _lone_find(play: Play) -> Directive | None:
    part = play.required[0] if len(play.required) == 1 and not play.auxiliary else None
    return part if isinstance(part, Directive) and part.tag == "FIND" else None
