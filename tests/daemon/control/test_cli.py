"""The command line: exit statuses, clear messages, nothing loaded that is not needed."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import wave
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from daemon.control import cli as command_line
from daemon.control.cli import cli

FIELDS = {
    *("text", "kind", "readback", "notation", "words", "steps", "parallel", "negated"),
    *("preference", "belief", "trigger", "ask", "unknown_words", "alternatives", "ms"),
}


@pytest.fixture
def folder(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="sayso-") as name:
        monkeypatch.setenv("SAYSO_STATE_DIR", name)
        yield Path(name)


def call(*arguments: str, given: bytes | None = None) -> Result:
    return CliRunner().invoke(cli, arguments, input=given)


def test_help_loads_nothing_but_the_command_line() -> None:
    code = (
        "import sys, daemon.control.cli\n"
        "heavy = {'lark', 'numpy', 'pymunk', 'msgspec', 'rich', 'soundfile', 'asyncio', 'serial'}\n"
        "print(sorted(heavy & set(sys.modules)), sorted(m for m in sys.modules if m.startswith"
        "(('kernel', 'grammars'))))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "[] []\n"


def test_help_names_every_command_and_the_exit_statuses() -> None:
    shown = call("--help").output
    for name in ("run", "say", "hear", "stop", "parse", "rehearse", "demo", "status"):
        assert f"\n  {name} " in shown
    assert "3 not understood" in shown


@pytest.mark.parametrize(
    ("text", "status", "shown"),
    [
        ("drive forward", 0, "drive forward: succeeded"),
        ("then the if of slowly block the", 3, "unclear"),
        ("grab the block", 1, "failed"),
        ("stop", 0, "stopped"),
    ],
)
def test_say_without_a_daemon_does_it_here(
    folder: Path, text: str, status: int, shown: str
) -> None:
    result = call("say", text)
    assert result.exit_code == status, result.output
    assert shown in result.output


def test_what_is_taught_without_a_daemon_is_kept(folder: Path) -> None:
    assert call("say", "never grab a person", "--speaker", "Mary").exit_code == 0
    assert call("say", "mary is a person").exit_code == 0
    result = call("say", "grab mary")
    assert result.exit_code == 1
    assert "forbidden   by: never grab a person" in result.output


@pytest.mark.parametrize(
    "arguments",
    [
        ("say",),
        ("say", ""),
        ("say", " "),
        ("say", "x" * 1001),
        ("say", "drive", "forward"),
        ("hear", "/no/such/file.wav"),
        ("rehearse", "/no/such/file.txt"),
        ("dance",),
        ("run", "--loud"),
        ("demo", "--engine", "ear"),
    ],
)
def test_wrong_usage_is_2(folder: Path, arguments: tuple[str, ...]) -> None:
    result = call(*arguments)
    assert result.exit_code == 2
    assert "Error:" in result.output
    assert not list(folder.iterdir())


@pytest.mark.parametrize("command", ["stop", "status"])
def test_what_needs_a_daemon_says_so(folder: Path, command: str) -> None:
    result = call(command)
    assert result.exit_code == 1
    assert "no daemon runs (start it with: sayso run)" in result.output


def test_parse_for_a_person() -> None:
    result = call("parse", "drive forward")
    assert result.exit_code == 0
    assert result.output.splitlines()[0] == "command: drive forward"
    assert "-lex-  drive" in result.output
    assert call("parse", "then the if of slowly block the").exit_code == 3


def test_parse_explains_its_choice() -> None:
    lines = call("parse", "--explain", "say hello then turn left").output.splitlines()
    assert "1. cost" in " ".join(lines)
    assert any(line.startswith("2. cost") for line in lines)
    assert any("act=turn" in line for line in lines)
    assert lines[-1].startswith("The first wins: it costs")
    alone = call("parse", "--explain", "drive forward").output
    assert "no other reading means anything" in alone
    assert call("parse", "--explain", "--json", "drive forward").exit_code == 2


def test_parse_answers_every_line_whatever_it_is() -> None:
    lines = [
        b"drive forward",
        b"",
        b"To cha-cha drive forward then drive backwards\r",
        b"dr\xffve forward",
        b"\x00\x01\x1b[31m",
        b"drive " * 5000,
        b'say "',
        "fahr vorwärts \U0001f916".encode(),
    ]
    result = call("parse", "--json", "-", given=b"\n".join(lines) + b"\n")
    answers = [json.loads(line) for line in result.stdout.splitlines()]
    assert result.exit_code == 0
    assert len(answers) == len(lines)
    assert [a["kind"] for a in answers[:4]] == [
        *("command", "not_understood", "procedure", "not_understood"),
    ]
    assert all(set(answer) >= FIELDS for answer in answers)
    assert answers[2]["text"] == "To cha-cha drive forward then drive backwards"
    assert (answers[2]["steps"], answers[2]["preference"]) == (2, 1.0)
    assert all(answer["reason"] for answer in answers if answer["kind"] == "not_understood")


def test_a_sentence_that_breaks_the_parser_does_not_end_the_list(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def broken(text: str, *_: object) -> None:
        raise KeyError(text)

    monkeypatch.setattr("daemon.control.describing.parse", broken)
    result = call("parse", "--json", given=b"one\ntwo\n")
    assert ["internal error" in json.loads(x)["reason"] for x in result.stdout.splitlines()] == [
        True,
        True,
    ]


@pytest.mark.parametrize(
    ("error", "status", "said"),
    [
        (OSError(28, "No space left on device"), 1, "sayso: [Errno 28] No space left on device\n"),
        (KeyError("act-1"), 1, "sayso: internal error (KeyError: 'act-1'); SAYSO_DEBUG=1"),
    ],
)
def test_errors_are_one_line(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    error: Exception,
    status: int,
    said: str,
) -> None:
    def fail(**_: object) -> None:
        raise error

    monkeypatch.setattr(command_line.cli, "main", fail)
    with pytest.raises(SystemExit) as ended:
        command_line.main()
    assert ended.value.code == status
    shown = capsys.readouterr().err
    assert shown.startswith(said)
    assert shown.count("\n") == 1


def test_a_sound_file_without_words_is_not_understood(folder: Path) -> None:
    silence = folder / "silence.wav"
    with wave.open(str(silence), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(16_000)
        file.writeframes(bytes(32_000))
    result = call("hear", str(silence))
    assert result.exit_code == 3, result.output


def test_a_recording_is_heard_and_done(folder: Path) -> None:
    audio = Path(command_line.__file__).parents[1] / "demo" / "audio" / "01-drive-forward.wav"
    result = call("hear", str(audio))
    assert result.exit_code == 0, result.output
    assert "drive forward: succeeded" in result.output
