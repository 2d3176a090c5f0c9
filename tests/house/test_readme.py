"""The README is true: its links lead somewhere, and its walk is what the code makes of "drive forward"."""

import re
from pathlib import Path

import pytest

from daemon import events
from daemon.config import Config
from daemon.parts import assemble_virtual
from daemon.store import Store
from firmware_proto.frame import FrameReader
from firmware_proto.messages import Drive, unpack
from grammars.parse import parse
from kernel.action.discover import load_all
from kernel.action.step import DIRECTIVES
from kernel.memory.meaning import Utterance
from kernel.memory.notation import write_meaning

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
TICK_S = 1 / 30


MIND = (ROOT / "docs/mind.md").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "page",
    [
        *("README.md", "CONTRIBUTING.md", "benchmarks/README.md"),
        *("docs/forms.md", "docs/language.md"),
    ],
)
def test_links_lead_somewhere(page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    links = [link for link in re.findall(r"\]\(([^)#]+)", text) if "://" not in link]
    assert [link for link in links if not ((ROOT / page).parent / link).exists()] == []


def test_folders_named_in_the_readme_exist() -> None:
    named = re.findall(
        r"`((?:daemon|grammars|kernel|firmware_proto|tests|docs)/[a-z_/]*/)`", README
    )
    assert named
    assert [folder for folder in named if not (ROOT / folder).is_dir()] == []


def test_the_page_on_the_mind_names_files_that_exist_and_every_directive() -> None:
    files = re.findall(r"`((?:[a-z_]+/)*[a-z_]+\.py)`", MIND)
    assert len(files) > 30
    missing = [f for f in files if not (ROOT / f).exists() and not (ROOT / "kernel" / f).exists()]
    assert missing == []
    load_all("kernel.directives")
    rows = [row.split("|")[1] for row in MIND.splitlines() if row.startswith("|")]
    told = {tag for row in rows for tag in re.findall(r"\b[A-Z]{2,6}\b", row)}
    assert told == set(DIRECTIVES)


def test_the_walk_goes_down_as_told() -> None:
    parsed = parse("drive forward")
    assert parsed.alternatives == 1
    assert str(parsed.alist.parts[0]) in README
    (written,) = write_meaning(parsed.meaning)
    told = " ".join(written.split())
    for term in ("DO[", "act-1 -lex- drive", "dir-2 -lex- forward", "-dir-> act-1"):
        assert term in told
        assert term in README


def drives(data: bytes) -> list[str]:
    """DRIVE messages among bytes on the wire, as the README writes them: the deadline is the session's."""
    messages = [unpack(frame.number, frame.payload) for frame in FrameReader().feed(data)]
    return [
        f"Drive(left_permille={m.left_permille}, right_permille={m.right_permille}, hold_ms={m.hold_ms})"
        for m in messages
        if isinstance(m, Drive)
    ]


def test_the_walk_ends_on_the_wire_and_comes_back_as_told() -> None:
    told: list[events.Event] = []
    store = Store.in_memory()
    parts = assemble_virtual(Config(), store, told.append)
    cycle, link = parts.cycle, parts.link

    def run(seconds: float) -> None:
        for _ in range(round(seconds / TICK_S)):
            link.advance(TICK_S)
            cycle.step(link.now_s)

    link.connect()
    run(1 / 3)
    before = len(link.sent)
    cycle.hear(Utterance("drive forward"))
    cycle.step(link.now_s)
    (drive,) = drives(b"".join(data for _, data in link.sent[before:]))
    assert f"`{drive}`" in README
    (written,) = re.findall(r"`((?:[0-9a-f]{2} )+00)`", README)
    assert drives(bytes.fromhex(written)) == [drive]

    run(2.0)
    (ended,) = [event for event in told if isinstance(event, events.ActionEnded)]
    assert f"FCN[{ended.function}]" in README
    assert f"`{ended.verdict}`" in README
    assert f"come {cycle.pose.x_cm:.0f} cm" in README
    store.close()
