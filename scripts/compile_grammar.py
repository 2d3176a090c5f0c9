"""Compile the grammar and what is heard of it: run this after changing a .lark file, a form or a file of words/."""

from __future__ import annotations

import json
from pathlib import Path

from grammars import drawn, earley, heard


def main() -> None:
    """Write `grammar.json`, `heard.json` and `drawn.json` of `grammars/`."""
    folder = Path(__file__).parent.parent / "grammars"
    for name, make in (
        (earley.COMPILED, earley.compile_grammar),
        (heard.COMPILED, heard.compile_heard),
        (drawn.COMPILED, drawn.compile_drawn),
    ):
        text = json.dumps(make(), separators=(",", ":"))
        folder.joinpath(name).write_text(text + "\n", encoding="utf8")


if __name__ == "__main__":
    main()
