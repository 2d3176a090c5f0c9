"""What is in force is what the journal says: the same whether it is folded at once or one change after another."""

from copy import deepcopy

from hypothesis import given
from hypothesis import strategies as st

from kernel.memory.change import Adapted, Change
from kernel.memory.lesson import Lesson
from kernel.memory.policy import RETIRED_KEPT, Policy
from kernel.net.graphlet import Graphlet, Term

FACT = Graphlet((Term("hq-1", frozenset(("red",)), links=(("hq", "obj-2"),)),), "hq-1")


def lesson(ident: int) -> Lesson:
    return Lesson(ident, "fact", FACT, f"lesson {ident}")


@st.composite
def journals(draw: st.DrawFn) -> list[Change]:
    """Random journals: teach, retract, adapt, undo anything that came before."""
    changes: list[Change] = []
    taught: list[int] = []
    for number in range(1, draw(st.integers(1, 12)) + 1):
        learned, retracted, adapted, undone = (), (), (), ()
        if draw(st.booleans()):
            taught.append(number)
            learned = (lesson(number),)
        if taught and draw(st.booleans()):
            retracted = tuple(draw(st.lists(st.sampled_from(taught), max_size=2, unique=True)))
        if taught and draw(st.booleans()):
            adapted = (Adapted(draw(st.sampled_from(taught)), 1.0, draw(st.floats(0.1, 1.5))),)
        if changes and draw(st.booleans()):
            earlier = [change.ident for change in changes]
            undone = tuple(draw(st.lists(st.sampled_from(earlier), max_size=2, unique=True)))
        changes.append(Change(number, "", "", 0.0, learned, retracted, adapted, undone))
    return changes


def by_definition(changes: list[Change]) -> tuple[set[int], dict[int, float]]:
    """Newest change first: whether it counts is known by then."""
    counting: list[Change] = []
    taken_back: set[int] = set()
    for change in reversed(changes):
        if change.ident not in taken_back:
            counting.insert(0, change)
            taken_back |= set(change.undone)
    retracted = {n for change in counting for n in change.retracted}
    learned = {x.ident for change in counting for x in change.learned} - retracted
    strengths = {a.lesson: a.after for change in counting for a in change.adapted}
    return learned, {n: strengths.get(n, 1.0) for n in learned}


@given(journals())
def test_every_change_leads_to_what_the_whole_journal_says(changes: list[Change]) -> None:
    policy = Policy()
    before: set[int] = set()
    for count, change in enumerate(changes, 1):
        shift = policy.apply(change)
        wanted, strengths = by_definition(changes[:count])
        assert set(policy.lessons) == wanted
        assert {n: policy.strength(policy.lessons[n]) for n in wanted} == strengths
        assert {x.ident for x in shift.entered} == wanted - before
        assert {x.ident for x in shift.left} == before - wanted
        before = wanted


def test_undo_can_itself_be_undone_and_that_as_well() -> None:
    policy = Policy()
    policy.apply(Change(1, learned=(lesson(1),)))
    for number in range(2, 8):
        policy.apply(Change(number, undone=(number - 1,)))
        assert (1 in policy.lessons) == (number % 2 == 1)


def test_what_it_was_born_with_can_be_retracted_and_restored() -> None:
    policy = Policy()
    policy.bear(lesson(-1))
    policy.apply(Change(1, retracted=(-1,)))
    assert not policy.lessons
    policy.apply(Change(2, undone=(1,)))
    assert policy.lessons


@given(journals())
def test_a_preview_is_what_happens_and_changes_nothing(changes: list[Change]) -> None:
    policy = Policy()
    for change in changes:
        before = deepcopy(policy)
        foreseen = policy.preview(change)
        assert vars(policy) == vars(before)
        assert policy.apply(change) == foreseen


def test_an_undo_of_an_undo_is_an_undo_however_often() -> None:
    policy = Policy()
    policy.apply(Change(1, learned=(lesson(1),)))
    for number in range(2, 300):
        policy.apply(Change(number, undone=(number - 1,)))
        assert (1 in policy.lessons) == (number % 2 == 1)


def test_of_its_own_adaptations_the_last_one_is_remembered_and_a_persons_all() -> None:
    policy = Policy()
    policy.apply(Change(1, learned=(lesson(1), lesson(2))))
    for number in range(2, 500):
        moves = (Adapted(1, 1.0, number / 1000),) + ((Adapted(2, 1.0, 0.5),) * (number == 100))
        policy.apply(Change(number, adapted=moves, own=number != 300))
    assert len(list(policy.changes())) == 4  # the teaching, 100 for lesson 2, 300 by a person, 499
    assert policy.strength(lesson(1)) == 0.499
    assert policy.strength(lesson(2)) == 0.5
    policy.apply(Change(500, undone=(300,)))
    assert policy.strength(lesson(1)) == 0.499


def test_lessons_out_of_force_are_bounded_oldest_out_first() -> None:
    policy = Policy()
    for number in range(1, 2 * RETIRED_KEPT + 1):
        policy.apply(Change(2 * number, learned=(lesson(number),)))
        policy.apply(Change(2 * number + 1, retracted=(number,)))
    assert policy.known(RETIRED_KEPT) is None
    assert policy.known(RETIRED_KEPT + 1) is not None
    assert len(list(policy.changes())) == 2 * RETIRED_KEPT
    newest = 4 * RETIRED_KEPT + 1
    assert policy.apply(Change(newest + 1, undone=(newest,))).entered == (lesson(2 * RETIRED_KEPT),)
    assert policy.apply(Change(newest + 2, undone=(3,))).entered == ()
