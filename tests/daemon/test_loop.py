"""The cycle: what is said moves the robot, what is not understood never does, stop comes first, and nothing is lost."""

from __future__ import annotations

import random
import sys
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest

from daemon import events
from daemon.store import Store
from daemon.understanding import halts, is_stop, understand
from daemon.writer import Kept, NotKept
from firmware_proto.messages import Drive, Heartbeat, Stop
from kernel.memory.change import Change
from kernel.memory.exchange import Inputs
from kernel.memory.meaning import Control, Feedback, Utterance
from kernel.memory.notation import read

sys.path.insert(0, str(Path(__file__).parent))
from bench import Bench


def endings(bench: Bench) -> list[tuple[str, str]]:
    """What each utterance came to."""
    return [(e.utterance, e.verdict) for e in bench.all(events.Ended) if e.utterance]


def test_a_command_moves_the_robot_and_is_told_from_beginning_to_end() -> None:
    bench = Bench()
    bench.say("drive forward")
    assert bench.x_cm == pytest.approx(20, abs=2)
    told = [
        events.name(e) for e in bench.told if not isinstance(e, (*events.INTERNAL, events.Pose))
    ]
    assert told == ["link", "heard", "understood", "action_started", "action_ended"]
    (ended,) = bench.all(events.ActionEnded)
    assert (ended.function, ended.verdict) == ("base_drive", "succeeded")
    (pose,) = [pose for pose in bench.all(events.Pose) if pose.t == ended.t]
    assert pose.x_cm == pytest.approx(bench.x_cm, abs=2)
    assert endings(bench) == [("drive forward", "succeeded")]


@pytest.mark.parametrize(
    "text", ["then the if of slowly block the", "", "   ", "\x00", "drive " * 200, "fárðu áfram"]
)
def test_what_is_not_understood_moves_nothing_and_is_told(text: str) -> None:
    bench = Bench()
    bench.say(text)
    assert bench.x_cm == pytest.approx(0, abs=0.1)
    (told,) = bench.all(events.NotUnderstood)
    assert told.reason
    assert bench.all(events.SayStarted)
    assert not bench.all(events.ActionStarted)


def test_a_lesson_is_told_once_it_is_durable_and_its_words_are_known_from_then_on() -> None:
    class SlowKeeper:
        waiting: tuple[int, Change] | None = None
        done: bool = False

        def keep(self, key: int, change: Change, source: str = "") -> None:
            self.waiting = (key, change)
            self.source = source

        def results(self) -> list[Kept | NotKept]:
            if self.waiting is None or not self.done:
                return []
            (key, change), self.waiting = self.waiting, None
            learned = tuple(replace(lesson, ident=17) for lesson in change.learned)
            return [Kept(key, replace(change, ident=5, learned=learned))]

    keeper = SlowKeeper()
    bench = Bench(keeper=keeper)
    bench.say("to widdle turn left", "Mary", wait=False)
    bench.run(2)
    assert not bench.all(events.Lesson)
    assert not bench.all(events.Acknowledged)
    assert not bench.cycle.settled
    assert keeper.source == "typed"
    keeper.done = True
    bench.run(until=lambda: bench.cycle.idle)
    (lesson,) = bench.all(events.Lesson)
    assert (lesson.ident, lesson.kind, lesson.teacher.lower()) == (17, "procedure", "mary")
    (acknowledged,) = bench.all(events.Acknowledged)
    assert acknowledged.text
    assert bench.told.index(lesson) < bench.told.index(acknowledged)
    assert bench.cycle.vocabulary.knows("widdle")


def test_a_lesson_that_cannot_be_kept_is_not_acknowledged() -> None:
    class FullDisk:
        waiting: tuple[NotKept, ...] = ()

        def keep(self, key: int, change: Change, source: str = "") -> None:
            self.waiting = (NotKept(key, "database or disk is full"),)

        def results(self) -> list[Kept | NotKept]:
            results, self.waiting = list(self.waiting), ()
            return results

    bench = Bench(keeper=FullDisk())
    bench.say("to hop drive forward")
    assert not bench.all(events.Acknowledged)
    assert bench.all(events.Error)[0].text == "database or disk is full"
    assert [reply.ok for reply in bench.all(events.Replied)] == [False]
    bench.say("hop")
    assert bench.x_cm == pytest.approx(0, abs=0.1)


def test_taught_before_a_restart_and_danced_after_it(tmp_path: Path) -> None:
    store = Store.open(tmp_path / "lessons.sqlite")
    before = Bench(store)
    before.say("to cha-cha drive forward then drive backwards")
    before.say("to dance cha-cha")
    store.close()
    store = Store.open(tmp_path / "lessons.sqlite")
    after = Bench(store)
    after.say("dance")
    verbs = [started.words for started in after.all(events.ActionStarted)]
    assert [("forward" in words, "backward" in words) for words in verbs] == [
        (True, False),
        (False, True),
    ]
    assert all(ended.verdict == "succeeded" for ended in after.all(events.ActionEnded))
    store.close()


