"""The attention buffer."""

from kernel.memory.attention import ROOM, Attention


def test_newest_first() -> None:
    attention = Attention()
    first, second = attention.post(), attention.post()
    assert list(attention) == [second, first]
    assert second.number > first.number


def test_what_is_handled_is_not_active_but_stays_until_it_has_faded() -> None:
    attention = Attention(fade_s=30.0)
    focus = attention.post()
    focus.ended_s = 100.0
    assert attention.active() == []
    assert attention.fade(129.9) == []
    assert list(attention) == [focus]
    assert attention.fade(130.0) == [focus]
    assert list(attention) == []


def test_what_is_not_handled_does_not_fade() -> None:
    attention = Attention()
    focus = attention.post()
    assert attention.fade(1e9) == []
    assert attention.active() == [focus]


def test_the_oldest_handled_one_makes_room_never_an_active_one() -> None:
    attention = Attention()
    active, old, young = (attention.post() for _ in range(3))
    young.ended_s, old.ended_s = 2.0, 1.0
    assert attention.evict() is old
    assert attention.evict() is young
    assert attention.evict() is None
    assert list(attention) == [active]


def test_it_is_crowded_when_it_is_full_of_handled_and_active_ones() -> None:
    attention = Attention()
    for number in range(ROOM):
        assert not attention.crowded
        attention.post().ended_s = 1.0 if number % 2 else None
    assert attention.crowded
