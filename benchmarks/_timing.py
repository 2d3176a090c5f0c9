"""Measuring for the benchmarks: run something often, print a line of figures against its target."""

import gc
import platform
import resource
import statistics
import time
from collections.abc import Callable, Iterable
from pathlib import Path


def timed(work: Callable[[], object], clock: Callable[[], float] = time.perf_counter) -> float:
    """Wall time of one call, ms; by time.thread_time that of this thread, which no other process lengthens."""
    began = clock()
    work()
    return (clock() - began) * 1e3


def resident_mb() -> float:
    """Memory of this process, MB."""
    status = Path("/proc/self/status")
    if status.exists():
        (line,) = (x for x in status.read_text().splitlines() if x.startswith("VmRSS"))
        return int(line.split()[1]) / 1024
    used = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # the most there ever was
    return used / (1024**2 if platform.system() == "Darwin" else 1024)


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