@pytest.mark.parametrize(
    "text", ["stop", "Stop!", "halt", "freeze", "robot stop", "stop stop", "please stop, robot"]
)
def test_stop_is_on_the_wire_before_the_mind_has_thought(text: str) -> None:
    bench = Bench()
    bench.say("drive forward", wait=False)
    bench.run(0.5)
    moment_s = bench.link.now_s
    bench.cycle.hear(Utterance(text))  # no step
    assert [m for at, m in bench.sent() if at >= moment_s and isinstance(m, Stop)]
    bench.run(1)
    assert not [m for at, m in bench.sent() if at > moment_s and isinstance(m, Drive)]
    assert bench.all(events.ActionEnded)[0].verdict == "stopped"


@pytest.mark.parametrize("faults", ["none", "lossy"])
def test_no_wheel_command_follows_a_stop_whenever_it_comes(faults: str) -> None:
    chance = random.Random(1)
    bench = Bench(faults=faults, seed=2)
    for _ in range(12):
        bench.say("drive forward then turn left then drive backwards", wait=False)
        bench.run(chance.uniform(0.0, 3.0))
        bench.cycle.stop("spotted")
        moment_s = bench.link.now_s
        bench.run(until=lambda: bench.cycle.idle)
        bench.run(0.5)
        after = [m for at, m in bench.sent() if at > moment_s and isinstance(m, Drive)]
        assert all(m.left_permille == m.right_permille == 0 for m in after)
        bench.run(until=lambda: bench.link.connected)
    assert bench.x_cm < 200


@pytest.mark.parametrize("text", ["drive forward", "go on", "repeat that"])
def test_a_command_heard_before_a_stop_and_understood_after_it_is_dropped(text: str) -> None:
    bench = Bench()
    bench.say("drive forward one meter", wait=False)
    bench.run(0.3)
    bench.cycle.stop("control")
    bench.run(1)
    there_cm, told = bench.x_cm, len(endings(bench))
    utterance = Utterance(text)
    epoch = bench.cycle.begin(utterance)
    meanwhile = understand(utterance, bench.cycle.vocabulary)
    bench.cycle.stop("spotted")
    bench.cycle.take(meanwhile, epoch)
    bench.run(2)
    assert bench.x_cm == pytest.approx(there_cm, abs=0.1)
    assert endings(bench)[told:] == [(text, "stopped")]


def test_a_command_that_waits_for_the_mind_when_stop_comes_is_dropped_but_a_lesson_is_not() -> None:
    bench = Bench()
    bench.cycle.hear(Utterance("to hop drive forward"))
    bench.cycle.hear(Utterance("drive forward"))
    bench.cycle.hear(Utterance("stop"))
    bench.run(2)
    assert bench.x_cm == pytest.approx(0, abs=0.1)
    assert [lesson.words for lesson in bench.all(events.Lesson)] == ["to hop drive forward"]
    bench.say("drive forward")
    assert bench.x_cm == pytest.approx(20, abs=2)


@pytest.mark.parametrize("text", ["go on", "repeat that"])
def test_what_was_broken_off_is_not_taken_up_by_words_before_the_stop(text: str) -> None:
    bench = Bench()
    bench.say("drive forward")
    bench.say("drive forward one meter", wait=False)
    bench.run(0.5)
    bench.cycle.stop("control")
    bench.run(1)
    there_cm = bench.x_cm
    bench.cycle.hear(Utterance(text))
    bench.cycle.stop("control")
    bench.run(2)
    assert bench.x_cm == pytest.approx(there_cm, abs=0.5)
    assert endings(bench)[-1] == (text, "stopped")


def test_stop_ends_what_is_being_said() -> None:
    bench = Bench()
    bench.say("say one two three four five six seven eight", wait=False)
    bench.run(1)
    bench.cycle.stop("control")
    (ended,) = bench.all(events.SayEnded)
    assert ended.cut


def test_a_mind_that_breaks_stops_the_wheels_and_the_daemon_goes_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    bench = Bench()
    bench.say("drive forward", wait=False)
    bench.run(0.5)

    def broken(inputs: Inputs) -> NoReturn:
        raise ZeroDivisionError("division by zero")

    with monkeypatch.context() as patch:
        patch.setattr(bench.cycle.mind, "tick", broken)
        moment_s = bench.link.now_s
        bench.run(1)
        assert bench.cycle.failures == 29
    (error,) = bench.all(events.Error)
    assert error.text == "ZeroDivisionError: division by zero"
    assert [s.source for s in bench.all(events.Stopped)] == ["crash"]
    after = [type(m) for at, m in bench.sent() if moment_s < at < moment_s + 0.98]
    assert Stop in after
    assert Drive not in after
    assert Heartbeat not in after  # the lease ends as well: nobody is at the helm
    stopped_cm = bench.x_cm
    bench.run(until=lambda: bench.cycle.idle)
    assert bench.cycle.failures == 0
    assert bench.x_cm == pytest.approx(stopped_cm, abs=1)
    bench.run(until=lambda: bench.link.connected)
    bench.say("drive forward")
    assert bench.x_cm == pytest.approx(stopped_cm + 20, abs=2.5)


