"""The unit as systemd itself reads it. `systemd-analyze verify` returns 0 on misspelt keys: any output is a failure."""

from __future__ import annotations

import configparser
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from daemon.config import EXIT_CONFIG

UNIT = Path(__file__).parents[2] / "systemd" / "sayso.service"
needs_systemd = pytest.mark.skipif(
    shutil.which("systemd-analyze") is None, reason="systemd-analyze is not installed"
)


def installed(tmp_path: Path, text: str) -> Path:
    """A copy whose program exists here."""
    unit = tmp_path / "sayso.service"
    unit.write_text(re.sub(r"ExecStart=\S+", f"ExecStart={sys.executable}", text))
    return unit


def verify(unit: Path) -> str:
    run = subprocess.run(
        ["systemd-analyze", "verify", str(unit)], capture_output=True, text=True, check=False
    )
    return run.stdout + run.stderr


@needs_systemd
def test_systemd_has_nothing_to_say_about_it(tmp_path: Path) -> None:
    assert verify(installed(tmp_path, UNIT.read_text())) == ""


@needs_systemd
def test_a_misspelt_key_would_be_noticed(tmp_path: Path) -> None:
    text = UNIT.read_text().replace("WatchdogSec", "WatchDogSec")
    assert "WatchDogSec" in verify(installed(tmp_path, text))


@needs_systemd
def test_it_is_hardened(tmp_path: Path) -> None:
    run = subprocess.run(
        [
            "systemd-analyze",
            "security",
            "--offline=true",
            str(installed(tmp_path, UNIT.read_text())),
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    match = re.search(r"Overall exposure level for \S+: ([0-9.]+)", run.stdout)
    assert match is not None
    assert float(match[1]) <= 1.5


def test_it_is_told_when_ready_watched_and_not_restarted_on_a_bad_configuration() -> None:
    unit = configparser.RawConfigParser(strict=False)
    unit.optionxform = str  # type: ignore[assignment,method-assign]
    unit.read_string(UNIT.read_text())
    service = unit["Service"]
    assert service["Type"] == "notify"
    assert int(service["WatchdogSec"]) >= 2
    assert service["Restart"] == "on-failure"
    assert service["RestartPreventExitStatus"] == str(EXIT_CONFIG)
    assert service["StateDirectory"] == service["RuntimeDirectory"] == "sayso"
