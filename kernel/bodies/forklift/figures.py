"""The forklift in figures: its size, its wheels, its sensors. The body reckons with them, the twin is built to them.

Lengths in the robot's frame: x ahead of the axle, y to the left. The paper gives no figures; these are our choice
for a 14 x 12 cm robot with a Sharp rangefinder of the 4 to 30 cm class.
"""

from __future__ import annotations

from dataclasses import dataclass

from firmware_proto.pulses import NEUTRAL_US, SERVO_ZERO_US, WHEEL_US_PER_PERMILLE

FRONT_CM = 7.0  # of the gripper
BACK_CM = -7.0
SIDE_CM = 6.0
SENSOR_CM = 3.0  # 4 cm behind the gripper's front
PADS_CM = 5.0  # the middle of the gripper's pads
TRACK_M = 0.10  # between the wheels
FULL_SPEED_M_S = 0.50  # a wheel at 1000 permille
REACH_CM = 40.0  # of the rangefinder, from the gripper's front
FORK_OPENING_CM = 6.4  # between the open fingers

ADC_MAX = 4095
ADC_VOLTS = 5.0
FLOOR_VOLTS = 0.15  # the rangefinder sees nothing
PEAK_CM = 3.0  # nearer than this the sensor's voltage falls again
CURVE_V_CM, CURVE_CM = 12.0, 0.42
BATTERY_FULL_SCALE_V = 10.0


@dataclass(frozen=True, slots=True)
class Sensors:
    """What the three converter channels read, 0 to 4095."""

    range_adc: int
    grip_adc: int
    battery_adc: int


def wheel_permille(speed_m_s: float, rate_rad_s: float) -> tuple[int, int]:
    """Left and right for a speed and a turning rate; what is too fast is slowed down on the same arc."""
    left = speed_m_s - rate_rad_s * TRACK_M / 2
    right = speed_m_s + rate_rad_s * TRACK_M / 2
    scale = 1000 / max(FULL_SPEED_M_S, abs(left), abs(right))
    return round(left * scale), round(right * scale)


def wheel_speed_m_s(pulse_us: int) -> float:
    """What a wheel does at a pulse width, once it has come up to speed."""
    return (pulse_us - NEUTRAL_US) / WHEEL_US_PER_PERMILLE / 1000 * FULL_SPEED_M_S


def servo_fraction(pulse_us: int) -> float:
    """Lift or gripper, 0 to 1."""
    return (pulse_us - SERVO_ZERO_US) / 1000


def range_volts(distance_cm: float | None) -> float:
    """The rangefinder's voltage for a distance from the sensor; None: nothing there."""
    if distance_cm is None:
        return FLOOR_VOLTS
    if distance_cm < PEAK_CM:
        return range_volts(PEAK_CM) * (0.2 + 0.8 * distance_cm / PEAK_CM)
    return CURVE_V_CM / (distance_cm + CURVE_CM)


def range_m(adc: int) -> float | None:
    """Distance from the gripper's front; None if nothing is within reach, 0 if it is inside the fork."""
    volts = adc * ADC_VOLTS / ADC_MAX
    if volts <= FLOOR_VOLTS:
        return None
    ahead_cm = CURVE_V_CM / volts - CURVE_CM - (FRONT_CM - SENSOR_CM)
    return None if ahead_cm > REACH_CM else max(0.0, ahead_cm) / 100


def to_adc(volts: float, full_scale_v: float = ADC_VOLTS) -> int:
    """A voltage as the converter reads it."""
    return min(max(round(volts / full_scale_v * ADC_MAX), 0), ADC_MAX)
