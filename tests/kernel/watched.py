"""A robot under random use, with every promise that always holds checked after every tick."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, Final

from grammars.replies import say
from kernel.action.call import GROUNDINGS, Rotate, Travel
from kernel.memory import experience
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.meaning import Control, Meaning
from kernel.memory.notation import write
from kernel.memory.policy import RETIRED_KEPT
from kernel.memory.settings import Settings
from kernel.memory.working import TOLD_LIMIT
from kernel.mind import Mind
from kernel.net.graphlet import Graphlet
from kernel.steering import KEPT
from tests.kernel.session import OWNER, VETO, Line, answered, at_birth, understood

TICK_S: Final = 0.1
BEGAN_S: Final = 1_800_000_000.0  # wall time at which use begins, s since 1970
MOST_FOCI: Final = 40  # 32 active ones; faded ones leave first, and noticing makes room for itself
MOST_NODES: Final = 20_000
MOST_TICKS_OF_THOUGHT: Final = (
    50  # a focus that has its turn again and again without waiting for anything
)


class Watched:
    """A robot under random use; every tick is checked.

    make_robot: of tests/kernel/conftest.py; body: another one than the bench's.
    """

    def __init__(self, make_robot: Callable[..., Any], seed: int, body: Any = None) -> None:
        self.robot = make_robot(at_birth(), seed=seed, settings=Settings(owner=OWNER))
        if body is not None:
            self.robot.body = body
        self._thinking: dict[int, int] = {}
        self.robot.tick()

    @property
    def mind(self) -> Mind:
        mind: Mind = self.robot.mind
        return mind

    # -- what happens ----------------------------------------------------------------------

    def play(self, line: Line) -> None:
        """Let it happen, and time pass."""
        robot = self.robot
        match line.do:
            case "stop":
                self._stop()
            case "feel":
                robot.feel(range_m=line.value or None)
            case "wait":
                self.wait(line.value)
            case "store":
                robot.keep, robot.store_takes_s = line.value >= 0, max(0.0, line.value)
            case "link":
                robot.feel(connected=bool(line.value))
            case "reach":
                robot.body.within_reach = bool(line.value)
            case "battery":
                robot.feel(battery_v=line.value)
            case "clear":
                self._clear(round(line.value))
            case "restart":
                self.restart()
            case "say":
                self._say(line)
        self.wait(line.after_s)

    def _say(self, line: Line) -> None:
        expecting = self.mind.expecting
        meaning = understood(line.text) if expecting is None else answered(line.text, expecting)
        if meaning is not None:
            self._hear(meaning, line.text, line.speaker, line.candidates)

    def _hear(self, meaning: Meaning, text: str, *who: Any) -> None:
        self.robot.hear(meaning, text, *who, at_s=BEGAN_S + self.robot.now_s)

    def _clear(self, kept: int) -> None:
        """The owner has all but the newest lessons forgotten, and what is forbidden, as `sayso forget` does."""
        lessons = sorted((x for x in self.mind.policy if x.ident != VETO), key=lambda x: x.ident)
        old = {lesson.ident: None for lesson in lessons[:-kept]}
        old |= {
            x.ident: None
            for x in lessons
            if isinstance(x.content, Operator) and x.content.prohibits
        }
        if old:
            self._hear(Control("forget", lessons=tuple(old)), "forget them", OWNER)

    def _stop(self) -> None:
        """One tick after a stop nothing moves, speaks or goes on but what has come since."""
        before = self.mind.foci
        self.robot.stop()
        self.tick()
        out, commons = self.robot.out, self.mind._commons
        assert out.bids == ()
        begun = {r.data["ticket"]: r.focus for r in out.trace if r.what == "action_started"}
        old = {focus.number for focus in before}
        assert all(begun.get(bid.ticket, 0) not in old for bid in out.speech), "it speaks on"
        assert all(focus.ended_s is not None for focus in before), "it goes on after a stop"
        assert all(doing.focus not in before for doing in commons.doing)
        for open_question in (commons.which, commons.doubt):
            assert open_question is None or open_question.focus not in old
        assert not self.robot.body.state.moving

    def restart(self) -> None:
        """A mind from the journal knows what the old one did."""
        before = policy(self.mind)
        while self.robot._storing or self.robot.out.persist:
            self.tick()
            before = policy(self.mind)
        self.robot.restart()
        after = policy(self.mind)
        differing = {n for n in (before | after) if before.get(n) != after.get(n)}
        assert not differing, [(before.get(n), after.get(n)) for n in differing]
        self._thinking.clear()

    def wait(self, seconds: float) -> None:
        """Tick by tick."""
        for _ in range(round(seconds / TICK_S)):
            self.tick()

    # -- what always holds -----------------------------------------------------------------

    def tick(self) -> None:
        """One tick; then everything is looked at."""
        self.robot.tick(TICK_S)
        self._body_obeys()
        self._foci_wait()
        self._memory_is_bounded()
        for reply in self.robot.out.replies:
            assert say(reply).shown, f"nothing is said of {reply}"
        # The bench keeps everything; the mind must not.
        robot = self.robot
        for kept in (robot.trace, robot.replies, robot.said, robot.moves):
            if len(kept) > 5000:
                del kept[:-1000]
        if len(robot._tickets) > 5000:
            robot._tickets = {
                ticket for ticket in robot._tickets if ticket > max(robot._tickets) - 1000
            }

    def _body_obeys(self) -> None:
        out, state = self.robot.out, self.robot.body.state
        wheels = [bid for bid in out.bids if bid.resource == "wheels"]
        assert out.busy or not out.bids, "somebody bids, and no focus is active"
        assert wheels or not state.moving, "wheels turn that nobody bids for"
        looking = any(
            "look around" in focus.waits for focus in self.mind.active()
        )  # sweeps to both sides
        for bid in wheels:
            turning_right = isinstance(bid.command, Rotate) and bid.command.rate_rad_s < 0
            assert looking or not turning_right, "a forbidden act reached the body"
            assert isinstance(bid.command, Rotate | Travel)

    def _foci_wait(self) -> None:
        """Every active focus waits for a named thing, which is there to wait for, and none thinks for ever."""
        commons, foci = self.mind._commons, self.mind.foci
        assert len(foci) <= MOST_FOCI
        active = [focus for focus in foci if focus.ended_s is None]
        for focus in active:
            waits = focus.waits
            assert waits, f"{focus.words!r} waits for nothing"
            known = {"store", "answer", "condition", "next tick", "time"} | set(GROUNDINGS)
            assert waits <= known, waits
            own = [f for f, _ in commons.pending.values()]
            assert "store" not in waits or own, "it waits for a store that owes no answer"
            if "answer" in waits:
                assert commons.which or commons.doubt, "it waits for an answer to no question"
            thinks = self._thinking.get(focus.number, 0) + 1 if waits == {"next tick"} else 0
            self._thinking[focus.number] = thinks
            assert thinks < MOST_TICKS_OF_THOUGHT, f"{focus.words!r} comes to no end"
        numbers = {focus.number for focus in active}
        self._thinking = {n: t for n, t in self._thinking.items() if n in numbers}

    def _memory_is_bounded(self) -> None:
        mind, commons = self.mind, self.mind._commons
        assert len(mind.memory.told) <= TOLD_LIMIT
        assert len(mind.memory.net) <= MOST_NODES
        assert len(commons.experience) <= experience.ROOM
        assert len(commons.experience.sources) <= experience.SOURCES
        assert len(commons.interrupted) <= KEPT
        assert len(commons.sayings) <= TOLD_LIMIT
        assert len(commons.pending) <= MOST_FOCI * 4
        assert all(doing.focus.ended_s is None for doing in commons.doing)
        assert len(commons.policy._retired) <= RETIRED_KEPT
        assert len(commons.struck) <= MOST_FOCI
        active = any(focus.ended_s is None for focus in mind.foci)
        assert active or not (commons.doing or commons.which or commons.doubt)


def policy(mind: Mind) -> dict[int, tuple[Lesson, str, float]]:
    """Lessons in force that last, each as it is written, in its strength."""
    strength = mind._commons.policy.strength
    return {
        x.ident: (replace(x, content=Graphlet((), "x-1")), write(x.content), strength(x))
        for x in mind.policy
        if 0 < x.ident != VETO
    }
