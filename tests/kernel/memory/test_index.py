"""Finding by words, whatever has come and gone."""

from hypothesis import given
from hypothesis import strategies as st

from kernel.memory.index import WordIndex
from kernel.net.node import Net

WORDS = st.frozensets(st.sampled_from("abcdefgh"), max_size=3)


@given(
    st.dictionaries(st.integers(0, 30), st.tuples(WORDS, WORDS), max_size=30),
    st.sets(st.integers(0, 30)),
    WORDS,
    WORDS,
    st.integers(0, 40),
)
def test_it_finds_what_a_walk_over_all_would_find(
    filed: dict[int, tuple[frozenset[str], frozenset[str]]],
    gone: set[int],
    there: frozenset[str],
    asked: frozenset[str],
    strangers: int,
) -> None:
    index: WordIndex[int] = WordIndex()
    net = Net()
    net.new("x", *there)
    for number in range(strangers):
        net.new("x", f"stranger{number}")
    for item, (keys, words) in filed.items():
        index.add(item, keys & words, words)
    for item in gone:
        index.remove(item)
    left = {i: (k & w, w) for i, (k, w) in filed.items() if i not in gone}
    assert len(index) == len(left)
    assert set(index.possible(net)) == {i for i, (_, w) in left.items() if w <= there}
    found = index.concerned(asked, net)
    assert len(found) == len(set(found))
    assert set(found) == {i for i, (k, w) in left.items() if w <= there and (not k or k & asked)}


def test_ten_thousand_that_share_a_word_are_not_walked() -> None:
    """Counted, not timed: how many items are looked at."""
    index: WordIndex[int] = WordIndex()
    for number in range(10_000):
        index.add(number, ["grab"], ["grab", f"kind{number}"])
    net = Net()
    net.new("act", "grab")
    net.new("ako", "kind77")
    looked_at: list[str] = []
    has_word = net.has_word
    net.has_word = lambda word: looked_at.append(word) or has_word(word)  # type: ignore[method-assign, func-returns-value]
    assert index.concerned(["grab"], net) == [77]
    assert len(looked_at) < 20
