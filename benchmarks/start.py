"""From the command to ready: the daemon, and the commands that start without one."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from _timing import collect, report

SAYSO = str(Path(sys.executable).with_name("sayso"))
TIMES = 5


def until_ready(environment: dict[str, str]) -> float:
    """Start the daemon, wait for its line, end it; ms to the line."""
    began = time.perf_counter()
    daemon = subprocess.Popen(
        [SAYSO, "run"],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    assert daemon.stdout is not None
    line = daemon.stdout.readline()
    took = (time.perf_counter() - began) * 1e3
    daemon.terminate()
    if daemon.wait(10) != 0 or "ready" not in line:
        raise SystemExit(f"sayso run: {line!r}, exit status {daemon.returncode}")
    return took


def main() -> None:
    with tempfile.TemporaryDirectory(prefix="sayso-") as folder:
        directories = {
            "SAYSO_STATE_DIR": f"{folder}/state",
            "SAYSO_RUNTIME_DIR": f"{folder}/run",
            "XDG_CONFIG_HOME": folder,
        }
        environment = os.environ | directories

        def call(*words: str) -> None:
            subprocess.run([SAYSO, *words], env=environment, check=True, capture_output=True)

        report(
            "sayso run, to ready", [until_ready(environment) for _ in range(TIMES)], "target < 3 s"
        )
        report("sayso --help", collect(lambda: call("--help"), TIMES))
        report(
            'sayso parse "drive forward"', collect(lambda: call("parse", "drive forward"), TIMES)
        )
        report('sayso say "drive forward"', collect(lambda: call("say", "drive forward"), TIMES))


if __name__ == "__main__":
    main()
