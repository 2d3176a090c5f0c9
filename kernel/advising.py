"""A directive being carried out: the operators that apply to it, and following one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Final

from kernel import adapting
from kernel.action.chain import Chain, Directive
from kernel.action.step import Advice, Run
from kernel.action.verdict import Verdict
from kernel.calling import act_text
from kernel.hypothesis import Hypothesis, suppose
from kernel.memory.attention import Failure
from kernel.memory.choice import choice_weights, in_turn
from kernel.memory.inference import of_match
from kernel.memory.lesson import Lesson
from kernel.memory.manner import inherit, left_over
from kernel.memory.meaning import Question
from kernel.memory.wondering import asked_for
from kernel.net.describing import describe
from kernel.net.node import Node
from kernel.remembering import occasion_of
from kernel.selecting import Chosen, Selection, names_act
from kernel.using import use

if TYPE_CHECKING:
    from kernel.running import Frame


# Directives about what is not so, or not known to be: their graphlets become no nodes of memory.
WITHOUT_NODES: Final = frozenset(("CHK", "FIND", "ACH", "KEEP", "WAIT", "STOP"))


class AdvisedStep:
    """The half of a step that finds advice and follows it (kernel.stepping has the other)."""

    def __init__(self, frame: Frame, directive: Directive) -> None:
        if directive.tag == "KEEP":  # it may act without end: what it makes for that is put away
            frame = frame.inner(frame.binding, [])
        self.frame, self.directive = frame, directive
        self.commons, self.focus = frame.commons, frame.focus
        self.advised = False  # an operator was followed to a good end, or to a PUNT
        self.followed: list[Lesson] = []
        self.failed: list[Lesson] = []
        self.deed = 0  # its number, where this is a DO
        self.complained = False
        self.selection = Selection(
            self.commons,
            self.focus,
            frame.within,
            supposed=frame.supposed,
            desperate=frame.desperate,
        )
        graphlet = directive.graphlet
        if graphlet is None or directive.tag in WITHOUT_NODES:
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
        if directive.tag == "DO":
            inherited = inherit(memory.net, self.selection.node, frame.manners)
            self.focus.nodes |= dict.fromkeys(inherited)
        told = directive.tag in ("DO", "ADD", "EDIT") and frame.ordered
        if told and self.focus.speech_act is not None:
            memory.net.link(self.focus.speech_act, "cmd", self.selection.node)
        memory.changed()

    @property
    def node(self) -> Node | None:
        """The directive's main node, where it has become one."""
        return self.selection.node

    # -- operators -------------------------------------------------------------------------

    def operators(self, tag: str) -> Iterator[Chosen]:
        """Applicable operators: ANTE and POST all, prohibitions first; the others in turn by weight.

        For CHK, FIND and ACH what is to be found out or brought about is entertained as long as they are asked for.
        """
        entertained = self._entertained() if tag in ("CHK", "FIND", "ACH") else None
        if entertained is not None:
            self.selection.node = entertained.node
            self.selection.supposed = self.frame.supposed | entertained.nodes
        try:
            yield from self._chosen(tag)
        finally:
            if entertained is not None:
                entertained.drop()

    def _entertained(self) -> Hypothesis | None:
        """What this step wants found out or brought about, as nodes that nobody takes for a fact."""
        graphlet, binding = self.directive.graphlet, self.frame.binding
        if graphlet is None and (question := self.question()) is not None:
            graphlet, binding = asked_for(question, self.commons.memory)
        return suppose(graphlet, self.commons.memory, binding) if graphlet else None

    def _chosen(self, tag: str) -> Iterator[Chosen]:
        found = list(self.selection.applicable(tag))
        if self.directive.tag in ("ADD", "EDIT"):
            # "If Rick tells you to do something don't" is about acts: learning has to be named.
            found = [c for c in found if names_act(c.operator)]
        if tag == "ANTE":
            found.sort(key=lambda c: not c.operator.prohibits)
            found = [c for c in found if not (c.operator.prohibits and self.selection.permitted(c))]
        if not found:
            return
        weights = choice_weights(
            [self.commons.policy.strength(c.lesson) for c in found],
            [c.specificity for c in found],
            self.commons.settings.sharpness,
        )
        depth = len(self.frame.within)
        self.commons.record(
            "considered",
            self.focus,
            tag=tag,
            depth=depth,
            options=tuple(c.lesson.ident for c in found),
            weights=tuple(round(w, 3) for w in weights),
        )
        order = (
            iter(found) if tag in ("ANTE", "POST") else in_turn(found, weights, self.commons.chance)
        )
        for choice in order:
            self.commons.record(
                "chosen", self.focus, tag=tag, lesson=choice.lesson.ident, depth=depth
            )
            use(self.commons, self.focus, choice.operator.patterns, choice.binding)
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
            steps=of_match(
                choice.operator.patterns, choice.binding, self.commons.lessons, self.commons.news
            ),
        )
        self.commons.record(
            "prohibited", self.focus, by=choice.lesson.words, text=act_text(self.node)
        )

    def desperate(self) -> bool:
        """Lower the threshold once (Connell 2019: a robot "desperate to find some action" may)."""
        if self.selection.desperate:
            return False
        self.selection.desperate = True
        return True

    def run(self, advice: Advice, over: Callable[[], bool] | None = None) -> Run:
        """Run the operator's chain in a frame of its own, in which no step begins any more once it is over."""
        assert isinstance(advice, Chosen)
        if len(self.frame.within) >= self.commons.settings.depth:
            self.frame.explain("too_deep", self.node)
            return Verdict.FAILED
        self.followed.append(advice.lesson)
        before = self.focus.failure
        tag = advice.operator.trigger.tag
        frame = self.frame.within_operator(advice.binding, advice.lesson)
        frame.desperate, frame.supposed = self.selection.desperate, self.selection.supposed
        if tag == "DO":
            frame.manners = left_over(self.node, advice.binding.values())
        frame.deed = self.deed or frame.deed
        frame.overs += (over,) if over else ()
        if advice.operator.trigger.tag == "NOTE":
            frame.occasion = occasion_of(self.commons, advice.lesson, advice.binding)
        frame.acts += (self.node,) if self.directive.tag == "DO" and self.node else ()
        frame.endless = self.frame.endless and _is_bridge(advice.operator.chain)
        if advice.operator.trigger.tag == "NOTE" and self.focus.reaction is None:
            self.focus.reaction = advice.lesson
        if not self.frame.within and advice.operator.trigger.tag in ("DO", "NOTE"):
            adapting.begun(self.commons, self.focus, advice.lesson)
        verdict = yield from frame.chain(advice.operator.chain)
        adapting.ended(self.commons, self.focus, advice.lesson, self.failed, verdict)
        asked = self.directive.tag in ("CHK", "FIND", "ASK")  # what counts is what is known then
        if verdict.ok or asked or tag in ("POST", "NOTE"):
            self.focus.failure = before
        self.advised = self.advised or verdict.ok or verdict is Verdict.PUNTED
        # A veto stands even where the robot fails at what it should do instead.
        if verdict in (Verdict.FAILED, Verdict.STOPPED) and advice.operator.forbids:
            return Verdict.PUNTED
        return verdict

    def question(self) -> Question | None:
        """The question at hand, if the focus is one."""
        meaning = self.focus.meaning
        return meaning if isinstance(meaning, Question) else None


def _is_bridge(chain: Chain) -> bool:
    """Whether it does nothing but call a grounding function."""
    directives = list(chain.directives())
    return len(chain.plays) == 1 and [d.tag for d in directives] == ["FCN"]