def test_a_sentence_that_breaks_the_parser_is_told_and_nothing_else_happens(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def broken(*_: object) -> NoReturn:
        raise KeyError("act-1")

    bench = Bench()
    with monkeypatch.context() as patch:
        patch.setattr("daemon.understanding.parse", broken)
        bench.say("drive forward")
    assert "KeyError" in bench.all(events.Error)[0].text
    assert bench.all(events.NotUnderstood)
    assert bench.cycle.failures == 0
    assert not bench.all(events.Stopped)


def test_without_steps_the_lease_ends_and_the_robot_stops_by_itself() -> None:
    bench = Bench()
    bench.say("drive forward one meter", wait=False)
    bench.run(0.5)
    hung_cm = bench.x_cm
    bench.run(3, step=False)
    assert bench.x_cm - hung_cm < 12  # 300 ms at 20 cm/s, and rolling out


def test_a_lost_link_fails_the_motion_is_told_and_is_not_resumed() -> None:
    bench = Bench()
    bench.say("drive forward one meter", wait=False)
    bench.run(0.5)
    bench.link.cut()
    bench.run(until=lambda: not bench.link.connected)
    bench.run(1)
    assert bench.all(events.ActionEnded)[0].verdict == "failed"
    lost_cm = bench.x_cm
    bench.say("drive forward")
    assert bench.all(events.ActionEnded)[1].verdict == "failed"
    bench.link.restore()
    bench.run(until=lambda: bench.link.connected)
    bench.run(2)
    assert bench.x_cm == pytest.approx(lost_cm, abs=1)
    ups = [link.up for link in bench.all(events.Link)]
    assert ups[0]
    assert not ups[1]
    assert ups[-1]
    bench.say("drive forward")
    assert bench.x_cm == pytest.approx(lost_cm + 20, abs=2.5)


def test_the_same_seed_tells_the_same_story() -> None:
    stories = []
    for _ in range(2):
        bench = Bench(seed=5, faults="lossy")
        bench.say("to bow lower the lift then raise the lift")
        bench.say("bow")
        bench.say("turn left")
        stories.append(bench.lines())
    assert stories[0] == stories[1]


@pytest.mark.parametrize(
    ("text", "is_one"),
    [
        ("stop", True),
        ("STOP!!", True),
        ("robot, freeze", True),
        ("hey sayso halt please", True),
        ("robot", False),
        ("", False),
        ("to stop say hi", False),
        ("stop turning", True),
        ("please stop it right now", True),
        ("stop's", False),
        ("don't say stop", False),
        ("don't stop", False),
        ("unstop", False),
    ],
)
def test_stop_words(text: str, is_one: bool) -> None:
    assert is_stop(text) is is_one


@pytest.mark.parametrize(
    ("text", "everything"),
    [
        ("stop turning", False),
        ("robot, stop turning please", False),
        ("quit turning", False),
        ("stop everything", True),
        ("stop turning you stupid zork", True),
        ("stop zorking blorks", True),
        ("stop", True),
        ("stop it now", True),
    ],
)
def test_only_what_is_understood_as_stopping_one_activity_spares_the_rest(
    text: str, everything: bool
) -> None:
    bench = Bench()
    bench.say("drive forward one meter and turn left slowly", wait=False)
    bench.say("raise the lift all the way", wait=False)
    bench.run(0.3)
    bench.say(text, wait=False)
    assert bool(bench.all(events.Stopped)) is everything
    bench.run(2.0)
    assert (bench.cycle.state.lift < 0.9) is everything
    assert (bench.x_cm < 15) is everything
    ended = [e for e in bench.all(events.ActionEnded) if e.function == "base_turn"]
    assert [e.verdict for e in ended] == ["stopped"]


def test_a_command_behind_stop_doing_still_runs_once_all_has_stopped() -> None:
    bench = Bench()
    bench.say("drive forward one meter", wait=False)
    bench.run(0.3)
    bench.say("stop turning then raise the lift")
    assert bench.all(events.Stopped)
    assert bench.cycle.state.lift > 0.4
    assert bench.x_cm < 15


def test_meanings_that_stop_everything() -> None:
    assert halts(Control("stop"))
    assert not halts(Control("stop", read("act-1 -lex- turn")))  # type: ignore[arg-type]
    assert halts(Feedback(good=False, stop=True))
    assert not halts(Control("undo"))
    assert not halts(Feedback(good=False))
