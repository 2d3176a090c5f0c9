"""Commands for what was taught, as a user gives them: what they print, what they change, how they end."""

from __future__ import annotations

import json
import sqlite3
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from daemon.config import Config
from daemon.control.cli import cli
from daemon.control.reach import Alone
from daemon.store import Store
from kernel.memory.change import Adapted, Change


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="sayso-") as name:
        monkeypatch.setenv("SAYSO_STATE_DIR", name)
        yield Path(name)


def call(*arguments: str, given: bytes | None = None) -> Result:
    return CliRunner().invoke(cli, arguments, input=given)


def taught(*sentences: str, speaker: str = "") -> None:
    """Teach them, in this process and without a daemon."""
    with Alone(Config()) as robot:
        for sentence in sentences:
            assert robot.say(sentence, speaker, lambda _event: None) == "done"


def in_force() -> list[str]:
    with Alone(Config()) as robot:
        return [row.text for row in robot.lessons() if row.counts]


THREE = ("never grab a cup", "to zorp, turn left", "Mary is a girl")


class TestLessons:
    def test_nothing_taught(self) -> None:
        result = call("lessons")
        assert (result.exit_code, result.stdout) == (
            0,
            'nothing was taught (try: sayso say "to dance, turn around twice")\n',
        )
        assert call("lessons", "--json").stdout == ""

    def test_a_table_of_what_is_in_force(self) -> None:
        taught(*THREE, speaker="Mary")
        lines = call("lessons").stdout.splitlines()
        assert lines[0].split() == ["no.", "kind", "lesson", "taught", "by", "when"]
        assert [line.split()[:2] for line in lines[1:]] == [
            ["1", "prohibition"],
            ["2", "procedure"],
            ["3", "fact"],
        ]
        assert all("Mary" in line for line in lines[1:])

    def test_words_filter(self) -> None:
        taught(*THREE)
        assert "zorp" in call("lessons", "turn", "zorp").stdout
        assert "grab" not in call("lessons", "turn", "zorp").stdout
        assert call("lessons", "unicorn").stdout == "no lesson has these words\n"

    def test_all_shows_what_was_taken_back_and_what_rests(self, folder: Path) -> None:
        taught(*THREE)
        assert call("forget", "1").exit_code == 0
        store = Store.open(folder / "lessons.sqlite")
        store._db.execute("UPDATE lesson SET notation = 'gibberish' WHERE ident = 2")
        store.close()
        result = call("lessons")
        assert "grab" not in result.stdout
        assert "zorp" not in result.stdout
        assert "1 taken back, 1 lesson rests (sayso lessons --all)" in result.stderr
        shown = call("lessons", "--all").stdout
        assert "taken back" in shown
        assert "rests: " in shown
        answers = [
            json.loads(line) for line in call("lessons", "--all", "--json").stdout.splitlines()
        ]
        assert [a["standing"] for a in answers] == ["taken back", "rests", "in force"]
        assert answers[2]["notation"]
        assert (answers[1]["words"], answers[1]["why"] != "") == ("to zorp, turn left", True)

    def test_what_rests_can_be_forgotten_and_brought_back(self, folder: Path) -> None:
        taught(*THREE)
        store = Store.open(folder / "lessons.sqlite")
        store._db.execute("UPDATE lesson SET notation = '' WHERE ident = 2")
        store.close()
        for command, standing in (
            (("forget", "2"), "taken back"),
            (("undo",), "rests"),
            (("undo",), "taken back"),
        ):
            assert call(*command).exit_code == 0
            assert call("lessons", "--all").exit_code == 0
            lines = call("lessons", "--all", "--json").stdout.splitlines()
            found = [json.loads(line)["standing"] for line in lines]
            assert found == ["in force", standing, "in force"]

    def test_a_strength_that_moved_and_what_it_made_itself(self, folder: Path) -> None:
        taught("to zorp, you could turn left")
        store = Store.open(folder / "lessons.sqlite")
        (lesson,) = store.load().lessons
        store.add(Change(learned=(replace(lesson, origins=(1,), ident=0),), own=True))
        store.add(Change(adapted=(Adapted(1, 0.8, 0.35),), own=True))
        store.close()
        shown = call("lessons").stdout
        assert "0.35 (taught 0.80)" in shown
        assert "itself, from 1" in shown

    def test_recheck(self, folder: Path) -> None:
        taught(*THREE)
        assert (
            call("lessons", "--recheck").stdout
            == "the words of every lesson mean what they meant\n"
        )
        store = Store.open(folder / "lessons.sqlite")
        store._db.execute("UPDATE lesson SET words = 'to zorp, turn right' WHERE ident = 2")
        store.close()
        result = call("lessons", "--recheck")
        assert "to zorp, turn right" in result.stdout
        assert "grab" not in result.stdout
        (answer,) = map(json.loads, call("lessons", "--recheck", "--json").stdout.splitlines())
        assert (answer["number"], answer["now"]) == (2, "procedure")
        assert len(in_force()) == 3, "nothing was changed"


