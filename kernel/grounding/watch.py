"""What the robot notices by itself: nearness, holding, being stuck, a low battery, the state of its parts.

Source: Connell 2019, section 4 (the rangefinder asserts "There is something very close" at 5 cm); the other senses and
the hysteresis are ours (mind.md).
"""

from __future__ import annotations

from typing import Final

from kernel.action.call import BodyState
from kernel.action.sensing import Edge, sense
from kernel.net.graphlet import Graphlet, Term

# Entering and leaving, m from the gripper's front: a reading that trembles at the border is one event.
CLOSE_M: Final = (0.15, 0.17)
VERY_CLOSE_M: Final = (0.05, 0.06)
FAR_M: Final = (0.28, 0.30)
BATTERY_LOW_V: Final = (6.6, 6.9)
# The same for lift and gripper, as parts of their whole travel: at its end, and not any more.
AT_END: Final = (0.02, 0.06)


def _quality(name: str, word: str, of: str, *more: Term) -> Graphlet:
    return Graphlet((Term(name, frozenset({word}), links=(("hq", of),)), *more), name)


_YOU: Final = Term("obj-9", frozenset({"you"}))
FACTS: Final = {
    "close": _quality("hq-2", "close", "obj-1"),
    "very close": Graphlet(
        (Term("deg-3", frozenset({"very"}), links=(("deg", "hq-2"),)),), "deg-3"
    ),
    "far": _quality("hq-4", "far", "obj-1"),
    "stuck": _quality("hq-5", "stuck", "obj-9", _YOU),
    "low": _quality(
        "hq-6", "low", "obj-7", Term("ako-8", frozenset({"battery"}), links=(("ako", "obj-7"),))
    ),
    "hold": Graphlet(
        (Term("act-10", frozenset({"hold"}), links=(("agt", "obj-9"), ("obj", "obj-11"))), _YOU),
        "act-10",
    ),
    "drop": Graphlet(
        (Term("act-12", frozenset({"drop"}), links=(("agt", "obj-9"), ("obj", "obj-13"))), _YOU),
        "act-12",
    ),
}

PARTS: Final = {
    "gripper closed": ("gripper", "closed"),
    "gripper open": ("gripper", "open"),
    "gripper empty": ("gripper", "empty"),
    "lift up": ("lift", "up"),
    "lift down": ("lift", "down"),
}


@sense("parts")
class Parts:
    """What state gripper and lift are in (ours): closed, on something or as far as it goes; open; empty; up; down.

    What is so at the first look is held, and nothing reacts to it: the robot was made that way.
    """

    def __init__(self) -> None:
        self._now: set[str] | None = None

    def update(self, body: BodyState) -> list[Edge]:
        """Edges since the last report; while the link is down nothing is known to change."""
        if not body.connected:
            return []
        before, first = self._now or set(), self._now is None
        self._now = now = self._seen(body, before)
        edges = [Edge(key, None) for key in PARTS if key in before - now]
        for key, (noun, word) in PARTS.items():
            if key in now - before:
                fact = _quality(f"hq-{20 + len(key)}", word, "obj-20")
                edges.append(Edge(key, fact, part=("obj-20", noun), noted=not first))
        return edges

    def _seen(self, body: BodyState, before: set[str]) -> set[str]:
        """Those whose end is near enough; a part of the travel is what it is away from it."""
        away = {
            "gripper closed": 0.0 if body.holding else body.grip,
            "gripper open": 1.0 - body.grip,
            "gripper empty": 1.0 if body.holding else 0.0,
            "lift up": 1.0 - body.lift,
            "lift down": body.lift,
        }
        enter, leave = AT_END
        return {key for key, way in away.items() if way < (leave if key in before else enter)}


@sense("watch")
class Watch:
    """The forklift's standing senses."""

    def __init__(self) -> None:
        self._now: set[str] = set()

    def update(self, body: BodyState) -> list[Edge]:
        """Edges since the last report; while the link is down nothing is known to change."""
        if not body.connected:
            return []
        before = self._now
        self._now = self._seen(body)
        edges = [Edge(key, None) for key in FACTS if key in before - self._now]
        edges += [
            Edge(key, FACTS[key], fleeting=key == "stuck")
            for key in FACTS
            if key in self._now - before
        ]
        # Opening the gripper lets go; losing the thing with the gripper still shut is dropping it.
        if "hold" in before - self._now and body.grip < 0.5:
            edges.append(Edge("drop", FACTS["drop"], fleeting=True))
        return edges

    def _seen(self, body: BodyState) -> set[str]:
        seen = set()
        distance = body.range_m
        if distance is not None:
            if self._below("close", distance, CLOSE_M):
                seen.add("close")
            if self._below("very close", distance, VERY_CLOSE_M):
                seen.add("very close")
            nearer, farther = FAR_M
            if distance > (nearer if "far" in self._now else farther):
                seen.add("far")
        if body.holding:
            seen.add("hold")
        if "stuck" in body.failed.values():
            seen.add("stuck")
        if body.battery_v is not None and self._below("low", body.battery_v, BATTERY_LOW_V):
            seen.add("low")
        return seen

    def _below(self, key: str, value: float, border: tuple[float, float]) -> bool:
        enter, leave = border
        return value < (leave if key in self._now else enter)
