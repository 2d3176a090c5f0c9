"""The mind as a whole: foci side by side, stopping, waiting, forgetting, always the same."""

import math
from collections.abc import Callable
from typing import Any

import pytest

from kernel.action.call import MoveGrip, MoveLift, Rotate, Speak, Travel
from kernel.memory.attention import ROOM
from kernel.memory.exchange import Inputs
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Social
from kernel.memory.reply import Failed, Greeted, Halted
from kernel.memory.settings import Settings
from kernel.memory.working import TOLD_LIMIT
from kernel.mind import Mind
from kernel.net.node import WORKING
from tests.kernel.conftest import net

MakeLesson = Callable[..., Lesson]

FORWARD = "DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]"
TURN = "DO[ act-3 -lex- turn; dir-4 -lex- left; -dir-> act-3 ]"
RAISE = "DO[ act-5 -lex- raise ]"
WAIT = "DO[ act-6 -lex- wait; amt-7 -lex- second; -str- {}; -amt-> act-6 ]"
SAY = "DO[ act-8 -lex- say; -obj-> txt-9; txt-9 -str- {} ]"
BACK_OFF = """
    trig: NOTE[ hq-1 -lex- close; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1 ]
    pref: 1.0
    ---
    DO[ act-4 -lex- drive; dir-5 -lex- backward; -dir-> act-4 ]
"""


def play(*required: str, beside: tuple[str, ...] = ()) -> str:
    parts = "; ".join(required) + ("; WITH; " + "; ".join(beside) if beside else "")
    return f"PLAY{{; {parts}; }}"


# -- a command -----------------------------------------------------------------------------


def test_a_command_bids_in_the_tick_it_is_heard(robot: Any) -> None:
    robot.command(FORWARD)
    robot.tick()
    assert [bid.command for bid in robot.out.bids] == [Travel(0.2, 1.0)]
    assert robot.out.busy


def test_a_whole_dance_takes_no_tick_more_than_its_steps(robot: Any) -> None:
    robot.teach(
        f"trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; {FORWARD.replace('act-1', 'act-11')}; {TURN}"
    )
    began_s = robot.now_s
    moved = robot.do("DO[ act-1 -lex- dance ]")
    assert moved == [Travel(0.2, 1.0), Rotate(pytest.approx(math.pi / 2), pytest.approx(1.0))]
    assert robot.now_s - began_s == pytest.approx(2.0, abs=0.11)


def test_it_ends_when_the_body_says_so_and_not_before(robot: Any) -> None:
    robot.command(FORWARD)
    robot.pass_time(0.9)
    assert robot.out.bids
    robot.pass_time(0.3)
    assert not robot.out.bids
    assert not robot.out.busy
    assert robot.body.state.x_m == pytest.approx(0.2)


def test_one_bid_keeps_its_ticket_until_it_ends(robot: Any) -> None:
    robot.command(FORWARD)
    tickets = set()
    for _ in range(10):
        tickets |= {bid.ticket for bid in robot.tick().bids}
    assert len(tickets) == 1


# -- plays ---------------------------------------------------------------------------------


def test_parts_run_side_by_side(robot: Any) -> None:
    robot.command(play(FORWARD, RAISE, SAY.format("whee")))
    robot.tick()
    assert {type(bid.command) for bid in robot.out.bids} == {Travel, MoveLift}
    assert robot.said == ["whee"]


def test_travel_and_turn_in_one_play_are_an_arc(robot: Any) -> None:
    robot.command(play(FORWARD, TURN))
    robot.tick()
    assert {type(bid.command) for bid in robot.out.bids} == {Travel, Rotate}
    robot.settle()
    assert robot.body.state.x_m == pytest.approx(0.2)
    assert robot.body.state.heading_rad == pytest.approx(math.pi / 2)


