"""A directive being carried out: what its code can ask of memory, policy and body."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from kernel.action.call import counted
from kernel.action.chain import Directive
from kernel.action.step import Advice, Run, StepReason, break_off
from kernel.action.verdict import Verdict
from kernel.advising import AdvisedStep
from kernel.calling import call
from kernel.learning import learn
from kernel.memory.contraries import definite, ended_by
from kernel.memory.meaning import Question
from kernel.memory.recall import Notice, answer, is_so, known, missing, named, now_so, unnoticed
from kernel.memory.reply import Answer, Failed, Reason
from kernel.memory.wondering import is_thing, spelled_out
from kernel.net.match import matches
from kernel.stopping import stop_matching
from kernel.using import use

if TYPE_CHECKING:
    from kernel.finding import LookUp
    from kernel.running import Frame


class RunningStep(AdvisedStep):
    """A directive being carried out (kernel.action.step.Step): what its code asks of memory, policy and body."""

    def __init__(self, frame: Frame, directive: Directive, look_up: LookUp | None = None) -> None:
        """look_up: what a FIND may be bound to."""
        super().__init__(frame, directive)
        self._look_up = look_up

    def pursue(self, advice: Advice) -> Run:
        """Run the operator's chain until the condition is so; what went wrong on the way does not count then."""
        before = self.focus.failure
        verdict = yield from break_off(self.run(advice, self.is_so), self.is_so)
        if self.directive.tag == "KEEP" and self.frame.made is not None:
            self.frame.put_away(self.frame.made)
        if self.is_so():
            self.focus.failure = before
        return verdict

    def complain(self, reason: StepReason) -> None:
        """Say why, the first time only; the focus is not failing."""
        self.explain(reason)
        failure, self.focus.failure = self.focus.failure, None
        if failure is None or self.complained:
            return
        self.complained = True
        self.commons.replies.append(Failed(None, failure.reason, failure.detail, failure.about))

    def waits(self, what: str) -> None:
        """For whoever asks what a focus waits for."""
        self.focus.waits.add(what)

    def pause(self, seconds: float) -> Run:
        """Until the time is up."""
        until_s = self.commons.tick.now_s + seconds
        while self.commons.tick.now_s < until_s:
            self.waits("time")
            yield
        return Verdict.SUCCEEDED

    def set_about(self) -> None:
        """Note what begins, where advice may be about it; what is done about what the robot does is not noted, as that
        could go on for ever (ours)."""
        net, me = self.commons.memory.net, self.commons.memory.me
        if self.node is None or self.focus.own:
            return
        if any(self.commons.operators.for_node("NOTE", self.node, net)):
            net.link(self.node, "agt", me)
            self.commons.begun.append(self.node)

    @property
    def avoids(self) -> bool:
        """What is wanted is that the robot does something not."""
        graphlet = self.directive.graphlet
        head = None if graphlet is None else graphlet.head
        return head is not None and head.kind == "act" and head.negated

    def halt(self) -> None:
        """End what matches, or what is to be avoided, but for what this is a step of."""
        if (graphlet := self.directive.graphlet) is not None:
            pattern = graphlet.denied() if self.avoids else graphlet
            stop_matching(self.commons, pattern, self.frame.acts)

    # -- what directives ask for -----------------------------------------------------------

    def is_so(self) -> bool:
        """Whether the condition holds."""
        graphlet, threshold = self.directive.graphlet, self.selection.threshold
        if graphlet is None:
            return False
        so = now_so(graphlet, self.commons.memory, self.frame.binding, threshold)
        if so:
            use(self.commons, self.focus, (graphlet,), so)
        return so is not None

    def truth(self) -> bool | None:
        """CHK from memory."""
        graphlet, memory = self.directive.graphlet, self.commons.memory
        if graphlet is None:
            return None
        memory.refresh()
        bound = known(graphlet, self.frame.binding)
        wrong = ended_by(graphlet, bound.keys() | definite(graphlet))
        for pattern, verdict in ((graphlet, True), *((w, False) for w in wrong)):
            for binding in matches(
                pattern, memory.net, memory.depth, bound, self.selection.threshold
            ):
                if is_so(binding):
                    use(self.commons, self.focus, (pattern,), binding)
                    self.frame.binding = {**self.frame.binding, **binding}
                    return verdict
        return None

    def look_up(self) -> Run:
        """FIND: take the first option; the chain comes back to the look-up for others."""
        assert self._look_up is not None
        return self._look_up.next()

    def call(self) -> Run:
        """FCN: the function's name is the word of the main node, the act is what its arg points to."""
        if self.node is None:
            return Verdict.FAILED
        act = next(self.node.to("arg"), self.node)
        name, endless = min(self.node.lex), self.frame.endless
        return (yield from call(self.commons, self.focus, name, act, endless))

    def learn(self) -> Run:
        """Wait until the lesson is kept, or is not."""
        learned = yield from learn(self.commons, self.focus)
        return Verdict.SUCCEEDED if learned else Verdict.FAILED

    def revise(self) -> Run:
        """Wait until the change is kept, or is not."""
        change = self.focus.change
        kept = change is not None and (yield from self.commons.commit(self.focus, change))
        return Verdict.SUCCEEDED if kept else Verdict.FAILED

    def excuse(self) -> bool:
        """Give the explanation of the failure that the focus notes."""
        if self.focus.excuse is not None:
            self.commons.replies.append(self.focus.excuse)
        return self.focus.excuse is not None

    def seeking(self) -> str:
        """The tag of the operators that may find the answer: CHK for yes or no, else FIND; "" where memory has it."""
        question = self.question()
        if question is None or question.topic or self._recalled(question).verdict != "unknown":
            return ""
        return "CHK" if question.ask == "yesno" else "FIND"

    def answer(self) -> None:
        """Reply to the focus's question."""
        if (question := self.question()) is not None:
            self.commons.replies.append(
                self._recalled(question, partial(use, self.commons, self.focus))
            )

    def _recalled(self, question: Question, notice: Notice = unnoticed) -> Answer:
        memory = self.commons.memory
        for node in named(question.about, memory):
            self.frame.mention(node)
        memory.refresh()
        return answer(question, memory, notice)

    def times(self) -> int:
        """The count under the action node."""
        return counted(self.node) if self.node else 1

    def explain(self, reason: StepReason) -> None:
        """Say why; operators that were left out because they are running already mean recursion."""
        if reason == "prohibited":
            return
        graphlet = self.directive.graphlet
        if reason == "nothing_found" and graphlet is not None and not is_thing(graphlet):
            reason = "not_known"
        if reason in ("not_so", "not_known", "not_achieved"):
            about = (spelled_out(graphlet, self.frame.binding),) if graphlet else ()
            self.frame.explain(reason, None, about=about)
            return
        if reason == "nothing_found":
            self.frame.explain(reason, None, missing(self.directive))
            return
        why: Reason = "recursion" if reason == "no_way" and self.selection.ruled_out else reason
        self.frame.explain(why, self.node)
