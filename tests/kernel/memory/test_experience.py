"""The firing record: bounded, and each deed with its beginning, its end and what it is a step of."""

from kernel.action.verdict import Verdict
from kernel.memory.experience import SOURCES, Deed, Experience, Source, Trouble
from kernel.net.graphlet import Graphlet, Term
from kernel.net.node import Net

ACT = Graphlet((Term("act-1", frozenset({"drive"})),), "act-1")


def begin(experience: Experience, began_s: float = 0.0, parent: int = 0) -> Deed:
    return experience.begin(Deed(0, ACT, ACT, 1, began_s, parent))


def test_the_oldest_make_room() -> None:
    experience = Experience(room=3)
    numbers = [begin(experience).number for _ in range(10)]
    assert [deed.number for deed in experience] == numbers[:-4:-1]
    experience.end(numbers[0], 1.0, Verdict.SUCCEEDED, None)
    assert len(experience) == 3


def test_a_deed_goes_on_until_it_ends() -> None:
    experience = Experience()
    number = begin(experience, 5.0).number
    assert next(iter(experience)).going_on
    experience.end(number, 7.0, Verdict.FAILED, Trouble("stuck"))
    deed = next(iter(experience))
    assert (deed.going_on, deed.done, deed.ended_s) == (False, False, 7.0)
    assert deed.trouble == Trouble("stuck")


def test_steps_of_steps() -> None:
    experience = Experience()
    whole = begin(experience)
    step = begin(experience, parent=whole.number)
    inner = begin(experience, parent=step.number)
    assert experience.root(inner) == whole
    assert list(experience.ancestors(inner)) == [step, whole]
    assert experience.is_whole(whole)
    assert not experience.is_whole(step)


def test_wall_time_is_known_once_it_was_told() -> None:
    experience = Experience()
    assert begin(experience, 3.0).wall_s is None
    experience.clock(0.0, 4.0)
    assert begin(experience, 4.0).wall_s is None
    experience.clock(1000.0, 5.0)
    assert begin(experience, 7.0).wall_s == 1002.0


def test_who_told_what_is_bounded_and_the_last_teller_counts() -> None:
    experience, net = Experience(), Net()
    nodes = [net.new("hq") for _ in range(SOURCES + 10)]
    for node in nodes:
        experience.told(node, Source("mary"))
    experience.told(nodes[-1], Source("rick"))
    assert len(experience.sources) == SOURCES
    assert nodes[0] not in experience.sources
    assert experience.sources[nodes[-1]].teacher == "rick"
    experience.told(nodes[100], Source("john"))
    assert [*experience.sources.values()][-1].teacher == "john"
