"""Rehearsals end to end: real mind, real wire, simulated robot, virtual time."""

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from daemon import events as ev
from daemon.demo.script import AUDIO
from daemon.dialogue import parse
from daemon.rehearse import Played, main, rehearse

DRIVE = AUDIO / "01-drive-forward.wav"


def play(text: str, seed: int = 0) -> tuple[tuple[Played, ...], list[ev.Event]]:
    events: list[ev.Event] = []
    played = rehearse(parse(text), seed=seed, emit=events.append)
    return played, events


def holds(text: str) -> None:
    played, _ = play(text)
    failed = [outcome.diff() for act in played for outcome in act.outcomes if not outcome.ok]
    assert not failed, "\n".join(failed)
    assert any(outcome.expectation.checked for act in played for outcome in act.outcomes)


def file(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "dialogue.txt"
    path.write_text(text)
    return path


def test_a_command_is_judged_by_where_the_robot_really_went() -> None:
    holds("you: drive forward\nrobot: moves forward 18..22 cm; turns left 0..5 degrees")


def test_a_failed_expectation_gives_status_1_and_a_diff(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = file(tmp_path, "you: drive forward\nrobot: moves backward 15..25 cm\n")
    assert main(path) == 1
    told = capsys.readouterr().out
    assert "- expected: moves backward 15..25 cm" in told
    assert "+ happened: moves forward" in told
    assert "0 of 1 expectations held" in told


def test_json_has_events_alone_on_standard_output(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = file(tmp_path, "you: drive forward\nrobot: lifts\nrobot: waves\n")
    assert main(path, as_json=True) == 1
    out, err = capsys.readouterr()
    events: list[dict[str, Any]] = [json.loads(line) for line in out.splitlines()]
    assert "- expected: lifts" in err
    names = [event["event"] for event in events]
    assert names.index("heard") < names.index("understood") < names.index("action_started")
    assert events[-1]["event"] == "pose"
    assert events[-1]["x_cm"] == pytest.approx(20, abs=2)
    times = [event["t"] for event in events]
    assert times == sorted(times)


def test_a_pose_is_told_after_every_motion() -> None:
    _, events = play("you: drive forward then turn left")
    ends = [i for i, event in enumerate(events) if isinstance(event, ev.ActionEnded)]
    for end, limit in zip(ends, [*ends[1:], len(events)], strict=True):
        assert any(isinstance(event, ev.Pose) for event in events[end:limit])


def test_a_wrong_file_gives_status_2_and_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(file(tmp_path, "you: hi\nworld: wall\n")) == 2
    assert "line 2: 'world: wall'" in capsys.readouterr().err


def test_the_same_seed_gives_the_same_events() -> None:
    text = """
        you: to complain say no way
        you: to complain say forget it
        you: complain
        you: complain
        you: drive forward and turn right
        world: wall 4 cm ahead
        wait: 2 s
    """
    first, second = play(text, seed=7)[1], play(text, seed=7)[1]
    assert first == second
    assert any(play(text, seed=seed)[1] != first for seed in range(8, 12))


def test_a_wait_runs_exactly_that_long() -> None:
    _, events = play("you: drive forward\nwait: 0.5 s\nyou: stop\nwait: 3 s\nyou: stop")
    heard = [event.t for event in events if isinstance(event, ev.Stopped)]
    assert [round(b - a, 1) for a, b in pairwise(heard)] == [3.0]
    assert heard[0] == pytest.approx(0.5, abs=0.1)


def test_time_runs_until_idle_but_at_most_a_minute() -> None:
    _, events = play("you: wait for two minutes\nyou: drive forward")
    heard = [event.t for event in events if isinstance(event, ev.Heard)]
    assert heard[1] - heard[0] == pytest.approx(60, abs=0.2)


def test_a_restart_keeps_lessons_and_forgets_the_rest() -> None:
    holds("""
        you: to bow lower the lift then raise the lift
        you: raise the lift
        robot: lifts
        restart:
        you: bow
        robot: lifts
    """)


def test_who_speaks_is_known_by_name_or_not_at_all() -> None:
    holds("""
        you: if Rick tells you to do something don't but instead complain
        you: to complain say no way
        you(Rick): turn left
        robot: says "no way"; does not move
        you: turn left
        robot: does not move
        you(unknown): turn left
        robot: turns left 80..100 degrees
        you(Mary): turn left
        robot: turns left 80..100 degrees
    """)


def test_what_follows_the_robot_stays_before_it() -> None:
    holds("""
        world: wall 20 cm ahead, following the robot
        you: turn left
        you: if something is very close then drive backwards
        world: wall 4 cm ahead
        robot: moves backward 15..25 cm
    """)


def test_a_cut_link_fails_commands_and_comes_back() -> None:
    holds("""
        link: down
        wait: 2 s
        you: drive forward
        robot: refuses; does not move
        link: up
        wait: 4 s
        you: drive forward
        robot: moves forward 15..25 cm
    """)


def test_a_recording_is_heard_by_the_real_recogniser() -> None:
    played, events = play(f"audio: {DRIVE}\nrobot: moves forward 18..22 cm")
    assert all(act.ok for act in played)
    (heard,) = [event for event in events if isinstance(event, ev.Heard)]
    assert heard.text == "drive forward"
    assert 1.0 < heard.t < 3.0  # when its sound has ended, not when the file was read


def test_a_spoken_stop_is_spotted_before_it_is_heard_out() -> None:
    stop = Path(__file__).parent.parent / "dialogues" / "audio" / "stop.wav"
    _, events = play(f"you: drive forward for one meter\nwait: 0.5 s\naudio: {stop}")
    stopped = next(event.t for event in events if isinstance(event, ev.Stopped))
    heard = [event.t for event in events if isinstance(event, ev.Heard)][1]
    assert 0.5 < stopped < heard
