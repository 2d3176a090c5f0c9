"""Compile the grammar ahead of time: run this after changing a .lark file, a form or words/phrases.txt."""

from __future__ import annotations

import json
from pathlib import Path

from grammars.parse import COMPILED, compile_grammar


def main() -> None:
    """Write `grammars/grammar.json`."""
    target = Path(__file__).parent.parent / "grammars" / COMPILED
    target.write_text(json.dumps(compile_grammar(), separators=(",", ":")) + "\n", encoding="utf8")


if __name__ == "__main__":
    main()