def test_two_drives_in_one_play_are_a_conflict_and_told(robot: Any) -> None:
    back = "DO[ act-10 -lex- drive; dir-11 -lex- backward; -dir-> act-10 ]"
    assert robot.do(play(FORWARD, back)) == []
    assert robot.reasons == ["conflict"]


def test_one_required_part_that_fails_ends_the_others(robot: Any) -> None:
    robot.body.within_reach = False
    robot.command(play(FORWARD, "DO[ act-10 -lex- grab ]") + "; " + TURN)
    robot.settle()
    assert robot.now_s < 1.2  # grabbing takes a second; nothing came after it
    assert robot.moved == [Travel(0.2, 1.0), MoveGrip(0.0)]
    assert robot.reasons == ["nothing_gripped"]


def test_a_part_that_fails_at_once_lets_nothing_move(robot: Any) -> None:
    assert robot.do(play("DO[ act-10 -lex- twizzle ]", FORWARD)) == []


def test_the_auxiliary_part_ends_with_the_required_one(robot: Any) -> None:
    began_s = robot.now_s
    robot.do(play(FORWARD, beside=(WAIT.format("60"),)) + "; " + TURN)
    assert robot.now_s - began_s < 3
    assert robot.reasons == []


def test_an_auxiliary_part_may_end_earlier_or_fail_without_harm(robot: Any) -> None:
    back_up = "DO[ act-10 -lex- twizzle ]"
    assert robot.do(play(FORWARD, beside=(back_up, SAY.format("hm")))) == [Travel(0.2, 1.0)]
    assert robot.said == ["hm"]


def test_chains_inside_a_play_run_side_by_side(robot: Any) -> None:
    robot.do(
        f"PLAY{{; CHAIN{{; {SAY.format('one')}; {RAISE}; }}; CHAIN{{; {FORWARD}; {TURN}; }}; }}"
    )
    kinds = [type(command) for command in robot.moved]
    assert kinds == [Travel, MoveLift, Rotate]


# -- priority ------------------------------------------------------------------------------


def test_a_reaction_takes_the_wheels_and_gives_them_back(robot: Any) -> None:
    robot.teach(BACK_OFF)
    robot.command("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 1; -amt-> act-1 ]")
    robot.pass_time(1.0)
    robot.feel(range_m=0.04)
    robot.tick()
    assert [bid.command for bid in robot.out.bids] == [Travel(-0.2, 1.0)]
    robot.feel(range_m=None)
    robot.settle()
    assert robot.body.state.x_m == pytest.approx(0.8)
    assert robot.moved == [Travel(0.2, 5.0), Travel(-0.2, 1.0)]
    assert robot.now_s == pytest.approx(6.0, abs=0.3)  # while it had no wheels its time did not run
    assert [r.data["resource"] for r in robot.records("resource_lost")] == ["wheels"]


def test_different_resources_do_not_contend(robot: Any) -> None:
    robot.command(FORWARD)
    robot.tick()
    robot.command(RAISE)
    robot.tick()
    assert {bid.resource for bid in robot.out.bids} == {"wheels", "lift"}


def test_the_newer_of_two_commands_goes_first_and_the_older_after_it(robot: Any) -> None:
    robot.command(FORWARD)
    robot.tick()
    robot.command(TURN)
    robot.tick()
    assert {type(bid.command) for bid in robot.out.bids} == {Rotate}
    robot.settle()
    assert robot.body.state.x_m == pytest.approx(0.2)
    assert robot.reasons == []


def test_ten_seconds_without_the_resource_are_enough(robot: Any) -> None:
    robot.command(FORWARD, words="first")
    robot.tick()
    robot.command("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 2; -amt-> act-1 ]")
    robot.tick()
    robot.feel()
    robot.command(WAIT.format("1"))
    long = "DO[ act-1 -lex- turn; dir-2 -lex- left; -dir-> act-1; amt-3 -lex- degree; -str- 720; -amt-> act-1 ]"
    robot.command(long)
    robot.pass_time(9.5)
    assert robot.reasons == []
    robot.command(long)
    robot.pass_time(1.0)
    assert "resource_lost" in robot.reasons


