"""Where the mind meets a body: what the body reports, what a grounding function asks for.

A grounding function is a generator. While it runs it yields a Bid each tick; when it returns, nobody bids, and the
resource goes back to rest. Bodies turn winning bids into their own messages (Connell 2019, section 4: "priorities
are resolved within the grounding kernel").
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

from kernel.action.verdict import Verdict
from kernel.errors import NotGroundedError
from kernel.net.node import Node


@dataclass(frozen=True, slots=True)
class Travel:
    """Roll straight: speed in m/s, negative backwards; for so many seconds, or None for until it is stopped."""

    speed_m_s: float
    seconds: float | None


@dataclass(frozen=True, slots=True)
class Rotate:
    """Turn in place: rate in rad/s, positive counterclockwise (left); seconds as in Travel."""

    rate_rad_s: float
    seconds: float | None


@dataclass(frozen=True, slots=True)
class MoveLift:
    """Bring the lift to a height: 0 is down, 1 is the upper end stop."""

    target: float
    per_second: float = 0.5


@dataclass(frozen=True, slots=True)
class MoveGrip:
    """Bring the gripper to an opening: 0 closed, 1 open. must_hold: closing on nothing is reported as a miss."""

    target: float
    per_second: float = 1.0
    must_hold: bool = True


@dataclass(frozen=True, slots=True)
class Speak:
    """Say it aloud; literal text."""

    text: str


@dataclass(frozen=True, slots=True)
class Halt:
    """End every other motion for good. For the mind alone: no body sees it."""


@dataclass(frozen=True, slots=True)
class Sighting:
    """What a look found. For the mind alone.

    Attributes:
        distance_m: of the nearest thing, None for nothing in reach.
        bearing_rad: counterclockwise from where the robot looks now.
        swept: it looked to both sides as well.
    """

    distance_m: float | None
    bearing_rad: float = 0.0
    swept: bool = False


BodyCommand = Sighting | Halt | Travel | Rotate | MoveLift | MoveGrip | Speak
Resource = Literal["wheels", "lift", "grip", "voice"]


@dataclass(frozen=True, slots=True)
class Bid:
    """One action wants one resource for one command. The ticket names the action from its first bid to its end, so a
    body can tell a renewed bid from a new one."""

    resource: Resource
    command: BodyCommand
    ticket: int


MoveFailure = Literal["link_lost", "missed", "stuck", "refused", "stopped"]


@dataclass(frozen=True, slots=True)
class BodyState:
    """What a body knows of itself, from telemetry and events alone (never from a simulator's ground truth).

    Attributes:
        at_s: time of this state, s.
        connected: the link is up and armed; while it is not, every bid for a wheel or servo fails at once.
        x_m, y_m, heading_rad: reckoned pose; x ahead at the start, y to the left, counterclockwise positive.
        range_m: distance of the nearest thing in the beam from the gripper's front, None if nothing within 0.40 m.
        lift, grip: 0 to 1 as in MoveLift, MoveGrip.
        holding: something is in the gripper.
        moving: the wheels turn.
        battery_v: volts, None if unknown.
        done: tickets whose command the far end has executed to its end (MOVE_DONE or telemetry, not the echo).
        failed: tickets that cannot be executed, and why.
    """

    at_s: float = 0.0
    connected: bool = True
    x_m: float = 0.0
    y_m: float = 0.0
    heading_rad: float = 0.0
    range_m: float | None = None
    lift: float = 0.0
    grip: float = 1.0
    holding: bool = False
    moving: bool = False
    estopped: bool = False
    battery_v: float | None = None
    done: frozenset[int] = frozenset()
    failed: Mapping[int, MoveFailure] = field(default_factory=dict)


class Tick:
    """The present, as grounding functions see it; the same object is kept up to date from tick to tick.

    Attributes:
        now_s: monotonic time, s.
        body: the body's own report.
        spoken: voice tickets whose speech has ended.
    """

    def __init__(self) -> None:
        self.now_s = 0.0
        self.body = BodyState()
        self.spoken: frozenset[int] = frozenset()


Act = Generator[Bid | None, None, Verdict]


def counted(act: Node) -> int:
    """How often it is to be done: "twice" is 2."""
    for node in act.modifiers("cnt"):
        if node.literal and node.literal.isdigit():
            return int(node.literal)
    return 1


@dataclass(frozen=True, slots=True)
class Call:
    """A grounding function is called on an action node.

    Attributes:
        act: the action; the whole net can be read from it.
        depth: level up to which nodes and words count.
        ticket: number of this action, for its bids.
        fresh: gives further tickets, for an action of several motions.
        endless: it is to go on until it is ended from outside: "drive until something is close" has no distance.
    """

    act: Node
    depth: int
    ticket: int
    fresh: Callable[[], int] = int
    endless: bool = False

    @property
    def verb(self) -> str:
        """A word for the action, as it was said."""
        return min(self.act.lex, default="do")

    def modifiers(self, role: str) -> tuple[Node, ...]:
        """Predicates on the action by this role, in order."""
        return tuple(n for n in self.act.modifiers(role) if n.level <= self.depth)

    def words(self, role: str) -> frozenset[str]:
        """Every word, told or concluded, of the action's modifiers by this role."""
        return frozenset(
            word
            for node in self.modifiers(role)
            for word in node.words()
            if node.known_as(word, self.depth)
        )

    def degree(self, node: Node) -> frozenset[str]:
        """Words of degree on a node: very, little, fully."""
        return frozenset(
            word for n in node.modifiers("deg") if n.level <= self.depth for word in n.words()
        )

    def amount(self) -> tuple[float, str] | None:
        """Number and unit of the action's amount, or None.

        Raises:
            NotGroundedError: the amount is no number.
        """
        for node in self.modifiers("amt"):
            unit = min(node.lex, default="")
            written = node.literal or "1"
            try:
                number = float(written)
            except ValueError:
                number = math.nan
            if not math.isfinite(number):
                raise NotGroundedError(self.verb, written)
            return number, unit
        return None

    def argument(self, role: str) -> Node | None:
        """What the action points to by the role."""
        return next(self.act.to(role), None)


GroundingCode = Callable[[Call, Tick], Act]


@dataclass(frozen=True, slots=True)
class Grounding:
    """A registered grounding function: name, verbs it carries out, code."""

    name: str
    verbs: tuple[str, ...]
    code: GroundingCode


GROUNDINGS: Final[dict[str, Grounding]] = {}


def grounding_function(
    name: str, verbs: tuple[str, ...] = ()
) -> Callable[[GroundingCode], GroundingCode]:
    """Register a grounding function; every verb gets an operator DO[verb] -> FCN[name].

    Raises:
        ValueError: the name is taken.
    """

    def register(code: GroundingCode) -> GroundingCode:
        if name in GROUNDINGS:
            raise ValueError(f"grounding function {name} is registered twice")
        GROUNDINGS[name] = Grounding(name, verbs, code)
        return code

    return register
