"""Whatever is taught, commanded, stopped and sensed in whatever order: the promises that always hold.

No exception; wheels idle when nobody bids; bounded memory; every focus ends or waits for a named thing; what is
forbidden never reaches the body; a stop within one tick; the same seed gives the same trace.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any, Final

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from grammars.knowledge import born
from kernel.action.call import Rotate, Travel
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Teach
from kernel.memory.settings import Settings
from kernel.memory.working import TOLD_LIMIT
from tests.kernel.session import FORBIDDEN, OWNER, Line, a_line, understood

TICK_S: Final = 0.1
AFTER_LINE_S: Final = 2.0
MOST_FOCI: Final = 40  # 32 active ones; faded ones leave first, and noticing makes room for itself
MOST_NODES: Final = 20_000


class Watched:
    """A robot under random use; every tick is checked."""

    def __init__(self, make_robot: Callable[..., Any], seed: int) -> None:
        meaning = understood(FORBIDDEN)
        assert isinstance(meaning, Teach)
        veto = Lesson(1, meaning.kind, meaning.content, FORBIDDEN, OWNER)
        self.robot = make_robot([*born(), veto], seed=seed, settings=Settings(owner=OWNER))
        self.robot.tick()

    def play(self, line: Line) -> None:
        match line.do:
            case "stop":
                self.robot.stop()
                self.tick()
                assert self.robot.out.bids == ()
                assert self.robot.out.speech == ()
                return
            case "feel":
                self.robot.feel(range_m=line.value or None)
            case "wait":
                self.wait(line.value)
            case "say":
                meaning = understood(line.text)
                if meaning is not None:
                    self.robot.hear(meaning, line.text, line.speaker)
        self.wait(AFTER_LINE_S)

    def wait(self, seconds: float) -> None:
        for _ in range(round(seconds / TICK_S)):
            self.tick()

    def tick(self) -> None:
        out = self.robot.tick(TICK_S)
        wheels = [bid for bid in out.bids if bid.resource == "wheels"]
        assert out.busy or not out.bids, "somebody bids, and no focus is active"
        assert self.robot.body.state.moving == bool(wheels)
        for bid in wheels:
            turning_right = isinstance(bid.command, Rotate) and bid.command.rate_rad_s < 0
            assert not turning_right, "a forbidden act reached the body"
            assert isinstance(bid.command, Rotate | Travel)
        mind = self.robot.mind
        foci = list(mind.foci)
        assert len(foci) <= MOST_FOCI
        assert all(focus.waits for focus in foci if focus.ended_s is None), "it waits for nothing"
        assert len(mind.memory.told) <= TOLD_LIMIT
        assert len(mind.memory.net) <= MOST_NODES
        # The bench keeps everything; the mind must not.
        if len(self.robot.trace) > 5000:
            del self.robot.trace[:-1000]


lines = st.integers(0, 2**32).map(lambda number: a_line(random.Random(number)))


@pytest.mark.timeout(300)
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(lines, min_size=5, max_size=50), st.integers(0, 1000))
def test_the_promises_hold_in_any_order(
    make_robot: Callable[..., Any], session: list[Line], seed: int
) -> None:
    watched = Watched(make_robot, seed)
    for line in session:
        watched.play(line)


@pytest.mark.timeout(300)
def test_a_long_session(make_robot: Callable[..., Any]) -> None:
    """1,500 lines, 30,000 ticks and more."""
    chance = random.Random(7)
    watched = Watched(make_robot, 7)
    for _ in range(1500):
        watched.play(a_line(chance))
    watched.robot.stop()
    watched.wait(60)
    assert not watched.robot.out.busy
    assert not watched.robot.body.state.moving


def test_the_same_seed_gives_the_same_trace(make_robot: Callable[..., Any]) -> None:
    traces = []
    for _ in range(2):
        chance = random.Random(11)
        watched = Watched(make_robot, 11)
        for _ in range(120):
            watched.play(a_line(chance))
        traces.append([repr(record) for record in watched.robot.trace])
    assert traces[0] == traces[1]
    assert len(traces[0]) > 500