def test_the_same_reaction_taking_over_three_times_is_given_way_to(robot: Any) -> None:
    robot.teach(BACK_OFF)
    robot.command("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 2; -amt-> act-1 ]")
    for _ in range(3):
        assert "resource_lost" not in robot.reasons
        robot.pass_time(0.5)
        robot.feel(range_m=0.04)
        robot.tick()
        robot.feel(range_m=None)
        robot.pass_time(1.3)
    assert robot.reasons == ["resource_lost"]
    assert not robot.out.busy


def test_taking_over_now_and_then_is_borne(robot: Any) -> None:
    robot.teach(BACK_OFF)
    robot.command("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 2; -amt-> act-1; "
                  "mod-3 -lex- slowly; -mod-> act-1 ]")  # fmt: skip
    for _ in range(3):
        robot.pass_time(4.5)
        robot.feel(range_m=0.04)
        robot.tick()
        robot.feel(range_m=None)
        robot.pass_time(1.3)
    robot.settle()
    assert robot.reasons == []


# -- stop ----------------------------------------------------------------------------------


def test_stop_ends_everything_within_the_tick(robot: Any) -> None:
    robot.command(FORWARD + "; " + TURN)
    robot.command(RAISE)
    robot.command(WAIT.format("30"))
    robot.command(SAY.format("la la la") + "; " + SAY.format("more"))
    robot.pass_time(0.3)
    robot.stop()
    robot.tick()
    assert robot.out.bids == ()
    assert robot.out.speech == ()
    assert not robot.out.busy
    assert robot.out.stop_epoch == 1
    assert robot.replies[-1] == Halted(was_busy=True)
    assert {r.data["verdict"] for r in robot.records("verdict")} == {"stopped"}
    moved = len(robot.moves)
    robot.pass_time(35)
    assert len(robot.moves) == moved
    assert robot.said == ["la la la"]


def test_nothing_moves_in_the_tick_of_a_stop_whatever_comes_with_it(robot: Any) -> None:
    robot.teach(BACK_OFF)
    robot.command(FORWARD)
    robot.tick()
    robot.stop()
    robot.feel(range_m=0.04)
    robot.command(TURN)
    robot.tick()
    assert robot.out.bids == ()
    assert robot.out.stop_epoch == 1


def test_bids_carry_the_epoch_they_were_computed_in(robot: Any) -> None:
    robot.stop()
    robot.tick()
    robot.command(FORWARD)
    robot.tick()
    assert robot.out.bids
    assert robot.out.stop_epoch == 1
    assert robot.mind.epoch == 1


def test_an_epoch_that_is_known_stops_nothing(robot: Any) -> None:
    robot.stop()
    robot.tick()
    replies = len(robot.replies)
    robot.do(FORWARD)
    assert robot.body.state.x_m == pytest.approx(0.2)
    assert len(robot.replies) == replies


def test_stop_with_nothing_going_on_is_answered_too(robot: Any) -> None:
    robot.stop()
    robot.tick()
    assert robot.replies == [Halted(was_busy=False)]


def test_a_command_after_the_stop_starts_fresh(robot: Any) -> None:
    robot.command(FORWARD)
    robot.pass_time(0.5)
    robot.stop()
    robot.tick()
    assert robot.do(TURN) == [Rotate(pytest.approx(math.pi / 2), pytest.approx(1.0))]
    assert robot.body.state.x_m == 0.0


def test_stop_as_a_step_ends_other_motion_and_goes_on(robot: Any) -> None:
    robot.command("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 2; -amt-> act-1 ]")
    robot.pass_time(0.5)
    robot.command("DO[ act-1 -lex- stop ]; " + TURN)
    robot.settle()
    assert [type(command) for command in robot.moved] == [Travel, Rotate]
    assert robot.body.state.heading_rad == pytest.approx(math.pi / 2)
    assert robot.reasons in ([], ["stopped"])


