"""Running a focus: chains and plays as generators, resumed once a tick until they return a verdict."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import replace

from kernel.action.chain import Chain, Directive, Loop, Part, Play
from kernel.action.step import DIRECTIVES, Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.finding import LookUp, recalled
from kernel.looping import looped
from kernel.memory.attention import Failure, Focus, Progress
from kernel.memory.experience import Occasion
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.reply import Reason
from kernel.net.describing import descriptions
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import REMEMBERED, Node
from kernel.remembering import begin, remembered
from kernel.stepping import RunningStep
from kernel.stopping import stoppable


class Frame:
    """One chain being run for a focus: its binding, and the operators that led to it.

    Attributes:
        manners: adverbs its steps inherit.
        supposed: nodes of conditions entertained above; prohibitions see them too.
        desperate: nothing that is well believed applied above; ends with the first success.
    """

    def __init__(
        self, commons: Commons, focus: Focus, binding: Binding, within: tuple[Lesson, ...] = ()
    ) -> None:
        """A frame without history.

        overs: whether what it is a part of is over: then no step of it begins.
        acts: the acts it is a part of, outermost first. endless: its one step has no end of its own. made: the nodes
        made in it, where these are to go before the focus does.
        """
        self.commons, self.focus, self.binding, self.within = commons, focus, binding, within
        self.manners: tuple[Node, ...] = ()
        self.supposed: frozenset[Node] = frozenset()
        self.desperate = False
        self.occasion: Occasion | None = None
        self.deed = 0
        self.acts: tuple[Node, ...] = ()
        self.overs: tuple[Callable[[], bool], ...] = ()
        self.endless = False
        self.made: list[Node] | None = None

    @property
    def ordered(self) -> bool:
        """What is done here descends from the utterance; reactions and what a veto does instead are the robot's own."""
        operators = (lesson.content for lesson in self.within)
        return not any(
            isinstance(o, Operator) and (o.trigger.tag == "NOTE" or o.prohibits) for o in operators
        )

    def command(self, chain: Chain, words: str, at: int = 0) -> Run:
        """The chain of a command, from the play at the index on; the focus knows how far it has come."""
        chain = chain.finds_first()
        self.focus.progress = Progress(words, chain, at, self.binding)
        rest = Chain(chain.plays[at:])
        verdict = yield from self.chain(rest, followed=True)
        if verdict is Verdict.PUNTED:
            self.explain("given_up", None)
            return Verdict.FAILED
        return verdict

    def found(self, progress: Progress) -> Binding:
        """What the look-ups of the command have found so far."""
        finds = progress.chain.tagged("FIND")
        return {g.main: self.binding[g.main] for g in finds if g.main in self.binding}

    def chain(self, chain: Chain, followed: bool = False) -> Run:
        """Play after play; a failure goes back to the nearest FIND that has another binding."""
        done = self.focus.progress if followed else None
        index, failure, plays = 0, self.focus.failure, chain.finds_first().plays
        open_finds: list[tuple[int, Directive, LookUp]] = []
        while index < len(plays):
            play = plays[index]
            if done is not None:
                self.focus.progress = replace(done, at=done.at + index, binding=self.found(done))
            if (find := play.find) is not None:
                look_up = LookUp(self, find, list(Chain(plays[index + 1 :]).directives()))
                verdict = yield from self.directive(find, look_up)
                if verdict.ok:
                    open_finds.append((index, find, look_up))
            else:
                verdict = yield from self.play(play)
                self.desperate = self.desperate and not verdict.ok
            if verdict.ok:
                self.focus.failure = failure  # what was tried in vain before is no cause any more
                index += 1
                continue
            if verdict in (Verdict.PUNTED, Verdict.STOPPED):
                return verdict
            while open_finds:
                index, find, look_up = open_finds[-1]
                again = yield from look_up.next()
                self.directive_ended(find, again)
                if again is Verdict.STOPPED:
                    return again
                if again.ok:
                    index += 1
                    break
                open_finds.pop()
            else:
                return verdict
        return Verdict.SUCCEEDED

    def play(self, play: Play) -> Run:
        """All required parts side by side; the auxiliary ones end with them.

        One that is stopped lets the others go on; then the play ends as stopped, too.
        """
        stopped = False
        required: list[Run] = [self.part(part) for part in play.required]
        auxiliary: list[Run] = [self.part(part) for part in play.auxiliary]
        try:
            while True:
                for run in list(required):
                    try:
                        next(run)
                    except StopIteration as end:
                        required.remove(run)
                        if end.value is Verdict.STOPPED:
                            stopped = True
                        elif not end.value.ok:
                            verdict: Verdict = end.value
                            return verdict
                if not required:
                    return Verdict.STOPPED if stopped else Verdict.SUCCEEDED
                for run in list(auxiliary):
                    try:
                        next(run)
                    except StopIteration:
                        auxiliary.remove(run)
                yield
        finally:
            for run in (*required, *auxiliary):
                run.close()

    def part(self, part: Part) -> Run:
        """A directive, or a chain or loop inside a play."""
        if isinstance(part, Chain):
            return self.chain(part)
        if isinstance(part, Loop):
            return looped(self, part)
        return self.directive(part)

    def directive(self, directive: Directive, look_up: LookUp | None = None) -> Run:
        """Post the directive: its graphlet becomes nodes, its code runs. look_up: of a FIND."""
        code = DIRECTIVES.get(directive.tag)
        if code is None:
            self.explain("no_way", None, directive.tag)
            return Verdict.FAILED
        yield from self.breathe()
        self.commons.record("directive", self.focus, **self.told(directive))
        if directive.tag == "FIND" and look_up is None:
            look_up = LookUp(self, directive)
        step = RunningStep(self, directive, look_up)
        run = code(step)
        if directive.tag == "DO" and step.node is not None:
            descent = (self.within, self.occasion, self.deed)
            step.deed = begin(self.commons, self.focus, step.node, *descent)
            run = stoppable(self.commons, self.focus, step.node, run)
            run = remembered(self.commons, self.focus, step.deed, run)
        verdict = Verdict.STOPPED
        try:
            verdict = yield from run
            if verdict is Verdict.PUNTED and directive.tag != "PUNT":
                # What was punted is the chain below; this one may try another way.
                verdict = Verdict.FAILED
        finally:
            self.directive_ended(directive, verdict)
        return verdict

    def told(self, directive: Directive) -> dict[str, str | int]:
        """What the trace says of a directive."""
        return {"tag": directive.tag, "text": directive_text(directive), "depth": len(self.within)}

    def directive_ended(self, directive: Directive, verdict: Verdict) -> None:
        """Leave in the trace what it came to: a look-up each time it is gone back to, with what it found."""
        found: dict[str, str] = {}
        if directive.tag == "FIND" and directive.graphlet is not None and verdict.ok:
            node = self.binding[directive.graphlet.main]
            told = (node, *descriptions(node))
            words = sorted("not " * n.negated + word for n in told for word in n.lex)
            found["found"] = " ".join(words)
        ended = {"verdict": verdict.value, **found, **self.told(directive)}
        self.commons.record("directive_ended", self.focus, **ended)

    def recalled(self, graphlet: Graphlet) -> Binding | None:
        """See kernel.finding."""
        return recalled(self, graphlet)

    def breathe(self) -> Generator[None, None, None]:
        """Count a step; after too many in one tick, wait for the next. Once it is over, leave it to be ended."""
        if any(over() for over in self.overs):
            yield
        if self.commons.out_of_breath:
            self.commons.record("yielded", self.focus, steps=self.commons.steps)
        while self.commons.out_of_breath:
            self.focus.waits.add("next tick")
            yield
        self.commons.steps += 1

    @property
    def threshold(self) -> float:
        """Belief below which nothing counts here."""
        return self.commons.settings.premises(self.desperate)

    def mention(self, node: Node) -> None:
        """The node is in mind for as long as this focus, with what describes it."""
        self.commons.memory.net.touch(node)
        described = [other for other in descriptions(node) if other.level <= REMEMBERED]
        self.focus.nodes |= dict.fromkeys((node, *described))
        self.commons.memory.changed()

    def instantiate(self, graphlet: Graphlet) -> Binding:
        """Nodes for the graphlet, made on behalf of the focus."""
        known = self.commons.memory.persons(graphlet, self.binding)
        bound = self.commons.memory.instantiate(graphlet, known)
        for name, node in bound.items():
            if name not in known:
                self.focus.nodes[node] = None
                if self.made is not None:
                    self.made.append(node)
        return bound

    def inner(self, binding: Binding, made: list[Node]) -> Frame:
        """A frame for a round of a loop: what is made in it can be put away before the focus ends."""
        frame = self._heir(dict(binding), self.within)
        frame.manners, frame.supposed, frame.desperate = (
            self.manners,
            self.supposed,
            self.desperate,
        )
        frame.made = made
        return frame

    def put_away(self, made: list[Node]) -> None:
        """Forget nodes that were made in earlier rounds, but for what else is in mind."""
        for node in made:
            self.focus.nodes.pop(node, None)
        self.commons.memory.forget(made)
        made.clear()

    def explain(
        self, reason: Reason, act: Node | None, detail: str = "", about: tuple[Graphlet, ...] = ()
    ) -> None:
        """Note why the focus is failing; the first cause found stays."""
        if self.focus.failure is None:
            self.focus.failure = Failure(reason, act, detail, about=about)

    def within_operator(self, binding: Binding, lesson: Lesson) -> Frame:
        """A frame for an operator's chain, one level deeper."""
        return self._heir(binding, (*self.within, lesson))

    def _heir(self, binding: Binding, within: tuple[Lesson, ...]) -> Frame:
        """A frame below this one, with its descent."""
        frame = Frame(self.commons, self.focus, binding, within)
        frame.occasion, frame.deed = self.occasion, self.deed
        frame.acts, frame.made, frame.overs = self.acts, self.made, self.overs
        return frame


def directive_text(directive: Directive) -> str:
    """The words of a directive's graphlet, the main node's first, for traces."""
    graphlet = directive.graphlet
    if graphlet is None:
        return ""
    terms = sorted(graphlet.terms, key=lambda t: t.name != graphlet.main)
    words = (word for t in terms for word in (*sorted(t.lex), *filter(None, (t.literal,))))
    return " ".join(words)
