"""A directive being carried out: what its code can ask of memory, policy and body."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Final

from kernel.action.chain import Directive
from kernel.action.step import Advice, Run, StepReason
from kernel.action.verdict import Verdict
from kernel.calling import act_text, call
from kernel.memory.attention import Failure
from kernel.memory.choice import choice_weights, in_turn
from kernel.memory.meaning import Question
from kernel.memory.recall import answer, is_so, known, named
from kernel.memory.reply import Reason
from kernel.net.match import matches
from kernel.net.node import Node, describe
from kernel.selecting import Chosen, Selection
from kernel.using import use

if TYPE_CHECKING:
    from kernel.running import Frame

DEEPEST: Final = 20


class RunningStep:
    """A directive being carried out (kernel.action.step.Step)."""

    def __init__(self, frame: Frame, directive: Directive) -> None:
        self.frame, self.directive = frame, directive
        self.commons, self.focus = frame.commons, frame.focus
        self.selection = Selection(
            self.commons, self.focus, frame.within, self.commons.settings.threshold
        )
        graphlet = directive.graphlet
        if graphlet is None or directive.tag in ("CHK", "FIND"):
            return
        memory = self.commons.memory
        if directive.tag == "NOTE":
            bound, self.selection.facts = memory.tell(graphlet, frame.binding)
            frame.binding = dict(bound)
            for node in self.selection.facts:
                self.focus.nodes[node] = None
        else:
            frame.binding = frame.instantiate(graphlet)
        self.selection.node = frame.binding[graphlet.main]
        if directive.tag == "DO" and self.focus.speech_act is not None and frame.ordered:
            memory.net.link(self.focus.speech_act, "cmd", self.selection.node)
        memory.changed()

    @property
    def node(self) -> Node | None:
        """The directive's main node, where it has become one."""
        return self.selection.node

    # -- operators -------------------------------------------------------------------------

    def operators(self, tag: str) -> Iterator[Chosen]:
        """Applicable operators: NOTE and DO in turn by weight, ANTE and POST all, prohibitions first."""
        found = list(self.selection.applicable(tag))
        if tag == "ANTE":
            found.sort(key=lambda c: not c.operator.prohibits)
            found = [c for c in found if not (c.operator.prohibits and self.selection.permitted(c))]
        if not found:
            return
        weights = choice_weights(
            [c.operator.preference for c in found],
            [c.specificity for c in found],
            self.commons.settings.sharpness,
        )
        self.commons.record(
            "considered",
            self.focus,
            tag=tag,
            options=tuple((c.lesson.words or str(c.lesson.ident)) for c in found),
            weights=tuple(round(w, 3) for w in weights),
        )
        order = (
            iter(found) if tag in ("ANTE", "POST") else in_turn(found, weights, self.commons.chance)
        )
        for choice in order:
            self.commons.record("chosen", self.focus, tag=tag, lesson=choice.lesson.ident)
            use(self.commons, self.focus, choice.operator.asks, choice.binding)
            if tag == "ANTE" and choice.operator.prohibits:
                self.prohibit(choice)
            yield choice

    def prohibit(self, choice: Chosen) -> None:
        """Remember the veto as the explanation."""
        concluded = [node for node in choice.binding.values() if node.rule]
        self.focus.failure = Failure(
            "prohibited",
            self.node,
            by=choice.lesson,
            because=tuple(describe(node) for node in concluded),
            said_before=self.focus.said,
        )
        self.commons.record(
            "prohibited", self.focus, by=choice.lesson.words, text=act_text(self.node)
        )

    def desperate(self) -> bool:
        """Lower the threshold once (Connell 2019: a robot "desperate to find some action" may)."""
        if self.selection.threshold <= self.commons.settings.desperate_threshold:
            return False
        self.selection.threshold = self.commons.settings.desperate_threshold
        return True

    def run(self, advice: Advice) -> Run:
        """Run the operator's chain in a frame of its own."""
        assert isinstance(advice, Chosen)
        if len(self.frame.within) >= DEEPEST:
            self.frame.explain("too_deep", self.node)
            return Verdict.FAILED
        before = self.focus.failure
        frame = self.frame.within_operator(advice.binding, advice.lesson)
        if advice.operator.trigger.tag == "NOTE" and self.focus.reaction is None:
            self.focus.reaction = advice.lesson
        verdict = yield from frame.chain(advice.operator.chain)
        if verdict.ok or advice.operator.trigger.tag in ("POST", "NOTE"):
            self.focus.failure = before
        # A veto stands even where the robot fails at what it should do instead.
        if verdict is Verdict.FAILED and advice.operator.forbids:
            return Verdict.PUNTED
        return verdict

    # -- what directives ask for -----------------------------------------------------------

    def truth(self) -> bool | None:
        """CHK from memory."""
        graphlet, memory = self.directive.graphlet, self.commons.memory
        if graphlet is None:
            return None
        memory.refresh()
        bound = known(graphlet, self.frame.binding)
        for pattern, verdict in ((graphlet, True), (graphlet.denied(), False)):
            for binding in matches(
                pattern, memory.net, memory.depth, bound, self.selection.threshold
            ):
                if is_so(binding):
                    use(self.commons, self.focus, (pattern,), binding)
                    self.frame.binding = {**self.frame.binding, **binding}
                    return verdict
        return None

    def referent(self) -> bool:
        """FIND inside a play: the first option is taken, without coming back."""
        binding = next(self.frame.options(self.directive, ()), None)
        if binding is not None:
            self.frame.binding = binding
        return binding is not None

    def call(self) -> Run:
        """FCN: the function's name is the word of the main node, the act is what its arg points to."""
        if self.node is None:
            return Verdict.FAILED
        act = next(self.node.to("arg"), self.node)
        return (yield from call(self.commons, self.focus, min(self.node.lex), act))

    def learn(self) -> Run:
        """Wait until the lesson is kept, or is not."""
        lesson = self.focus.lesson
        if lesson is None:
            return Verdict.FAILED
        key = self.commons.keep(self.focus, lesson)
        while key in self.commons.pending:
            yield
        failure = self.focus.failure
        refused = failure is not None and failure.reason == "not_stored"
        return Verdict.FAILED if refused else Verdict.SUCCEEDED

    def answer(self) -> None:
        """Reply to the focus's question."""
        meaning = self.focus.heard.meaning if self.focus.heard else None
        if isinstance(meaning, Question):
            for node in named(meaning.about, self.commons.memory):
                self.frame.mention(node)
            self.commons.memory.refresh()
            self.commons.replies.append(
                answer(meaning, self.commons.memory, partial(use, self.commons, self.focus))
            )

    def times(self) -> int:
        """The count under the action node."""
        for node in self.node.modifiers("cnt") if self.node else ():
            if node.literal and node.literal.isdigit():
                return int(node.literal)
        return 1

    def explain(self, reason: StepReason) -> None:
        """Say why; operators that were left out because they are running already mean recursion."""
        if reason == "prohibited":
            return
        why: Reason = "recursion" if reason == "no_way" and self.selection.ruled_out else reason
        self.frame.explain(why, self.node)
