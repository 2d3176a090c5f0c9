"""How much faster than real time the simulated robot runs: whole chain, 30 blocks.

Run: .venv/bin/python benchmarks/simulator.py
"""

import math
import time

from daemon.link.virtual import VirtualLink
from firmware_proto.messages import Drive
from kernel.bodies.forklift.scene import Scene, Thing, usual

SECONDS = 20.0
TICK_S = 1 / 30


def blocks(count: int) -> Scene:
    """A pile in front of the robot: most of them are touched."""
    things = []
    for number in range(count):
        block = usual("block", ("red", "blue", "green")[number % 3], str(number))
        x, y = 14 + 5 * (number % 6), 5 * (number // 6) - 10
        things.append(Thing(block.noun, block.colour, block.name, False, x, y, 0.1 * number, 3, 3))
    return Scene(things=tuple(things))


def measure(count: int, drives: bool) -> float:
    """Virtual seconds per second, over the session, the line, the far end and the physics."""
    link = VirtualLink(blocks(count), seed=1)
    link.connect()
    began = time.process_time()
    for tick in range(round(SECONDS / TICK_S)):
        if drives and tick % 30 == 0:
            turn = round(150 * math.sin(tick / 40))
            link.send([Drive(250 - turn, 250 + turn, 1500)], link.stop_epoch)
        link.beat()
        link.received()
        link.advance(TICK_S)
    return SECONDS / (time.process_time() - began)


def main() -> None:
    print(f"{'world':24}{'x real time':>12}")
    for count in (0, 10, 30, 100):
        for drives in (False, True):
            name = f"{count} blocks, {'driving' if drives else 'at rest'}"
            print(f"{name:24}{measure(count, drives):12.0f}")


if __name__ == "__main__":
    main()
