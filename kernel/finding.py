"""FIND: the things a description may be bound to, one after the other.

Memory comes first, the newest mention first; then FIND operators, and memory again after each; then, for the object of
an act, a new thing that is assumed. Between things that fit equally well the person decides (mind.md).
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from typing import TYPE_CHECKING

from kernel.action.chain import Directive
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.memory.recall import may_assume, missing, referents, stands_for_one
from kernel.memory.which import PATIENCE_S, Which, ask_which, equal_best
from kernel.memory.wondering import is_thing, sought, values
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import Node
from kernel.stepping import RunningStep
from kernel.using import use

if TYPE_CHECKING:
    from kernel.running import Frame

# None: not done this tick. In the end, whether a stop broke the looking off.
Options = Generator[Binding | None, None, bool]


class LookUp:
    """A FIND of a chain: what it may be bound to, one after the other."""

    def __init__(self, frame: Frame, find: Directive, later: Sequence[Directive] = ()) -> None:
        """later: what the chain does next, for what may be assumed."""
        self._frame, self._options = frame, _bindings(frame, find, later)

    def next(self) -> Run:
        """Bind it to the next thing; fails where none is left, is stopped where the looking was."""
        while True:
            try:
                binding = next(self._options)
            except StopIteration as end:
                return Verdict.STOPPED if end.value else Verdict.FAILED
            if binding is not None:
                self._frame.binding = binding
                return Verdict.SUCCEEDED
            try:
                yield
            except GeneratorExit:  # the looking ends before what looked
                self._options.close()
                raise


def _bindings(frame: Frame, find: Directive, later: Sequence[Directive]) -> Options:
    """Every binding for a FIND, best first."""
    graphlet = find.graphlet
    if graphlet is None or graphlet.main in frame.binding:
        yield frame.binding
        return False
    start, tried = frame.binding, set[Node]()
    known = list(remembered(frame, graphlet, start))
    equal = equal_best(graphlet, known, frame.commons.attention.newest)
    if equal:
        meant = yield from _asked(frame, graphlet, equal)
        known = [option for option in known if option[graphlet.main] is meant]
    if stands_for_one(graphlet):
        known = known[:1]
    for option in known:
        tried.add(option[graphlet.main])
        use(frame.commons, frame.focus, (graphlet,), option)
        frame.mention(option[graphlet.main])
        yield option
    if equal:
        return False
    broken_off = False
    if not sought(graphlet, later):
        broken_off = yield from _found_out(frame, find, start, tried)
    if not tried and not broken_off and may_assume(graphlet, later):
        yield _assumed(frame, graphlet, start)
    return broken_off


def remembered(frame: Frame, graphlet: Graphlet, start: Binding) -> Iterator[Binding]:
    """What memory has: things that fit, or values of what is asked for."""
    look_up = referents if is_thing(graphlet) else values
    return look_up(graphlet, frame.commons.memory, start, frame.threshold)


def recalled(frame: Frame, graphlet: Graphlet) -> Binding | None:
    """The best that memory has, without asking, looking or coming back."""
    option = next(remembered(frame, graphlet, frame.binding), None)
    if option is not None:
        frame.mention(option[graphlet.main])
    return option


def _found_out(
    frame: Frame, find: Directive, start: Binding, tried: set[Node]
) -> Generator[Binding | None, None, bool]:
    """What turns up when FIND operators are followed, one after the other; whether a stop ended the looking."""
    assert find.graphlet is not None
    main = find.graphlet.main
    frame.binding = start
    step = RunningStep(frame, find)
    for operator in step.operators("FIND"):
        frame.binding = start
        verdict = yield from step.run(operator)
        if verdict in (Verdict.PUNTED, Verdict.STOPPED):
            return verdict is Verdict.STOPPED
        for option in list(remembered(frame, find.graphlet, start)):
            if option[main] not in tried:
                tried.add(option[main])
                frame.mention(option[main])
                yield option
    return False


def _asked(
    frame: Frame, graphlet: Graphlet, things: tuple[Node, ...]
) -> Generator[None, None, Node | None]:
    """Ask which of them is meant and wait for the answer; None where none comes in time."""
    commons = frame.commons
    things = tuple(sorted(things, key=lambda node: node.stamp))  # as they were mentioned
    question = ask_which(graphlet, things)
    until_s = commons.tick.now_s + PATIENCE_S
    asked = Which(frame.focus.number, question, things)
    commons.which = asked
    commons.replies.append(question)
    commons.record("asked", frame.focus, text=missing(Directive("FIND", graphlet)))
    try:
        while asked.chosen is None:
            if commons.which is not asked or commons.tick.now_s >= until_s:
                frame.explain("not_answered", None, about=(graphlet,))
                return None
            frame.focus.waits.add("answer")
            yield
    finally:
        if commons.which is asked:
            commons.which = None
    return asked.chosen


def _assumed(frame: Frame, graphlet: Graphlet, start: Binding) -> Binding:
    """A new thing of that description, marked as assumed."""
    frame.binding = start
    binding = frame.instantiate(graphlet)
    binding[graphlet.main].assumed = True
    frame.commons.record("assumed", frame.focus, text=missing(Directive("FIND", graphlet)))
    return binding
