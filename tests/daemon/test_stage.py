"""The virtual stage: time that passes only when asked to."""

from itertools import pairwise

import pytest

from daemon import events as ev
from daemon.stage import AT_MOST_S, SETTLE_S, Stage
from kernel.memory.meaning import Utterance


@pytest.fixture
def stage() -> Stage:
    return Stage(0, lambda _: None)


def test_it_begins_with_the_link_up_and_the_robot_at_rest(stage: Stage) -> None:
    assert stage.parts.link.connected
    assert (stage.world.truth().x_cm, stage.world.truth().grip) == (0, 1)


def test_time_runs_as_long_as_asked(stage: Stage) -> None:
    began_s = stage.now_s
    stage.run(1.25)
    assert stage.now_s - began_s == pytest.approx(1.25)


def test_until_idle_is_short_where_nothing_goes_on(stage: Stage) -> None:
    began_s = stage.now_s
    stage.run(None)
    assert stage.now_s - began_s == pytest.approx(SETTLE_S, abs=0.05)


def test_what_is_due_happens_at_its_time_and_keeps_the_stage_busy(stage: Stage) -> None:
    began_s = stage.now_s
    happened: list[float] = []
    stage.at(began_s + 2.0, lambda: happened.append(stage.now_s - began_s))
    stage.at(began_s + 1.0, lambda: happened.append(stage.now_s - began_s))
    stage.run(None)
    assert happened == pytest.approx([1.0, 2.0], abs=0.006)
    assert stage.now_s - began_s < AT_MOST_S


def test_a_turn_has_its_events_and_samples(stage: Stage) -> None:
    stage.begin_turn()
    stage.hear(Utterance("drive forward"))
    stage.run(None)
    turn = stage.turn()
    assert any(isinstance(event, ev.ActionEnded) for event in turn.events)
    assert turn.samples[-1].x_cm - turn.samples[0].x_cm == pytest.approx(20, abs=2)
    gaps = [b.t_s - a.t_s for a, b in pairwise(turn.samples)]
    assert max(gaps) <= 0.051


def test_a_restart_is_a_new_robot_at_a_later_time(stage: Stage) -> None:
    stage.hear(Utterance("drive forward"))
    stage.run(None)
    before_s = stage.now_s
    stage.restart()
    assert stage.now_s >= before_s
    assert stage.world.truth().x_cm == 0
    assert stage.parts.link.connected


def test_closing_tells_the_last_pose() -> None:
    events: list[ev.Event] = []
    Stage(0, events.append).close()
    assert isinstance(events[-1], ev.Pose)