# -- room and forgetting -------------------------------------------------------------------


def test_thirty_two_activities_then_a_command_is_refused_aloud(robot: Any) -> None:
    for _ in range(32):
        robot.command(WAIT.format("20"))
    robot.tick()
    assert robot.reasons == []
    robot.command(FORWARD)
    robot.tick()
    assert robot.reasons == ["no_room"]
    assert robot.out.bids == ()
    assert [r.data["words"] for r in robot.records("error")] == [FORWARD]
    robot.pass_time(21)
    assert robot.do(FORWARD) == [Travel(0.2, 1.0)]


def test_no_room_is_said_and_logged(robot: Any) -> None:
    for _ in range(ROOM + 1):
        robot.command(WAIT.format(20))
    robot.tick()
    assert len(robot.mind._attention.active()) == ROOM
    (record,) = robot.records("error")
    assert record.data["text"] == "attention is full"


def test_what_is_sensed_evicts_the_oldest_idle_focus(robot: Any) -> None:
    for number in range(ROOM):
        robot.command(WAIT.format(20) if number % 2 else FORWARD)
    robot.pass_time(5)
    robot.stop()
    robot.tick()
    before = list(robot.mind._attention)
    robot.feel(range_m=0.1)
    robot.tick()
    after = list(robot.mind._attention)
    assert len(after) == ROOM
    assert after[1:] == before[:-1]


def test_a_told_fact_that_has_to_make_room_is_logged(robot: Any) -> None:
    for number in range(TOLD_LIMIT + 1):
        thing = robot.mind.memory.net.new("obj", f"thing{number}")
        robot.mind.memory.tell(net("hq-1 -lex- tall; -hq-> obj-2"), {"obj-2": thing})
    robot.tick()
    (record,) = (r for r in robot.records("fact") if r.data.get("lost"))
    assert record.data["text"] == "tall thing0"


def test_a_told_fact_comes_to_mind_with_what_it_is_about(robot: Any) -> None:
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    girl = "ako-1 -lex- girl; -ako-> obj-2"
    assert robot.believes(girl, WORKING)
    robot.pass_time(40)
    assert not robot.believes(girl, WORKING)
    robot.command("FIND[ obj-1 -lex- mary ]; DO[ act-2 -lex- grab; -obj-> obj-1 ]")
    robot.tick()
    assert robot.believes(girl, WORKING)


def test_what_is_sensed_finds_room_all_the_same(robot: Any) -> None:
    robot.teach(BACK_OFF)
    for _ in range(32):
        robot.command(WAIT.format("20"))
    robot.tick()
    robot.feel(range_m=0.04)
    robot.tick()
    assert [bid.command for bid in robot.out.bids] == [Travel(-0.2, 1.0)]


def test_memory_is_bounded_over_two_thousand_commands(make_robot: Any) -> None:
    robot = make_robot(settings=Settings(fade_s=1.0))
    robot.teach(f"trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; {SAY.format('hey')}")
    sizes = []
    for number in range(2000):
        robot.command("DO[ act-1 -lex- salute ]" if number % 2 else "DO[ act-1 -lex- dance ]")
        robot.tick(0.6)
        if number % 500 == 499:
            robot.pass_time(3)
            sizes.append(len(robot.mind.memory.net))
        robot.trace.clear()
    assert len(set(sizes)) == 1


def test_what_was_told_stays_after_attention_has_faded(robot: Any) -> None:
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    robot.pass_time(60)
    assert robot.do("FIND[ obj-2 -lex- mary ]; CHK[ hq-1 -lex- tall; -hq-> obj-2 ]; " + RAISE)


