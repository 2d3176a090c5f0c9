"""The simulated forklift and its world, from above: pymunk physics in centimetres, in fixed steps of 5 ms.

Pulse widths go in, converted sensor values come out; nothing else reaches the body. The pose is for judging.
Floor friction and the grip of the wheels are joints, so the inner loop stays in C.
"""

from __future__ import annotations

import math
import random
from dataclasses import replace

import pymunk

from firmware_proto.pulses import Pulses
from kernel.bodies.forklift import figures
from kernel.bodies.forklift.scene import Scene, Thing, Truth

STEP_S = 0.005
WHEEL_LAG_S = 0.04  # a wheel comes up to speed, and slows down, with this time constant
TRACTION, TURNING_TRACTION = 2.0e5, 1.0e6  # g cm/s2 and g cm2/s2: the wheels slip beyond that
ROBOT_G, BLOCK_G_CM2 = 600.0, 3.0
FLOOR_FRICTION_CM_S2 = 300.0
FINGERS_PER_S = 2.0
GRIP_SPAN_CM = 5.0  # things up to this wide fit between the pads
MISS_CM = 0.4  # the pads close beside what is farther than this from their middle
RANGE_NOISE_ADC, BATTERY_NOISE_ADC = 1.5, 1.0
BATTERY_V, BATTERY_SAG_V, BATTERY_V_PER_S = 8.2, 0.2, 2.0e-4

ROBOT, BEAM, TALL, LOW = 1, 2, 4, 8
GHOST = 16  # what follows the robot: the beam sees it, nothing touches it


class _Placed:
    """A thing and its physics. follows: the pose it keeps in the robot's frame."""

    def __init__(self, thing: Thing) -> None:
        self.thing = thing
        self.follows: tuple[float, float, float] | None = None
        self.joints: list[pymunk.Constraint] = []
        self.floor: list[pymunk.Constraint] = []
        mass = BLOCK_G_CM2 * thing.along_cm * thing.across_cm
        if thing.fixed:
            self.body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        elif thing.round:
            self.body = pymunk.Body(mass, pymunk.moment_for_circle(mass, 0, thing.along_cm / 2))
        else:
            self.body = pymunk.Body(
                mass, pymunk.moment_for_box(mass, (thing.along_cm, thing.across_cm))
            )
        self.shape: pymunk.Shape
        if thing.round:
            self.shape = pymunk.Circle(self.body, thing.along_cm / 2)
        else:
            self.shape = pymunk.Poly.create_box(self.body, (thing.along_cm, thing.across_cm))
        self.shape.friction = 0.3
        self.body.position = (thing.x_cm, thing.y_cm)
        self.body.angle = thing.turned_rad
        self.mass = mass

    def now(self) -> Thing:
        """The thing where it is now."""
        x, y = self.body.position
        return replace(self.thing, x_cm=x, y_cm=y, turned_rad=self.body.angle)


