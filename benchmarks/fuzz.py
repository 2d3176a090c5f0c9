"""Nonsense, read: does it break the parser, take long, or become something that moves the robot?

python benchmarks/fuzz.py [--count 20000] [--seed 1] [--list command]

Random words, examples of the language damaged and spliced, bytes (tests/grammars/salad.py). Promises: no exception but
"not understood", and nothing takes MOST_MS (CPU time: a pause of the machine is no fault of the parser's). Whatever is
understood as one of the kinds listed is printed as it was said and as it was taken, for a person to read: would they
agree with each? It fails if one of the promises is broken.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median, quantiles

from _timing import timed

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from daemon.understanding import warm_up
from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.render import render
from grammars.vocabulary import BORN
from tests.grammars.salad import ENDLESS, SORTS

MOST_MS = 200.0
COUNT = 100_000


@dataclass
class Found:
    """What came of one sort of text."""

    took_ms: list[float] = field(default_factory=list)
    slow: list[tuple[float, str]] = field(default_factory=list)
    broken: list[tuple[str, str]] = field(default_factory=list)
    kinds: Counter[str] = field(default_factory=Counter)
    understood: list[tuple[str, str, str]] = field(default_factory=list)

    def read(self, text: str) -> None:
        kind, back = "not_understood", ""

        def understand() -> None:
            nonlocal kind, back
            try:
                parsed = parse(text)
                kind, back = parsed.kind, render(parsed.meaning, "teacher")
            except NotUnderstoodError:
                pass
            except Exception as error:  # what is looked for
                kind = "broken"
                self.broken.append((text, repr(error)))

        took_ms = timed(understand, time.thread_time)
        self.took_ms.append(took_ms)
        self.kinds[kind] += 1
        if took_ms >= MOST_MS:
            self.slow.append((took_ms, text))
        if kind not in ("not_understood", "broken"):
            self.understood.append((kind, text, back))

    def row(self, name: str) -> str:
        many = sorted(self.took_ms)
        p99 = quantiles(many, n=100)[-1] if len(many) > 1 else many[0]
        return (
            f"{name:10} {len(many):7} {len(self.broken):7} {len(self.understood):7}"
            f" {median(many):8.1f} {p99:8.1f} {many[-1]:8.1f}"
        )


def main() -> int:
    told = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    told.add_argument("--count", type=int, default=COUNT)
    told.add_argument("--seed", type=int, default=1)
    told.add_argument("--list", action="append", dest="kinds", help="kinds to print (command)")
    asked = told.parse_args()
    chance = random.Random(asked.seed)
    warm_up(BORN)
    found = {name: Found() for name in (*SORTS, "endless")}
    for at in range(asked.count):
        name = list(SORTS)[at % len(SORTS)]
        found[name].read(SORTS[name](chance))
    for text in ENDLESS.values():
        found["endless"].read(text)

    print(
        f"{'':10} {'count':>7} {'broken':>7} {'taken':>7} {'median':>8} {'p99':>8} {'worst ms':>8}"
    )
    for name, one in found.items():
        print(one.row(name))
    for name, one in found.items():
        print(f"{name}: " + ", ".join(f"{kind} {many}" for kind, many in one.kinds.most_common()))
    for one in found.values():
        for text, error in one.broken:
            print(f"BROKEN {text!r}: {error}")
        for took_ms, text in one.slow:
            print(f"SLOW {took_ms:.0f} ms: {text[:300]!r}")
    wanted = set(asked.kinds or ("command",))
    for name, one in found.items():
        different = {(kind, back): text for kind, text, back in one.understood if kind in wanted}
        for (kind, back), text in sorted(different.items()):
            print(f"{name}\t{kind}\t{text}\t{back}")
    return int(any(one.broken or one.slow for one in found.values()))


if __name__ == "__main__":
    sys.exit(main())
