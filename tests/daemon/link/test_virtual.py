"""The link without a port or waiting."""

from daemon.link.virtual import VirtualLink
from firmware_proto.frame import FrameReader
from firmware_proto.messages import MOTION, Drive, State, Telem, number_of
from firmware_proto.told import SessionState, Settled
from kernel.bodies.forklift.faults import PROFILES


def beat_for(link: VirtualLink, seconds: float) -> None:
    for _ in range(round(seconds * 30)):
        link.advance(1 / 30)
        link.beat()


def test_it_connects_in_virtual_time_and_hears_telemetry() -> None:
    link = VirtualLink()
    assert not link.connected
    assert link.connect()
    assert link.now_s < 0.1
    beat_for(link, 0.3)
    assert [m for m in link.received() if isinstance(m, Telem)]
    assert link.received() == []


def test_a_scene_may_be_text() -> None:
    text = "[[thing]]\nnoun = 'wall'\nx_cm = 30\ny_cm = 0"
    assert VirtualLink(text).simulated.world.truth().range_cm == 22.0


def test_cut_and_restored_it_comes_back_with_the_epoch_it_had() -> None:
    link = VirtualLink()
    link.connect()
    beat_for(link, 0.2)
    assert link.stop() == 1
    beat_for(link, 0.2)
    link.cut()
    beat_for(link, 1.5)
    assert not link.connected
    assert link.stop() == 2
    link.send([Drive(1, 1, 1)], 2)
    link.restore()
    beat_for(link, 3.0)
    assert link.connected
    assert link.state is SessionState.READY
    assert link.stop_epoch == 2
    assert [m.result for m in link.received() if isinstance(m, Settled)] == [None]
    link.send([Drive(1, 1, 1)], 1)
    beat_for(link, 0.1)
    assert link.simulated.device.state is State.READY


def test_stop_in_200_random_moments_of_a_drive_over_a_lossy_line() -> None:
    for seed in range(10):
        link = VirtualLink(seed=seed, faults=PROFILES["lossy"])
        assert link.connect()
        beat_for(link, 0.3)
        for moment in range(20):
            old = link.stop_epoch
            for step in range(1 + (7 * moment + 3 * seed) % 16):
                link.send([Drive(300, 300, 2000)] if step % 5 == 0 else [], old)
                link.beat()
                link.advance(0.015)
            link.stop()
            written = len(link.sent)
            for _ in range(12):
                link.send([Drive(300, 300, 2000)], old)
                link.beat()
                link.advance(0.02)
            frames = FrameReader().feed(b"".join(data for _, data in link.sent[written:]))
            assert not {f.number for f in frames} & {number_of(kind) for kind in MOTION}
            assert link.simulated.device.state is not State.DRIVING
