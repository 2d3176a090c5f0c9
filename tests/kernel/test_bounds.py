"""Nothing runs away: depth, and steps in one tick."""

from typing import Any

import pytest

from kernel.action.call import Travel
from kernel.memory.settings import Settings

CHECK = "CHK[ obj-2 -lex- you; hq-1 -lex- awake; -hq-> obj-2 ]"
DRIVE = "DO[ act-9 -lex- drive ]"


def to(verb: str, *steps: str) -> str:
    return "; ".join((f"trig: DO[ act-1 -lex- {verb} ]", "pref: 1.0", "---", *steps))


def test_five_thousand_instant_steps_hold_up_nobody(robot: Any) -> None:
    robot.tell("hq-1 -lex- awake; -hq-> obj-2; obj-2 -lex- you")
    robot.command("; ".join([CHECK] * 5000 + ["DO[ act-3 -lex- raise ]"]))
    robot.tick()
    robot.command(DRIVE)
    robot.tick()
    assert robot.moved == [Travel(0.2, 1.0)]
    yielded = robot.records("yielded")
    assert [record.data["steps"] for record in yielded] == [1000, 1000]
    robot.settle()
    assert len(robot.moved) == 2
    assert robot.reasons == []
    assert robot.now_s < 3


def test_a_stop_ends_it_in_the_middle(robot: Any) -> None:
    robot.tell("hq-1 -lex- awake; -hq-> obj-2; obj-2 -lex- you")
    robot.command("; ".join([CHECK] * 5000 + [DRIVE]))
    robot.tick()
    assert robot.out.busy
    robot.stop()
    robot.tick()
    assert not robot.out.busy
    robot.pass_time(1)
    assert robot.moved == []


@pytest.mark.parametrize(("depth", "done"), [(3, False), (4, True), (20, True)])
def test_depth_is_a_setting(make_robot: Any, depth: int, done: bool) -> None:
    robot = make_robot(settings=Settings(depth=depth))
    for verb, step in (("a", "b"), ("b", "c")):
        robot.teach(to(verb, f"DO[ act-2 -lex- {step} ]"))
    robot.teach(to("c", DRIVE))
    assert bool(robot.do("DO[ act-1 -lex- a ]")) is done
    assert robot.reasons == ([] if done else ["too_deep"])


@pytest.mark.parametrize(
    "rounds",
    [(("dance", "dance"),), (("a", "b"), ("b", "a")), (("a", "b"), ("b", "c"), ("c", "a"))],
)
def test_what_would_never_end_is_noticed(robot: Any, rounds: tuple[tuple[str, str], ...]) -> None:
    for verb, step in rounds:
        robot.teach(to(verb, f"DO[ act-2 -lex- {step} ]"))
    assert robot.do(f"DO[ act-1 -lex- {rounds[0][0]} ]") == []
    assert robot.reasons == ["recursion"]
    robot.teach(to(rounds[-1][1], DRIVE))  # another way, and it is taken
    assert robot.do(f"DO[ act-1 -lex- {rounds[0][0]} ]")


def test_reactions_to_failing_do_not_feed_themselves(robot: Any) -> None:
    robot.teach(
        "trig: NOTE[ act-1 -lex- fail; -agt-> obj-2; -obj-> act-3; obj-2 -lex- you ]; pref: 1.0; ---;"
        "DO[ act-5 -lex- salute ]"
    )
    robot.do("DO[ act-1 -lex- salute ]")
    assert robot.reasons == ["no_way"]
    assert len(robot.records("focus")) <= 4
