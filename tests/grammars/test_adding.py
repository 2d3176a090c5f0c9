"""docs/forms.md is true: the form it adds, added to a copy, is understood, read back and listened for."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from grammars.errors import NotUnderstoodError
from grammars.heard import automaton
from grammars.parse import parse

ROOT = Path(__file__).parents[2]
LARK, BUILDER = re.findall(
    r"```(?:lark|python)\n(.*?)```", (ROOT / "docs/forms.md").read_text("utf8"), re.DOTALL
)
SAID = "i dare you to turn left"
SPEECH = ROOT / "tests/audio/hearing/flite-slt/i-dare-you-to-turn-left.wav"

pytestmark = [pytest.mark.long, pytest.mark.timeout(180)]  # the fixture compiles a grammar


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sayso with the form added, its grammar compiled."""
    folder = tmp_path_factory.mktemp("copy")
    for part in ("grammars", "scripts"):
        shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "grammars/forms/dare.lark").write_text(LARK, encoding="utf8")
    (folder / "grammars/forms/dare.py").write_text(BUILDER, encoding="utf8")
    python(folder, str(folder / "scripts/compile_grammar.py"))
    return folder


def python(folder: Path, *arguments: str) -> str:
    """What Python printed, with the copy before the checkout."""
    result = subprocess.run(
        [sys.executable, *arguments],
        env={**os.environ, "PYTHONPATH": os.pathsep.join((str(folder), str(ROOT)))},
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=160,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def test_without_the_form_it_means_nothing() -> None:
    with pytest.raises(NotUnderstoodError):
        parse(SAID)
    assert not automaton().accepts(SAID.split())


def test_the_command_line_understands_the_examples_and_reads_them_back(copy: Path) -> None:
    cli = "from daemon.control.cli import main; main()"
    for text, meant in (
        (SAID, "turn left"),
        (
            "I double dare you to grab the block then drive backwards!",
            "grab the block then drive backward",
        ),
    ):
        answer = json.loads(python(copy, "-c", cli, "parse", "--json", text))
        assert (answer["kind"], answer["readback"]) == ("command", meant)


def test_the_form_is_in_the_compiled_grammar(copy: Path) -> None:
    kept = json.loads((copy / "grammars/grammar.json").read_text("utf8"))
    assert "dare" in {rule[0] for rule in kept["rules"]}
    assert "dare" in kept["literal"]


def test_the_ears_listen_for_sentences_like_its_examples(copy: Path) -> None:
    listening = (
        "import sys; from grammars.heard import automaton;"
        "print([automaton().accepts(said.split()) for said in sys.argv[1:]])"
    )
    like = "robot i dare you to turn around then grab the green cup"
    assert python(copy, "-c", listening, SAID, like, "i dare you").strip() == "[True, True, False]"


@pytest.mark.parametrize("engine", ["vosk", "pocketsphinx"])
def test_it_is_heard(copy: Path, engine: str) -> None:
    hearing = """
import sys
from pathlib import Path
from daemon.hearing import recording
from daemon.hearing.choice import Engine
from daemon.hearing.events import Heard
from daemon.hearing.transcribe import Transcriber
from grammars.language import language
with Transcriber(Engine(sys.argv[1]), language()) as transcriber:
    events = transcriber.transcribe(recording.read(Path(sys.argv[2])), lambda text: True)
    print([event.text for event in events if isinstance(event, Heard)])
"""
    assert python(copy, "-c", hearing, engine, str(SPEECH)).strip() == str([SAID])
