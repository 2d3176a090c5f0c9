"""What a turn is judged by."""

import pytest

from daemon import events as ev
from daemon.dialogue import Insert, Place, Remove, WorldStep, parse
from daemon.recorder import Recorder, change, sample
from kernel.bodies.forklift.simulated import SimulatedForklift, World


@pytest.fixture
def world() -> World:
    return SimulatedForklift().world


def lines(text: str) -> list[WorldStep]:
    return [step for step in parse(text).steps if isinstance(step, Place | Insert | Remove)]


def test_what_a_world_line_says_is_done(world: World) -> None:
    for step in lines("world: wall 30 cm ahead\nworld: low red block between the fingers"):
        change(world, step)
    assert [(thing.noun, thing.colour, thing.low) for thing in world.things] == [
        ("wall", None, False),
        ("block", "red", True),
    ]
    assert world.truth().range_cm == pytest.approx(30, abs=0.5)


def test_the_same_noun_again_moves_the_thing(world: World) -> None:
    for step in lines("world: wall 30 cm ahead\nworld: wall 4 cm ahead"):
        change(world, step)
    assert len(world.things) == 1
    assert world.truth().range_cm == pytest.approx(4, abs=0.5)


def test_two_colours_are_two_things(world: World) -> None:
    for step in lines("world: red block 20 cm left\nworld: blue block 20 cm right"):
        change(world, step)
    assert len(world.things) == 2


@pytest.mark.parametrize(("line", "left"), [("nothing within 40 cm", 1), ("clear", 0)])
def test_things_are_taken_away(world: World, line: str, left: int) -> None:
    for step in lines(f"world: cup 5 cm behind\nworld: ball 60 cm left\nworld: {line}"):
        change(world, step)
    assert len(world.things) == left


def test_a_sample_tells_where_the_robot_is(world: World) -> None:
    now = sample(world, 1.5)
    assert (now.t_s, now.x_cm, now.heading_deg, now.held) == (1.5, 0, 0, "")
    assert now.grip_permille == 1000


def test_a_turn_has_what_happened_since_it_began(world: World) -> None:
    seen: list[float] = []
    recorder = Recorder(lambda now: seen.append(now.t_s))
    recorder.begin(sample(world, 0.0))
    recorder.happen(ev.Acknowledged(t=0.1, text="old"))
    recorder.begin(sample(world, 1.0))
    recorder.happen(ev.Acknowledged(t=1.1, text="new"))
    recorder.move(sample(world, 1.5))
    recorder.move(sample(world, 1.5))
    turn = recorder.turn(sample(world, 2.0))
    assert turn.events == (ev.Acknowledged(t=1.1, text="new"),)
    assert [now.t_s for now in turn.samples] == [1.0, 1.5, 2.0]
    assert (turn.began_s, turn.ended_s) == (1.0, 2.0)
    assert seen == [0.0, 1.0, 1.5, 2.0]
