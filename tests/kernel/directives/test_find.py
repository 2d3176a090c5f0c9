"""FIND: which thing is meant, and another one where that fails."""

from typing import Any

import pytest

from kernel.action.call import MoveGrip, Travel
from kernel.memory.meaning import Choice
from kernel.memory.reply import AskWhich
from tests.kernel.conftest import net

BLOCK = "FIND[ obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2 ]"
IT = "FIND[ obj-2 -ref- it ]"
TAKE = "; DO[ act-1 -lex- take; -obj-> obj-2 ]"


def blocks(robot: Any, *names: str) -> None:
    for name in names:
        robot.tell("ako-1 -lex- block; -ako-> obj-2", f"obj-2 -lex- {name}")


def can_take(robot: Any, name: str) -> None:
    robot.teach(
        f"trig: DO[ act-1 -lex- take; -obj-> obj-2; obj-2 -lex- {name} ]; pref: 1.0; ---;"
        f"DO[ act-3 -lex- say; -obj-> txt-4; txt-4 -str- {name} ]"
    )


def test_the_newest_is_meant(robot: Any) -> None:
    blocks(robot, "one", "two")
    for name in ("one", "two"):
        can_take(robot, name)
    robot.do(BLOCK + TAKE)
    assert robot.said == ["two"]


def test_the_one_mentioned_last_is_the_newest(robot: Any) -> None:
    blocks(robot, "one", "two")
    for name in ("one", "two"):
        can_take(robot, name)
    robot.tell("hq-1 -lex- red; -hq-> obj-2", "obj-2 -lex- one")
    robot.do(BLOCK + TAKE)
    robot.do(IT + TAKE)
    assert robot.said == ["one", "one"]


def test_a_failure_later_in_the_chain_comes_back_for_another(robot: Any) -> None:
    blocks(robot, "one", "two", "three")
    can_take(robot, "one")
    robot.do(BLOCK + TAKE)
    assert robot.said == ["one"]


def test_it_comes_back_past_steps_that_succeeded(robot: Any) -> None:
    blocks(robot, "one", "two")
    can_take(robot, "one")
    robot.do(BLOCK + "; DO[ act-5 -lex- drive ]" + TAKE)
    assert robot.said == ["one"]
    assert robot.moved == [Travel(0.2, 1.0)] * 2


def test_the_nearest_look_up_is_the_first_to_be_reconsidered(robot: Any) -> None:
    blocks(robot, "one", "two")
    for name in ("alice", "bob"):
        robot.tell("ako-1 -lex- friend; -ako-> obj-2", f"obj-2 -lex- {name}")
    robot.teach(
        "trig: DO[ act-1 -lex- give; -obj-> obj-2; -dest-> obj-3; obj-2 -lex- one; obj-3 -lex- alice ];"
        "pref: 1.0; ---; DO[ act-4 -lex- say; -obj-> txt-5; txt-5 -str- here ]"
    )
    robot.do(
        BLOCK
        + "; FIND[ obj-4; ako-5 -lex- friend; -ako-> obj-4 ]; DO[ act-1 -lex- give; -obj-> obj-2; -dest-> obj-4 ]"
    )
    assert robot.said == ["here"]


def test_none_left_fails_and_the_reason_is_the_first(robot: Any) -> None:
    blocks(robot, "one", "two")
    robot.do(BLOCK + TAKE)
    assert robot.reasons == ["no_way"]


def test_something_to_grab_may_be_assumed(robot: Any) -> None:
    assert robot.do(BLOCK + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]") == [MoveGrip(0.0)]
    assert robot.believes("ako-1 -lex- block; -ako-> obj-2")


