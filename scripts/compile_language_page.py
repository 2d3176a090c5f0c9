"""Write docs/language.md from the sentence forms: run this after changing a form's EXAMPLES, what a net reads back as
or what may be heard."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Final

from grammars.automaton import Automaton
from grammars.heard import automaton, said
from grammars.parse import parse
from grammars.registry import Form, discover
from grammars.render import render

TARGET: Final = Path(__file__).parent.parent / "docs" / "language.md"
READING_ORDER: Final = (
    *("command", "procedure", "reaction", "before", "after", "prohibition", "permission", "rule"),
    *("fact", "alias", "question", "answer", "revision", "feedback", "control", "identity"),
)
"""From doing to teaching to talking. A kind not named here comes last."""

OPENING: Final = """# What can be said

Made by `scripts/compile_language_page.py` from the examples of the sentence forms; a test fails while it is stale.

Say it as to a person who is willing but takes you at your word. The sentences here are examples, not the language:
other verbs, things, amounts and orders of words go in their places, and "please", "robot" or "could you" go with most.
Every sentence is read back in two voices. The first says the lesson as a teacher would, in words that mean the same
when said again (`sayso export` writes it, `sayso teach` learns it); the second is how the robot puts it.
`sayso parse "a sentence"` shows what any sentence means and does nothing; with `--explain` it shows why.
DO, ANTE and the other words in capitals are the directives of [the mind](mind.md); [net.md](net.md) tells what a
meaning is made of, and [forms.md](forms.md) how to add a form of sentence.

"Heard" marks what the recognisers listen for with the words known at birth; the rest is typed, or heard if it is clear.
"""


def page() -> str:
    """The whole page."""
    forms = list(discover().values())
    parts = [OPENING]
    for kind in dict.fromkeys((*READING_ORDER, *sorted(form.kind for form in forms))):
        parts.append(f"## {kind.capitalize()}\n")
        parts += [_section(form) for form in forms if form.kind == kind]
    parts += ["## What is heard as well as typed\n", _hearing(forms)]
    return "\n".join(parts)


def _section(form: Form) -> str:
    """What a form does, and its examples: with what they mean, where that does not hang on a question."""
    told = _purpose(form)
    if form.expected:
        return f"{told}\n\n" + "".join(f"- {example}\n" for example in form.examples)
    rows = (
        (example, *_read_back(example), "yes" if _is_heard(example) else "")
        for example in form.examples
    )
    return f"{told}\n\n" + _table(("you say", "read back", "the robot says", "heard"), rows)


def _purpose(form: Form) -> str:
    """The first paragraph of its module's docstring: "Commands: do it now."."""
    paragraph = (sys.modules[form.build.__module__].__doc__ or "").split("\n\n")[0]
    title, _, told = " ".join(paragraph.split()).partition(": ")
    return f"**{title}**: {told}"


def _read_back(example: str) -> tuple[str, str]:
    meaning = parse(example).meaning
    return render(meaning, "teacher"), render(meaning, "robot")


@cache
def _listened_for() -> Automaton:
    return automaton()


def _is_heard(example: str) -> bool:
    return _listened_for().accepts(said(example).split())


def _hearing(forms: Iterable[Form]) -> str:
    """How many examples of each form the recognisers listen for."""
    counts = (
        f"{form.name} {sum(map(_is_heard, form.examples))} of {len(form.examples)}"
        for form in forms
    )
    return (
        "The recognisers listen for a part of what can be typed: the less they listen for, the surer they are of what"
        "\nthey hear. It is sentences like the examples here, with other things, actions and words in their places, and"
        "\nthose of `grammars/heard.lark`. Vosk hears other sentences too, with any plain word, where they are clear."
        "\nOf each form's examples, they listen for:\n\n"
        f"{', '.join(counts)}.\n"
    )


def _table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    def lines() -> Iterator[str]:
        yield f"| {' | '.join(head)} |\n"
        yield "|" + "---|" * len(head) + "\n"
        for row in rows:
            yield f"| {' | '.join(row)} |\n"

    return "".join(lines())


if __name__ == "__main__":
    TARGET.write_text(page(), encoding="utf8")