class TestForget:
    def test_numbers(self) -> None:
        taught(*THREE)
        result = call("forget", "1", "3")
        assert result.exit_code == 0
        assert "forgotten   1: never grab a cup" in result.stdout
        assert in_force() == ["to zorp, turn left"]

    @pytest.mark.parametrize(
        ("numbers", "why"),
        [
            (("2", "9"), "there is no lesson 9; nothing was changed"),
            (("1", "1"), "lesson 1 was taken back already"),
        ],
    )
    def test_wrong_numbers_change_nothing(self, numbers: tuple[str, ...], why: str) -> None:
        taught(*THREE)
        assert call("forget", "1").exit_code == 0
        result = call("forget", *numbers)
        assert result.exit_code == 1
        assert why in str(result.exception)
        assert len(in_force()) == 2

    @pytest.mark.parametrize(
        "words",
        [(), ("0", "-1"), ("-1",), ("0",), ("9" * 30,), tuple(map(str, range(101))), (" ",)],
    )
    def test_wrong_usage(self, words: tuple[str, ...]) -> None:
        assert call("forget", *words).exit_code == 2

    @pytest.mark.parametrize(
        ("words", "said"),
        [
            (("how", "to", "zorp"), "forget how to zorp"),
            (("forget how to zorp",), "forget how to zorp"),
        ],
    )
    def test_words_are_said(self, words: tuple[str, ...], said: str) -> None:
        taught(*THREE)
        assert f"heard       {said}\n" in call("forget", *words).stdout


def test_what_nobody_is_left_to_answer_ends_as_without_an_answer() -> None:
    taught("never lift a cup")
    result = call("say", "you may lift a cup")
    assert (result.exit_code, "Okay. I may lift a cup." in result.stdout) == (0, True)
    assert in_force() == ["never lift a cup", "you may lift a cup"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("undo",), "undo that"),
        (("undo", "--today"), "undo everything from today"),
        (("why",), "why did you do that"),
        (("why", "did", "you", "do", "that"), "why did you do that"),
        (("why", "who taught you to dance"), "who taught you to dance"),
    ],
)
def test_undo_and_why_are_said(arguments: tuple[str, ...], said: str) -> None:
    assert f"heard       {said}\n" in call(*arguments).stdout


