"""A typed command of two to four words: from the text to the first byte on the wire, everything in between included.

Times are of this thread, which other processes do not lengthen: nothing here waits for a disk or a line.
"""

import gc
import time
from statistics import median, quantiles

from daemon.config import Config
from daemon.parts import assemble_virtual
from daemon.store import Store
from kernel.memory.meaning import Utterance

COMMANDS = [
    "drive forward",
    "turn left",
    "drive backwards slowly",
    "turn right twice",
    "drive forward very slowly",
]
TICK_S = 1 / 30
REPEATS = 30


def main() -> None:
    store = Store.in_memory()
    parts = assemble_virtual(Config(), store, lambda event: None)
    cycle, link = parts.cycle, parts.link
    if not link.connect():
        raise SystemExit("the simulated robot does not answer")

    def pass_time(seconds: float) -> None:
        until_s = link.now_s + seconds
        while link.now_s < until_s:
            link.advance(TICK_S)
            cycle.step(link.now_s)

    pass_time(1.0)
    cycle.hear(
        Utterance("turn around", at_s=link.now_s)
    )  # the daemon warms its parser up when it starts
    pass_time(6.0)
    times: list[float] = []
    for text in COMMANDS * REPEATS:
        before = len(link.sent)

        gc.collect()
        began_s = time.thread_time()
        cycle.hear(Utterance(text, at_s=link.now_s))
        cycle.step(link.now_s)
        times.append((time.thread_time() - began_s) * 1e3)
        if len(link.sent) == before:
            raise SystemExit(f"{text}: nothing was sent")
        pass_time(6.0)
    half, most = median(times), quantiles(times, n=100)[98]
    print(
        f"typed command to first byte: median {half:.1f} ms, p99 {most:.1f} ms, of {len(times)}"
        " (targets < 8 ms and < 25 ms)"
    )
    store.close()


if __name__ == "__main__":
    main()
