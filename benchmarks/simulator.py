"""The simulated forklift, protocol and physics, driving among 30 blocks: how much faster than real time."""

import math
import time
from dataclasses import replace

from daemon.link.virtual import VirtualLink
from firmware_proto.messages import Drive
from kernel.bodies.forklift.scene import Scene, usual

BLOCKS = 30
SECONDS = 60.0
TICK_S = 1 / 30


def ring() -> Scene:
    """Blocks in two rings, near enough to be pushed."""
    blocks = []
    for number in range(BLOCKS):
        bearing, away_cm = 2 * math.pi * number / BLOCKS, 25 + 12 * (number % 2)
        blocks.append(
            replace(
                usual("block"), x_cm=away_cm * math.cos(bearing), y_cm=away_cm * math.sin(bearing)
            )
        )
    return Scene(things=tuple(blocks))


def main() -> None:
    link = VirtualLink(ring())
    if not link.connect():
        raise SystemExit("the simulated robot does not answer")
    began, start_s = time.perf_counter(), link.now_s
    due_s = link.now_s
    while link.now_s - start_s < SECONDS:
        if link.now_s >= due_s:
            due_s = link.now_s + 0.9
            link.send([Drive(400, 250 if int(link.now_s) % 4 else 400, 1000)], link.stop_epoch)
        link.beat()
        link.advance(TICK_S)
        link.received()
    wall_s = time.perf_counter() - began
    moved = math.hypot(link.simulated.world.truth().x_cm, link.simulated.world.truth().y_cm)
    print(
        f"{BLOCKS} blocks, {SECONDS:.0f} s of driving (it ended {moved:.0f} cm from where it began)"
    )
    print(f"{SECONDS / wall_s:6.1f} times real time   target > 30")


if __name__ == "__main__":
    main()
