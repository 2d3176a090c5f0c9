"""Servo pulses: widths in microseconds and what slews them."""

from __future__ import annotations

from dataclasses import dataclass

NEUTRAL_US = 1500
WHEEL_US_PER_PERMILLE = 0.5
SERVO_ZERO_US = 1000  # lift down, gripper closed; one microsecond a permille
SLEW_MAX_PERMILLE_S = 4000


@dataclass(frozen=True, slots=True)
class Pulses:
    """Servo pulse widths in microseconds. Wheels: 1500 is neutral, more is forwards on both sides."""

    left_us: int
    right_us: int
    lift_us: int
    grip_us: int


@dataclass(slots=True)
class Slew:
    """One slewed servo, in permille."""

    at: float
    target: float
    rate: float = 0.0

    @property
    def moving(self) -> bool:
        """Not there yet."""
        return self.at != self.target

    def advance(self, dt_s: float) -> None:
        """Come dt_s closer to the target."""
        step = self.rate * dt_s
        self.at = min(max(self.target, self.at - step), self.at + step)

    def hold(self) -> None:
        """Stay here."""
        self.target = self.at