def test_pronouns_forget_what_has_faded(robot: Any) -> None:
    grab_it = "FIND[ obj-2 -ref- it ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
    robot.do("FIND[ obj-2; ako-3 -lex- block; -ako-> obj-2 ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    robot.pass_time(31)
    assert robot.do(grab_it) == []
    assert robot.reasons == ["nothing_found"]


# -- manners and what is not there yet -----------------------------------------------------


def test_greetings_are_returned_by_name(robot: Any) -> None:
    robot.hear(Social("hello"))
    robot.settle()
    robot.i_am("rick")
    robot.hear(Social("hello"))
    robot.settle()
    assert [r.name for r in robot.replies if isinstance(r, Greeted)] == ["", "rick"]


@pytest.mark.parametrize("tag", ["ALLOW", "NONSENSE"])
def test_a_directive_it_does_not_know_fails_and_harms_nothing(robot: Any, tag: str) -> None:
    robot.do(f"{tag}[ hq-1 -lex- close; -hq-> obj-2 ]; {FORWARD}")
    assert [type(reply) for reply in robot.replies] == [Failed]
    assert robot.moved == []
    assert robot.do(FORWARD) == [Travel(0.2, 1.0)]


# -- determinism ---------------------------------------------------------------------------


def session(make_robot: Any, lessons: list[Lesson], seed: int) -> list[object]:
    robot = make_robot(lessons, seed)
    robot.tell("ako-1 -lex- block; -ako-> obj-2", "obj-2 -lex- brick")
    outputs: list[object] = []
    for number in range(12):
        robot.command("DO[ act-1 -lex- complain ]")
        robot.feel(range_m=0.04 if number % 3 == 0 else None)
        outputs += [robot.tick() for _ in range(20)]
    return outputs


def test_same_inputs_and_seed_same_outputs(make_robot: Any, lesson: MakeLesson) -> None:
    lessons = [lesson(BACK_OFF)]
    for text in ("no", "never", "what"):
        lessons.append(
            lesson(f"trig: DO[ act-1 -lex- complain ]; pref: 1.0; ---; {SAY.format(text)}")
        )
    one, two, other = (session(make_robot, lessons, seed) for seed in (5, 5, 6))
    assert one == two
    assert one != other


def test_policy_is_what_was_taught_not_what_the_body_brings() -> None:
    assert Mind().policy == ()


def test_a_tick_without_anything_brings_nothing() -> None:
    outputs = Mind().tick(Inputs(now_s=1.0))
    assert (outputs.bids, outputs.speech, outputs.replies, outputs.persist, outputs.trace) == (
        (),
    ) * 5
    assert not outputs.busy


def test_speech_is_bid_for_once(robot: Any) -> None:
    robot.command(SAY.format("hello"))
    speech = [bid for _ in range(10) for bid in robot.tick().speech]
    assert [bid.command for bid in speech] == [Speak("hello")]


def test_who_moves_is_busy_though_a_question_is_open(robot: Any) -> None:
    for name in ("one", "two"):
        robot.tell("ako-1 -lex- block; -ako-> obj-2", f"obj-2 -lex- {name}")
    robot.pass_time(40)  # neither is in attention any more: they fit equally well
    robot.teach(
        "trig: ACH[ hq-1 -lex- closed; -hq-> obj-2 ]; pref: 1.0; ---;"
        "FIND[ obj-3 -ref- the; ako-4 -lex- block; -ako-> obj-3 ]; DO[ act-5 -lex- grab; -obj-> obj-3 ]"
    )
    robot.pass_time(40)
    robot.command(
        "FIND[ obj-8; ako-9 -lex- gripper; -ako-> obj-8 ];"
        "PLAY{; DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 1; -amt-> act-1 ];"
        "WITH; KEEP[ hq-6 -lex- closed; -hq-> obj-8 ]; }"
    )
    robot.pass_time(1)
    assert robot.mind.expecting is not None
    assert robot.out.bids
    assert robot.out.busy
