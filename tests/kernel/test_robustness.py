"""Whatever is taught, commanded, stopped and sensed in whatever order: the promises that always hold (watched.py).

No exception; wheels idle when nobody bids; bounded memory; every focus ends or waits for a named thing; what is
forbidden never reaches the body; a stop within one tick; a restart knows the same; the same seed gives the same trace.
"""

from __future__ import annotations

import os
import random
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.kernel.session import Line, a_line
from tests.kernel.watched import Watched

ROOT: Final = Path(__file__).resolve().parents[2]
lines = st.integers(0, 2**32).map(lambda number: a_line(random.Random(number)))


@pytest.mark.timeout(300)
@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(lines, min_size=5, max_size=40), st.integers(0, 1000))
def test_the_promises_hold_in_any_order(
    make_robot: Callable[..., Any], session: list[Line], seed: int
) -> None:
    watched = Watched(make_robot, seed)
    for line in session:
        watched.play(line)


@pytest.mark.timeout(300)
def test_a_long_session(make_robot: Callable[..., Any]) -> None:
    """800 lines, 15,000 ticks and more."""
    chance = random.Random(7)
    watched = Watched(make_robot, 7)
    for _ in range(800):
        watched.play(a_line(chance))
    watched.robot.stop()
    watched.wait(60)
    assert not watched.robot.out.busy
    assert not watched.robot.body.state.moving


TRACED: Final = """
import random, sys
from grammars.replies import say
from tests.kernel.conftest import Robot
from tests.kernel.session import a_line
from tests.kernel.watched import Watched
spare = [object() for _ in range(int(sys.argv[1]))]  # nodes come to lie elsewhere
chance, watched = random.Random(11), Watched(Robot, 11)
for _ in range(150):
    watched.play(a_line(chance))
for record in watched.robot.trace:
    print(record)
for reply in watched.robot.replies:
    print(say(reply))
"""


@pytest.mark.timeout(300)
def test_the_same_seed_gives_the_same_trace_in_every_process() -> None:
    """Neither the hashes of words nor where nodes lie in memory decide anything."""
    running = [
        subprocess.Popen(
            [sys.executable, "-c", TRACED, spare],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)},
            stdout=subprocess.PIPE,
            text=True,
        )
        for seed, spare in (("1", "7"), ("2", "12345"))
    ]
    traces = [process.communicate()[0] for process in running]
    assert traces[0] == traces[1]
    assert traces[0].count("\n") > 500


@pytest.mark.timeout(300)
def test_the_soak_runs_and_judges() -> None:
    """Ten simulated minutes; the whole of it is benchmarks/soak.py, which is not run here."""
    soak = [sys.executable, ROOT / "benchmarks" / "soak.py", "--hours", "0.17"]
    done = subprocess.run(soak, cwd=ROOT, capture_output=True, text=True, check=False)
    assert "no promise was broken, and the store has the policy" in done.stdout, done.stderr
    assert "memory flat" in done.stdout
    assert "time a tick" in done.stdout
