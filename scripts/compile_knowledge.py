"""Write grammars/knowledge/born.net from the sentences beside it: run after changing them or the parser."""

from __future__ import annotations

from pathlib import Path

from grammars import knowledge
from grammars.knowledge.compiling import compiled


def main() -> None:
    """Write the file and say which."""
    target = Path(knowledge.__file__).with_name(knowledge.COMPILED)
    target.write_text(compiled(), "utf8")
    print(target)


if __name__ == "__main__":
    main()
