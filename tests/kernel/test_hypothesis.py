"""What is entertained is seen by who entertains it, and by nobody else."""

from typing import Any

from kernel.commons import Commons
from kernel.hypothesis import Hypothesis, suppose
from kernel.memory.attention import Focus
from kernel.memory.notation import read
from kernel.memory.recall import named, referents
from kernel.net.graphlet import Graphlet
from kernel.net.match import holds, matches
from kernel.net.node import HYPOTHETICAL, REMEMBERED
from kernel.selecting import Selection


def net(text: str) -> Graphlet:
    content = read(text.replace(";", "\n"))
    assert isinstance(content, Graphlet)
    return content


CLOSED = net("hq-1 -lex- closed; -hq-> obj-2")
GRIPPER = net("obj-2; ako-3 -lex- gripper; -ako-> obj-2")


def entertained(robot: Any) -> Hypothesis:
    memory = robot.mind.memory
    gripper = next(referents(GRIPPER, memory, {}, 0.5))
    return suppose(CLOSED, memory, gripper)


def test_it_is_about_the_real_thing_and_nothing_but_it_is_made(robot: Any) -> None:
    before = len(robot.mind.memory.net)
    hypothesis = entertained(robot)
    assert len(robot.mind.memory.net) == before + 1
    assert robot.mind.memory.is_part(hypothesis.binding["obj-2"])
    hypothesis.drop()
    hypothesis.drop()
    assert len(robot.mind.memory.net) == before


def test_it_is_not_so(robot: Any) -> None:
    hypothesis = entertained(robot)
    memory = robot.mind.memory
    memory.refresh()
    assert hypothesis.node.level == HYPOTHETICAL
    assert not holds(CLOSED, memory.net, REMEMBERED)
    assert list(matches(CLOSED, memory.net, memory.depth, supposed=hypothesis.nodes))


def test_another_ones_hypothesis_is_not_seen(robot: Any) -> None:
    mine, other = entertained(robot), entertained(robot)
    memory = robot.mind.memory
    found = list(matches(CLOSED, memory.net, memory.depth, supposed=mine.nodes))
    assert [binding["hq-1"] for binding in found] == [mine.node]
    assert other.node is not mine.node


def test_no_rule_concludes_from_it(robot: Any) -> None:
    robot.teach(
        "if: hq-1 -lex- closed; -hq-> obj-2; then: hq-3 -lex- idle; -hq-> obj-2; belief: 1.0"
    )
    entertained(robot)
    assert not robot.believes("hq-1 -lex- idle; -hq-> obj-2", REMEMBERED)


def test_things_only_thought_of_are_no_things(robot: Any) -> None:
    mary = net("obj-1 -lex- mary")
    memory = robot.mind.memory
    thought = suppose(net("hq-3 -lex- near; -hq-> obj-1; obj-1 -lex- mary"), memory, {})
    assert len(thought.nodes) == 2
    assert list(referents(mary, memory, {}, 0.5)) == []
    assert named(mary, memory) == []
    robot.i_am("mary")
    assert memory.user not in thought.nodes


def test_being_linked_to_or_spoken_of_does_not_make_it_so(robot: Any) -> None:
    hypothesis = entertained(robot)
    memory = robot.mind.memory
    robot.do(
        "FIND[ obj-2; ako-3 -lex- gripper; -ako-> obj-2 ]; DO[ act-1 -lex- open; -obj-> obj-2 ]"
    )
    focus = next(iter(robot.mind._attention))
    focus.nodes[memory.net.new("act", "look", obj=hypothesis.node)] = None
    robot.tell("hq-9 -lex- old; -hq-> obj-2", "obj-2; ako-3 -lex- gripper; -ako-> obj-2")
    memory.refresh()
    assert hypothesis.node.level == HYPOTHETICAL
    assert not robot.believes("hq-1 -lex- closed; -hq-> obj-2", REMEMBERED)


TO_CLOSE = """
    trig: ACH[ hq-1 -lex- closed
                    -hq-> obj-2
               ako-3 -lex- gripper
                     -ako-> obj-2 ]
    with: hq-4 -lex- {}
               -hq-> obj-2
    pref: 1.0
    ---
    DO[ act-5 -lex- close
              -obj-> obj-2 ]
"""


def test_triggers_see_it_and_enablements_do_not(robot: Any, lesson: Any) -> None:
    memory = robot.mind.memory
    robot.tell("hq-9 -lex- oiled; -hq-> obj-2", "obj-2; ako-3 -lex- gripper; -ako-> obj-2")
    commons: Commons = robot.mind._commons
    applicable = {}
    for quality in ("oiled", "closed"):
        commons.bear(lesson(TO_CLOSE.format(quality)))
        hypothesis = entertained(robot)
        selection = Selection(commons, Focus(1), (), hypothesis.node)
        assert list(selection.applicable("ACH")) == []
        selection.supposed = hypothesis.nodes
        applicable[quality] = [chosen.specificity for chosen in selection.applicable("ACH")]
        hypothesis.drop()
    assert applicable == {"oiled": [3], "closed": [3]}
    assert memory.depth < HYPOTHETICAL
