"""Chains of plays."""

from kernel.action.chain import Chain, Directive, Play, sequence

A, B, C = (Directive(tag) for tag in ("DO", "CHK", "PUNT"))


def test_directives_come_in_reading_order_however_deep() -> None:
    nested = Chain((Play((A, sequence(B, C)), (C,)), Play((B,))))
    assert [d.tag for d in nested.directives()] == ["DO", "CHK", "PUNT", "PUNT", "CHK"]


def test_a_sequence_is_one_thing_at_a_time() -> None:
    chain = sequence(A, B)
    assert [play.required for play in chain.plays] == [(A,), (B,)]
    assert not chain.parallel


def test_two_things_at_once_are_parallel_also_inside_or_beside() -> None:
    assert Chain((Play((A, B)),)).parallel
    assert Chain((Play((A,), (B,)),)).parallel
    assert Chain((Play((Chain((Play((A, B)),)),)),)).parallel
    assert not Chain((Play((sequence(A, B),)),)).parallel
