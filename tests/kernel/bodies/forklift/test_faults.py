"""The bad line does what it says, the same way each time."""

import random

import pytest

from kernel.bodies.forklift import faults
from kernel.bodies.forklift.faults import Faults, FaultsError, Line


def through(line: Line, frames: int = 400) -> list[tuple[float, bytes]]:
    """Send numbered frames 20 ms apart; what arrives, and when."""
    arrived = []
    for step in range(frames * 4 + 100):
        now_s = step * 0.005
        if step % 4 == 0 and step // 4 < frames:
            line.push(bytes((1 + step // 4 % 250, 7, 7, 0)), now_s)
        data = line.pop(now_s)
        if data:
            arrived.append((now_s, data))
    return arrived


def share(kept: Faults) -> list[bytes]:
    return [data for _, data in through(Line(kept, random.Random(5)))]


def test_a_good_line_passes_everything_in_order() -> None:
    assert b"".join(share(Faults())) == b"".join(bytes((1 + n % 250, 7, 7, 0)) for n in range(400))


def test_drop_and_duplicate_come_at_their_rate() -> None:
    assert 250 < len(share(Faults(drop=0.25))) < 350
    assert 460 < b"".join(share(Faults(duplicate=0.25))).count(0) < 540


def test_flip_changes_one_bit() -> None:
    sent = [bytes((1 + n % 250, 7, 7, 0)) for n in range(400)]
    got = share(Faults(flip=1.0))
    bits = [
        sum((a ^ b).bit_count() for a, b in zip(one, other, strict=True))
        for one, other in zip(sent, got, strict=True)
    ]
    assert set(bits) == {1}


def test_delay_keeps_the_order_and_reorder_does_not() -> None:
    delayed = b"".join(share(Faults(delay=0.1)))
    assert delayed == b"".join(share(Faults()))
    assert b"".join(share(Faults(reorder=0.3))) != delayed


def test_split_loses_nothing() -> None:
    pieces = share(Faults(split=1.0))
    assert len(pieces) > 700
    assert b"".join(pieces) == b"".join(share(Faults()))


def test_the_same_seed_gives_the_same_line() -> None:
    lossy = faults.PROFILES["lossy"]
    assert through(Line(lossy, random.Random(3))) == through(Line(lossy, random.Random(3)))
    assert through(Line(lossy, random.Random(3))) != through(Line(lossy, random.Random(4)))


def test_faults_are_read_by_profile_and_one_by_one() -> None:
    assert faults.read("hc05") == faults.PROFILES["hc05"]
    assert faults.read("drop=0.1,flip=0.02") == Faults(drop=0.1, flip=0.02)


@pytest.mark.parametrize("text", ["", "hc06", "drop", "drop=x", "drop=2", "loss=0.1"])
def test_other_texts_are_refused(text: str) -> None:
    with pytest.raises(FaultsError):
        faults.read(text)