def test_what_was_assumed_is_the_same_thing_next_time(robot: Any) -> None:
    robot.do(BLOCK + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    robot.do(IT + "; DO[ act-1 -lex- release; -obj-> obj-2 ]")
    assert robot.moved == [MoveGrip(0.0), MoveGrip(1.0, must_hold=False)]


def test_a_place_to_go_to_has_to_be_known(robot: Any) -> None:
    robot.do(
        "FIND[ obj-2 -ref- the; ako-3 -lex- kitchen; -ako-> obj-2 ]; DO[ act-1 -lex- go; -dest-> obj-2 ]"
    )
    assert robot.moved == []
    (failed,) = robot.replies
    assert (failed.reason, failed.detail) == ("nothing_found", "kitchen")


def test_it_is_nothing_where_nothing_was_mentioned(robot: Any) -> None:
    robot.do(IT + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    assert robot.moved == []
    assert robot.reasons == ["nothing_found"]


def test_somebody_spoken_to_may_be_assumed(robot: Any) -> None:
    robot.do(
        "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- say; -obj-> txt-3; -dest-> obj-2; txt-3 -str- hello ]"
    )
    assert robot.said == ["hello"]


def test_you_are_never_it(robot: Any) -> None:
    robot.do(IT + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]", speaker="Rick")
    assert robot.moved == []


def test_inside_a_play_the_newest_is_taken(robot: Any) -> None:
    blocks(robot, "one", "two")
    robot.do(f"PLAY{{; {BLOCK}; DO[ act-5 -lex- drive ]; }}")
    assert robot.moved == [Travel(0.2, 1.0)]


# -- backtracking --------------------------------------------------------------------------

A_BLOCK = "FIND[ obj-2; ako-3 -lex- block; -ako-> obj-2 ]"
SAYS = "DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- {} ]"
LIFT = "; DO[ act-4 -lex- hoist; -obj-> obj-2 ]"


def words(robot: Any) -> list[str]:
    """Every act in the order it began."""
    return [" ".join(r.data["words"]) for r in robot.records("action_started")]


def test_a_block_that_cannot_be_grabbed_is_followed_by_the_next(robot: Any) -> None:
    blocks(robot, "one", "two", "three")
    for name in ("two", "three"):
        robot.teach(
            f"trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; obj-2 -lex- {name} ]; pref: 1.0; ---; PUNT[ ]"
        )
    assert robot.do(A_BLOCK + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]") == [MoveGrip(0.0)]
    assert words(robot) == ["grab one block"]
    assert [r.data["text"] for r in robot.records("prohibited")] == [
        "grab three block",
        "grab two block",
    ]
    assert robot.reasons == []


def test_a_procedures_own_look_up_is_gone_back_to_inside_it(robot: Any) -> None:
    """The nearest FIND first: the one in the nested chain; the outer one only when that has none left."""
    blocks(robot, "one", "two")
    for name in ("alice", "bob"):
        robot.tell("ako-1 -lex- friend; -ako-> obj-2", f"obj-2 -lex- {name}")
    robot.teach(
        "trig: DO[ act-1 -lex- serve; -obj-> obj-2 ]; pref: 1.0; ---;"
        "FIND[ obj-3; ako-4 -lex- friend; -ako-> obj-3 ];"
        "DO[ act-5 -lex- say; -obj-> txt-6; -dest-> obj-3; txt-6 -str- here ];"
        "DO[ act-7 -lex- give; -obj-> obj-2; -dest-> obj-3 ]"
    )
    robot.teach(
        "trig: DO[ act-1 -lex- give; -obj-> obj-2; -dest-> obj-3; obj-2 -lex- one; obj-3 -lex- alice ];"
        f"pref: 1.0; ---; {SAYS.format('done')}"
    )
    robot.do(A_BLOCK + "; DO[ act-1 -lex- serve; -obj-> obj-2 ]")
    bob, alice = "say bob friend here", "say alice friend here"
    assert words(robot) == [bob, alice, alice, "say done"]  # alice is the newest mention by then
    assert robot.reasons == []


def test_what_failed_before_going_back_is_no_cause_of_a_later_failure(robot: Any) -> None:
    blocks(robot, "one", "two")
    can_take(robot, "one")
    robot.do(A_BLOCK + TAKE + "; DO[ act-5 -lex- salute ]")
    assert robot.replies[-1].act.words() == {"salute"}


# -- FIND operators ------------------------------------------------------------------------

BALL = "obj-2; ako-3 -lex- ball; -ako-> obj-2"
TURN = "DO[ act-5 -lex- drive ]"
SEEN = "NOTE[ ako-7 -lex- ball; -ako-> obj-8; obj-8 -lex- {} ]"
GO = "; DO[ act-1 -lex- visit; -dest-> obj-2 ]"


def visits(robot: Any, name: str) -> None:
    robot.teach(
        f"trig: DO[ act-1 -lex- visit; -dest-> obj-2; obj-2 -lex- {name} ]; pref: 1.0; ---; {SAYS.format(name)}"
    )


def looking(*steps: str, pref: float = 1.0) -> str:
    return "; ".join((f"trig: FIND[ {BALL} ]", f"pref: {pref}", "---", *steps))


def test_what_is_not_known_is_looked_for_as_taught(robot: Any) -> None:
    robot.teach(looking(TURN, SEEN.format("spot")))
    visits(robot, "spot")
    robot.do(f"FIND[ {BALL} ]{GO}")
    assert robot.moved == [Travel(0.2, 1.0)]
    assert robot.said == ["spot"]


def test_memory_comes_first(robot: Any) -> None:
    robot.tell("ako-1 -lex- ball; -ako-> obj-2", "obj-2 -lex- pookie")
    robot.teach(looking(TURN, SEEN.format("spot")))
    visits(robot, "pookie")
    assert robot.do(f"FIND[ {BALL} ]{GO}") == []
    assert robot.said == ["pookie"]


def test_where_none_in_memory_will_do_others_are_looked_for(robot: Any) -> None:
    robot.tell("ako-1 -lex- ball; -ako-> obj-2", "obj-2 -lex- pookie")
    robot.teach(looking(TURN, SEEN.format("spot")))
    visits(robot, "spot")
    robot.do(f"FIND[ {BALL} ]{GO}")
    assert robot.said == ["spot"]
    assert robot.reasons == []


def test_ways_of_looking_are_tried_in_turn_and_memory_looked_at_after_each(make_robot: Any) -> None:
    for seed in range(6):
        robot = make_robot(seed=seed)
        robot.teach(looking("DO[ act-5 -lex- twizzle ]"))
        robot.teach(looking(SAYS.format("nothing here")))
        robot.teach(looking(SEEN.format("spot")))
        visits(robot, "spot")
        robot.do(f"FIND[ {BALL} ]{GO}")
        assert robot.said[-1] == "spot"
        assert robot.said.count("nothing here") <= 1


def test_looking_in_vain_is_told_as_nothing_found(robot: Any) -> None:
    robot.teach(looking("DO[ act-5 -lex- twizzle ]"))
    robot.do(f"FIND[ {BALL} ]{GO}")
    assert robot.reasons == ["nothing_found"]


def test_what_was_assumed_is_marked(robot: Any) -> None:
    robot.do(BLOCK + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    assert [r.data["text"] for r in robot.records("assumed")] == ["block"]
    (thing,) = [n for n in robot.mind.memory.net if n.assumed]
    assert any("block" in kind.lex for kind in thing.modifiers("ako"))


def test_a_search_that_was_taught_is_what_finding_does(robot: Any) -> None:
    find = f"FIND[ {BALL} ]; DO[ act-1 -lex- find; -obj-> obj-2 ]"
    assert robot.do(find) == []
    assert robot.reasons == ["no_sense"]
    robot.teach(looking(TURN))
    for _ in range(5):
        assert robot.do(find) == [Travel(0.2, 1.0)]
    assert robot.reasons == ["no_sense"]


def test_it_searches_once_for_what_it_is_told_to_find(robot: Any) -> None:
    robot.teach(looking(TURN))
    find = f"FIND[ {BALL} ]; DO[ act-1 -lex- find; -obj-> obj-2 ]"
    assert robot.do(find) == [Travel(0.2, 1.0)]


def test_a_prohibition_sees_what_is_looked_for(robot: Any) -> None:
    """While it looks for a person it grabs none."""
    robot.teach(
        "trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]; pref: 1.0; ---; PUNT[ ]"
    )
    robot.teach(
        "trig: FIND[ obj-2; ako-3 -lex- person; -ako-> obj-2 ]; pref: 1.0; ---; DO[ act-4 -lex- grab; -obj-> obj-2 ]"
    )
    assert robot.do(f"FIND[ obj-2; ako-3 -lex- person; -ako-> obj-2 ]{GO}") == []
    assert robot.records("prohibited")


# -- what something is like ----------------------------------------------------------------

COLOR = "FIND[ hq-3 -hq-> obj-2; ako-4 -lex- color; -ako-> hq-3 ]"
A_COLOR = ("ako-1 -lex- color; -ako-> obj-2", "obj-2 -lex- red")


def test_a_color_is_known_by_its_word(robot: Any) -> None:
    robot.tell("hq-1 -lex- big; -hq-> obj-2", "obj-2 -lex- spot")
    robot.tell("hq-1 -lex- red; -hq-> obj-2", "obj-2 -lex- spot")
    robot.do(f"FIND[ obj-2 -lex- spot ]; {COLOR}")
    assert robot.replies[-1].verdict == "unknown"
    robot.tell(*A_COLOR)
    robot.do(f"FIND[ obj-2 -lex- spot ]; {COLOR}")
    assert [g.words() >= {"red"} for g in robot.replies[-1].found] == [True]


def test_as_a_step_it_is_found_out_as_taught_or_fails_with_a_reason(robot: Any) -> None:
    robot.tell(*A_COLOR)
    robot.tell("ako-1 -lex- ball; -ako-> obj-2", "obj-2 -lex- spot")
    find = f"FIND[ obj-2 -lex- spot ]; {COLOR}; {TURN}"
    assert robot.do(find) == []
    assert robot.reasons == ["not_known"]
    robot.teach(
        "trig: FIND[ hq-3 -hq-> obj-2; ako-4 -lex- color; -ako-> hq-3 ]; pref: 1.0; ---;"
        "NOTE[ hq-5 -lex- red; -hq-> obj-2 ]"
    )
    assert robot.do(find) == [Travel(0.2, 1.0)]


# -- asking which --------------------------------------------------------------------------

THE_BLOCK = (
    "FIND[ obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2 ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
)
RED = "obj-1 -ref- one; hq-2 -lex- {}; -hq-> obj-1"


def two_blocks(robot: Any, apart: bool = False, *colors: str) -> None:
    for color in colors or ("red", "blue"):
        robot.tell(f"ako-1 -lex- block; -ako-> obj-2; hq-3 -lex- {color}; -hq-> obj-2")
        if apart:
            robot.pass_time(1)
    if not apart:
        robot.pass_time(31)  # both out of attention


def answer(robot: Any, color: str) -> None:
    robot.hear(Choice(net(RED.format(color))), color)
    robot.tick()


def test_between_equals_the_person_decides(robot: Any) -> None:
    two_blocks(robot)
    assert robot.do(THE_BLOCK) == []
    assert not robot.out.busy  # it only waits
    (asked,) = [r for r in robot.replies if isinstance(r, AskWhich)]
    assert [option.words() for option in asked.options] == [{"block", "red"}, {"block", "blue"}]
    assert robot.mind.expecting is asked
    answer(robot, "red")
    robot.settle()
    assert words(robot) == ["grab red"] or "red" in words(robot)[0]
    assert robot.moved == [MoveGrip(0.0)]
    assert robot.mind.expecting is None


def test_the_one_mentioned_last_needs_no_asking(robot: Any) -> None:
    two_blocks(robot, True)
    assert robot.do(THE_BLOCK) == [MoveGrip(0.0)]
    assert "blue" in words(robot)[0]


@pytest.mark.parametrize("ref", ["", " -ref- any"])
def test_one_of_many_needs_no_asking(robot: Any, ref: str) -> None:
    two_blocks(robot)
    assert robot.do(THE_BLOCK.replace(" -ref- the", ref)) == [MoveGrip(0.0)]


def test_after_the_answer_that_one_is_meant(robot: Any) -> None:
    two_blocks(robot)
    robot.do(THE_BLOCK)
    answer(robot, "red")
    robot.settle()
    robot.do(THE_BLOCK)
    assert len([r for r in robot.replies if isinstance(r, AskWhich)]) == 1
    assert all("red" in said for said in words(robot))


def test_the_one_chosen_is_not_replaced_by_another_where_it_fails(robot: Any) -> None:
    two_blocks(robot)
    robot.body.within_reach = False
    robot.do(THE_BLOCK)
    answer(robot, "red")
    robot.settle()
    assert len(words(robot)) == 1
    assert robot.reasons == ["nothing_gripped"]


def test_without_an_answer_it_gives_up_after_twenty_seconds(robot: Any) -> None:
    two_blocks(robot)
    robot.do(THE_BLOCK)
    robot.pass_time(19)
    assert robot.mind.expecting is not None
    robot.pass_time(1.5)
    assert robot.mind.expecting is None
    assert robot.reasons == ["not_answered"]
    assert robot.moved == []


def test_an_answer_that_still_fits_several_is_asked_again(robot: Any) -> None:
    two_blocks(robot)
    robot.do(THE_BLOCK)
    robot.hear(Choice(net("obj-1 -ref- the; ako-2 -lex- block; -ako-> obj-1")), "the block")
    robot.tick()
    assert len([r for r in robot.replies if isinstance(r, AskWhich)]) == 2
    assert robot.mind.expecting is not None


def test_another_command_closes_the_question(robot: Any) -> None:
    two_blocks(robot)
    robot.do(THE_BLOCK)
    assert robot.do("DO[ act-1 -lex- drive ]") == [Travel(0.2, 1.0)]
    assert robot.mind.expecting is None
    answer(robot, "red")
    robot.settle()
    assert robot.moved == [Travel(0.2, 1.0)]
    assert robot.reasons == []


def test_a_stop_closes_the_question(robot: Any) -> None:
    two_blocks(robot)
    robot.do(THE_BLOCK)
    robot.stop()
    robot.tick()
    assert robot.mind.expecting is None
    answer(robot, "red")
    robot.settle()
    assert robot.moved == []
