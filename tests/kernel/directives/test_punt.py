"""PUNT: the chain fails at once; the one that posted it backtracks."""

from typing import Any

from kernel.action.call import Travel

DRIVE = "DO[ act-{0} -lex- drive; dir-{1} -lex- {2}; -dir-> act-{0} ]"


def test_nothing_after_it_is_done(robot: Any) -> None:
    robot.do(f"{DRIVE.format(1, 2, 'forward')}; PUNT[ ]; {DRIVE.format(3, 4, 'backward')}")
    assert robot.moved == [Travel(0.2, 1.0)]
    assert robot.records("verdict")[0].data["verdict"] == "failed"
    assert robot.replies[-1].reason == "given_up"


def test_it_does_not_go_back_for_another_binding_in_its_own_chain(robot: Any) -> None:
    for name in ("one", "two"):
        robot.tell("ako-1 -lex- block; -ako-> obj-2", f"obj-2 -lex- {name}")
    robot.do("FIND[ obj-2; ako-3 -lex- block; -ako-> obj-2 ]; DO[ act-1 -lex- drive ]; PUNT[ ]")
    assert robot.moved == [Travel(0.2, 1.0)]


def test_the_chain_that_posted_it_backtracks(robot: Any) -> None:
    for name in ("two", "one"):
        robot.tell("ako-1 -lex- block; -ako-> obj-2", f"obj-2 -lex- {name}")
    robot.teach(
        "trig: DO[ act-1 -lex- try; -obj-> obj-2; obj-2 -lex- one ]; pref: 1.0; ---; PUNT[ ]"
    )
    robot.teach(
        "trig: DO[ act-1 -lex- try; -obj-> obj-2; obj-2 -lex- two ]; pref: 1.0; ---; DO[ act-3 -lex- drive ]"
    )
    robot.do("FIND[ obj-2; ako-3 -lex- block; -ako-> obj-2 ]; DO[ act-1 -lex- try; -obj-> obj-2 ]")
    assert robot.moved == [Travel(0.2, 1.0)]