class Twin:
    """The world. advance() goes one step of 5 ms; the same calls with the same seed give the same numbers."""

    def __init__(self, scene: Scene, seed: int) -> None:
        self._chance = random.Random(seed)
        self._space = pymunk.Space()
        self._space.iterations = 8
        self._space.collision_slop = 0.02
        self._space.sleep_time_threshold = 0.3
        self._space.idle_speed_threshold = 0.2
        self._placed: list[_Placed] = []
        self._followers: list[_Placed] = []
        self._left_m_s = self._right_m_s = 0.0
        self._lift, self._opening = 0.0, 1.0
        self._held: _Placed | None = None
        self._drained_v = 0.0
        self._robot = self._build_robot(scene)
        for thing in scene.things:
            self.put(thing)

    def _build_robot(self, scene: Scene) -> pymunk.Body:
        body = pymunk.Body(ROBOT_G, pymunk.moment_for_box(ROBOT_G, (14, 12)))
        body.position = (scene.x_cm, scene.y_cm)
        body.angle = scene.heading_rad
        fork, side, inner = figures.FRONT_CM, figures.SIDE_CM, figures.FORK_OPENING_CM / 2
        face, back = figures.SENSOR_CM, figures.BACK_CM
        outline = [
            [(back, -side), (face, -side), (face, side), (back, side)],
            [(face, inner), (fork, inner), (fork, inner + 0.6), (face, inner + 0.6)],
            [(face, -inner - 0.6), (fork, -inner - 0.6), (fork, -inner), (face, -inner)],
        ]
        shapes = [pymunk.Poly(body, corners) for corners in outline]
        for shape in shapes:
            shape.friction = 0.3
            shape.filter = pymunk.ShapeFilter(group=1, categories=ROBOT, mask=TALL | LOW)
        self._wheels = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        rolling = pymunk.PivotJoint(self._wheels, body, (0, 0), (0, 0))
        turning = pymunk.GearJoint(self._wheels, body, 0, 1)
        rolling.max_bias = turning.max_bias = 0
        rolling.max_force, turning.max_force = TRACTION, TURNING_TRACTION
        self._space.add(body, *shapes, rolling, turning)
        return body

    # ---- the robot ------------------------------------------------------------------------------------------

    def advance(self, pulses: Pulses) -> None:
        """One step of 5 ms with these pulse widths."""
        gain = STEP_S / WHEEL_LAG_S
        self._left_m_s += (figures.wheel_speed_m_s(pulses.left_us) - self._left_m_s) * gain
        self._right_m_s += (figures.wheel_speed_m_s(pulses.right_us) - self._right_m_s) * gain
        speed_cm_s = (self._left_m_s + self._right_m_s) * 50
        angle = self._robot.angle
        self._wheels.velocity = (speed_cm_s * math.cos(angle), speed_cm_s * math.sin(angle))
        self._wheels.angular_velocity = (self._right_m_s - self._left_m_s) / figures.TRACK_M
        self._space.step(STEP_S)
        self._follow()
        self._lift = figures.servo_fraction(pulses.lift_us)
        self._close_or_open(figures.servo_fraction(pulses.grip_us))
        self._drained_v += BATTERY_V_PER_S * STEP_S * (1 + 20 * abs(speed_cm_s) / 100)

    def sensors(self) -> figures.Sensors:
        """What the converter reads now, noise and all."""
        loaded = abs(self._left_m_s) + abs(self._right_m_s) > 0.01
        noise = self._chance.gauss
        volts = figures.range_volts(self._ray_cm())
        battery = BATTERY_V - self._drained_v - (BATTERY_SAG_V if loaded else 0.0)
        return figures.Sensors(
            figures.to_adc(volts + noise(0, RANGE_NOISE_ADC) * figures.ADC_VOLTS / figures.ADC_MAX),
            round(self._opening * figures.ADC_MAX),
            figures.to_adc(
                battery + noise(0, BATTERY_NOISE_ADC) * 10 / figures.ADC_MAX,
                figures.BATTERY_FULL_SCALE_V,
            ),
        )

    def _ray_cm(self) -> float | None:
        """From the sensor to the nearest thing tall enough, None if none is in reach."""
        far = figures.FRONT_CM + figures.REACH_CM + 5
        start = self._robot.local_to_world((figures.SENSOR_CM, 0))
        end = self._robot.local_to_world((far, 0))
        seen = pymunk.ShapeFilter(categories=BEAM, mask=TALL | GHOST)
        hit = self._space.segment_query_first(start, end, 0, seen)
        return None if hit is None else hit.alpha * (far - figures.SENSOR_CM)

    def _close_or_open(self, wanted: float) -> None:
        if self._held is not None and self._held not in self._placed:
            self._held = None
        step = FINGERS_PER_S * STEP_S
        if wanted > self._opening:
            self._opening = min(wanted, self._opening + step)
            if self._held is not None and self._opening > self._width(self._held) + 0.02:
                self._let_go()
            return
        if wanted == self._opening:
            return
        closing = max(wanted, self._opening - step)
        caught = self._held or self._between()
        if caught is not None and closing <= self._width(caught):
            self._opening = max(closing, min(self._opening, self._width(caught)))
            if self._held is None:
                self._hold(caught)
            return
        self._opening = closing

    def _width(self, placed: _Placed) -> float:
        """The opening at which the pads touch a thing."""
        if placed.thing.round:
            width_cm = placed.thing.along_cm
        else:
            turned = (placed.body.angle - self._robot.angle) % math.pi
            lengthwise = math.pi / 4 < turned < 3 * math.pi / 4
            width_cm = placed.thing.along_cm if lengthwise else placed.thing.across_cm
        return width_cm / figures.FORK_OPENING_CM

    def _between(self) -> _Placed | None:
        """What stands between the pads and fits; a gripper beside its thing misses."""
        pads = self._robot.local_to_world((figures.PADS_CM, 0))
        for placed in self._placed:
            if placed.follows is not None or placed.thing.fixed:
                continue
            reached = placed.shape.point_query(pads).distance < MISS_CM
            if reached and self._width(placed) * figures.FORK_OPENING_CM <= GRIP_SPAN_CM:
                return placed
        return None

    def _hold(self, placed: _Placed) -> None:
        robot, body = self._robot, placed.body
        x, _ = robot.world_to_local(body.position)
        body.position = robot.local_to_world((x, 0))  # the pads centre it
        placed.joints = [
            pymunk.PivotJoint(robot, body, robot.world_to_local(body.position), (0, 0)),
            pymunk.GearJoint(robot, body, body.angle - robot.angle, 1),
        ]
        self._space.add(*placed.joints)
        self._held = placed

    def _let_go(self) -> None:
        placed, self._held = self._held, None
        if placed is not None:
            self._space.remove(*placed.joints)
            placed.joints = []

    # ---- the world ------------------------------------------------------------------------------------------

    @property
    def things(self) -> tuple[Thing, ...]:
        """Everything there is, where it is now, in the order it came."""
        return tuple(placed.now() for placed in self._placed)

    def truth(self) -> Truth:
        """The robot as it really is."""
        x, y = self._robot.position
        ray_cm = self._ray_cm()
        ahead_cm = None if ray_cm is None else ray_cm - (figures.FRONT_CM - figures.SENSOR_CM)
        return Truth(
            x,
            y,
            self._robot.angle,
            self._lift,
            self._opening,
            None if self._held is None else self._held.now(),
            None if ahead_cm is None or ahead_cm > figures.REACH_CM else max(0.0, ahead_cm),
        )

    def put(self, thing: Thing, follows: bool = False) -> None:
        """Put a thing where it says; it keeps its place in the robot's frame if it follows the robot."""
        placed = _Placed(thing)
        if follows:
            x, y = self._robot.world_to_local((thing.x_cm, thing.y_cm))
            placed.follows = (x, y, thing.turned_rad - self._robot.angle)
            self._followers.append(placed)
        self._filter(placed)
        self._placed.append(placed)
        self._space.add(placed.body, placed.shape)
        if placed.body.body_type == pymunk.Body.DYNAMIC:
            floor = self._space.static_body
            sliding = pymunk.PivotJoint(floor, placed.body, placed.body.position, (0, 0))
            spinning = pymunk.GearJoint(floor, placed.body, 0, 1)
            sliding.max_bias = spinning.max_bias = 0
            sliding.max_force = placed.mass * FLOOR_FRICTION_CM_S2
            spinning.max_force = sliding.max_force * placed.thing.along_cm / 3
            placed.floor = [sliding, spinning]
            self._space.add(*placed.floor)
        self._space.reindex_shapes_for_body(placed.body)

    def take(self, number: int) -> Thing:
        """Take away the thing at this place in things."""
        placed = self._placed[number]
        if placed is self._held:
            self._let_go()
        del self._placed[number]
        self._followers = [other for other in self._followers if other is not placed]
        self._space.remove(placed.shape, placed.body, *placed.floor)
        return placed.now()

    def clearance_cm(self, number: int) -> float:
        """From the robot's outline to the nearest point of a thing, about."""
        shape = self._placed[number].shape
        outline = [(x, y) for x in (-7.0, 0.0, 7.0) for y in (-6.0, 0.0, 6.0)]
        return min(shape.point_query(self._robot.local_to_world(p)).distance for p in outline)

    def is_held(self, number: int) -> bool:
        """Whether the gripper has it."""
        return self._placed[number] is self._held

    def to_world(self, x_cm: float, y_cm: float) -> tuple[float, float]:
        """A point of the robot's frame in the world."""
        x, y = self._robot.local_to_world((x_cm, y_cm))
        return x, y

    def _filter(self, placed: _Placed) -> None:
        if placed.follows is not None:
            categories, mask = (0 if placed.thing.low else GHOST), BEAM
        else:
            categories, mask = (LOW if placed.thing.low else TALL), ROBOT | TALL | LOW | BEAM
        placed.shape.filter = pymunk.ShapeFilter(categories=categories, mask=mask)

    def _follow(self) -> None:
        for placed in self._followers:
            if placed.follows is not None:
                x, y, turned = placed.follows
                placed.body.position = self._robot.local_to_world((x, y))
                placed.body.angle = self._robot.angle + turned
                self._space.reindex_shapes_for_body(placed.body)