class TestExportAndTeach:
    def test_a_round_trip_through_files(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        taught(*THREE, "to fribble, zorp then turn around")
        file = folder / "lessons.txt"
        result = call("export", str(file))
        assert (result.exit_code, result.stderr) == (0, f"{file}: 4 lessons\n")
        before = sorted(in_force())
        with tempfile.TemporaryDirectory(prefix="sayso-") as other:
            monkeypatch.setenv("SAYSO_STATE_DIR", other)
            result = call("teach", str(file), "--speaker", "Rick")
            assert (result.exit_code, result.stdout) == (0, "4 new, 0 known already\n")
            assert sorted(in_force()) == before
            with Alone(Config()) as robot:
                assert {row.teacher for row in robot.lessons()} == {"rick"}
            result = call("teach", str(file))
            assert (result.exit_code, result.stdout) == (0, "0 new, 4 known already\n")

    def test_kinds_and_the_screen(self) -> None:
        taught(*THREE)
        shown = call("export", "--kind", "fact", "--kind", "procedure").stdout
        assert "Mary is a girl" in shown
        assert "zorp" in shown
        assert "grab" not in shown
        assert call("export", "--kind", "joke").exit_code == 2

    def test_a_file_is_not_written_over_unless_asked_for(self, folder: Path) -> None:
        file = folder / "mine.txt"
        file.write_text("mine")
        result = call("export", str(file))
        assert result.exit_code == 1
        assert "--force" in result.output
        assert file.read_text() == "mine"
        assert call("export", str(file), "--force").exit_code == 0
        assert file.read_text().startswith("# What this robot was taught: 0 lessons.")
        result = call("export", str(folder / "no" / "such"))
        assert result.exit_code == 1
        assert "cannot be written (No such file or directory)" in result.output
        assert not list(folder.glob(".*half"))

    def test_one_wrong_line_and_nothing_is_taught(self, folder: Path) -> None:
        file = folder / "f.txt"
        file.write_text("to zorp, turn left\ndrive forward\n\nthe if of\n")
        result = call("teach", str(file))
        assert result.exit_code == 3
        assert f"{file}:2: 'drive forward': a command is no lesson" in result.stderr
        assert f"{file}:4: 'the if of': I did not understand" in result.stderr
        assert "nothing was taught: 2 wrong lines" in result.stderr
        assert in_force() == []

    def test_dry_run(self) -> None:
        result = call("teach", "-", "--dry-run", given=b"to zorp, turn left\nnever grab a cup\n")
        assert result.exit_code == 0
        assert "-:2: prohibition: never grab a cup\n" in result.stdout
        assert "2 new, 0 known already; nothing was taught" in result.stdout
        assert in_force() == []

    def test_who_teaches_and_facts_that_do_not_last(self) -> None:
        given = b"# note\nyou(Rick): never grab a cup\nthe block is red\nto zorp, turn left\n"
        result = call("teach", "-", "--speaker", "Mary", given=given)
        assert result.exit_code == 0
        assert result.stdout == (
            "2 new, 0 known already, 1 fact noted and forgotten with this command\n"
        )
        with Alone(Config()) as robot:
            assert [row.teacher for row in robot.lessons()] == ["rick", "mary"]

    def test_what_the_robot_refuses_is_told(self, monkeypatch: pytest.MonkeyPatch) -> None:
        def full(self: Store, change: Change, source: str = "") -> Change:
            raise sqlite3.OperationalError("disk full")

        monkeypatch.setattr(Store, "add", full)
        result = call("teach", "-", given=b"never grab a cup\n")
        assert result.exit_code == 1
        assert "-:1: 'never grab a cup': not learned: " in result.stderr
        assert "0 new, 0 known already, 1 not learned" in result.stdout

    @pytest.mark.parametrize("data", [b"never grab a cup\n\xff\xfe\n", b"\x00\x00"])
    def test_what_is_no_text(self, folder: Path, data: bytes) -> None:
        file = folder / "f"
        file.write_bytes(data)
        result = call("teach", str(file))
        assert result.exit_code == 1
        assert "is not text" in result.output
        assert in_force() == []

    def test_what_is_no_file(self, folder: Path) -> None:
        assert call("teach", str(folder / "none")).exit_code == 2
        assert call("teach", str(folder)).exit_code == 2
        assert call("teach").exit_code == 2

    def test_an_empty_file_teaches_nothing(self) -> None:
        result = call("teach", "-", given=b"# nothing\n\n")
        assert (result.exit_code, result.stdout) == (0, "0 new, 0 known already\n")


class TestLog:
    def test_what_was_said_and_what_came_of_it(self) -> None:
        assert call("log").stderr == "nothing was said yet\n"
        taught("never grab a cup", speaker="Mary")
        call("forget", "1", "--speaker", "Rick")
        lines = [line.split(maxsplit=4)[2:] for line in call("log").stdout.splitlines()]
        assert lines == [
            ["Mary", "said", "never grab a cup (prohibition)"],
            ["Mary", "learned", "1: never grab a cup (prohibition)"],
            ["Rick", "said", "forget 1 (control)"],
            ["Rick", "retracted", "1: never grab a cup"],
        ]
        answers = [json.loads(x) for x in call("log", "-n", "3", "--json").stdout.splitlines()]
        assert [a["what"] for a in answers] == ["learned", "said", "retracted"]

    def test_wrong_usage_and_nothing_to_follow(self) -> None:
        assert call("log", "-n", "0").exit_code == 2
        result = call("log", "--follow")
        assert result.exit_code == 1
        assert "no daemon runs" in result.output


def test_a_store_in_use_by_another_says_so(folder: Path) -> None:
    store = Store.open(folder / "lessons.sqlite")
    for arguments in (("lessons",), ("export",), ("log",), ("forget", "1")):
        result = call(*arguments)
        assert result.exit_code == 1
        assert "in use by another sayso" in str(result.exception)
    store.close()


def test_a_closed_pipe_is_no_traceback(folder: Path) -> None:
    taught(*THREE)
    code = "import sys; from daemon.control.cli import main; sys.argv = ['sayso', {!r}]; main()"
    for command in ("lessons", "export", "log"):
        with subprocess.Popen(
            [sys.executable, "-c", code.format(command)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        ) as process:
            assert process.stdout is not None
            assert process.stderr is not None
            process.stdout.close()
            assert process.stderr.read() == b"", command


@pytest.mark.parametrize(
    "command", ["lessons", "forget", "undo", "why", "export", "teach", "log", "talk"]
)
def test_help_says_what_it_does(command: str) -> None:
    shown = call(command, "--help").stdout
    assert shown.startswith("Usage: ")
    assert len(shown.splitlines()) > 6
    assert f"\n  {command} " in call("--help").stdout
