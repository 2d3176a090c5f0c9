"""Timing for the benchmarks: run something often, print a line of figures against its target."""

import gc
import statistics
import time
from collections.abc import Callable, Iterable


def timed(work: Callable[[], object]) -> float:
    """Wall time of one call, ms."""
    began = time.perf_counter()
    work()
    return (time.perf_counter() - began) * 1e3


def collect(work: Callable[[], object], times: int) -> list[float]:
    """Wall times of many calls, ms; garbage is collected before, not forbidden."""
    gc.collect()
    return [timed(work) for _ in range(times)]


def report(what: str, times_ms: Iterable[float], target: str = "") -> None:
    """One line: median, 95th percentile and worst, ms."""
    ordered = sorted(times_ms)
    p95 = ordered[min(len(ordered) - 1, round(0.95 * len(ordered)))]
    figures = (
        f"median {statistics.median(ordered):8.3f} ms   p95 {p95:8.3f}   worst {ordered[-1]:8.3f}"
    )
    print(f"{what:44} {figures}   n {len(ordered):5}   {target}")
