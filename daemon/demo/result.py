"""What a line of the demonstration came to: what was heard, and whether it went as expected."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from rich.box import SIMPLE_HEAD
from rich.table import Table
from rich.text import Text

from daemon import events as ev
from daemon.acts import Act
from daemon.dialogue import You
from daemon.judgement import Outcome, Turn, judge, words_of
from daemon.understanding import understand
from grammars.vocabulary import Vocabulary
from kernel.memory.meaning import Utterance


@dataclass(frozen=True, slots=True)
class Result:
    """Attributes:
    act: the line and what was expected of it.
    text: the line as it stands in the script.
    heard: what was heard, "" for nothing and for lines that are not spoken.
    misheard: what was heard does not mean what was said.
    outcomes: one for each `robot:` line.
    """

    act: Act
    text: str
    heard: str
    misheard: bool
    outcomes: tuple[Outcome, ...]

    @property
    def ok(self) -> bool:
        """Heard right, and everything went as expected."""
        return not self.misheard and all(outcome.ok for outcome in self.outcomes)


def result(act: Act, text: str, turn: Turn, vocabulary: Vocabulary) -> Result:
    """Judge a line of the demonstration by its turn.

    Args:
        act: the line.
        text: the line as it stands in the script.
        turn: what happened.
        vocabulary: the words known when the line was spoken.
    """
    heard = " / ".join(event.text for event in turn.events if isinstance(event, ev.Heard))
    misheard = isinstance(act.step, You) and not same(act.step.text, heard, vocabulary)
    outcomes = judge([line.expectation for line in act.expected], turn)
    return Result(act, text, heard, misheard, outcomes)


def same(said: str, heard: str, vocabulary: Vocabulary) -> bool:
    """The same words, or other words for the same meaning ("drive backward", "drive backwards")."""
    if words_of(said) == words_of(heard):
        return True
    meant, understood = (understand(Utterance(text), vocabulary) for text in (said, heard))
    return meant.heard is not None and (meant.kind, meant.readback) == (
        understood.kind,
        understood.readback,
    )


def table(results: Iterable[Result]) -> Table:
    """Expected and actual outcome of every line."""
    rows = Table(box=SIMPLE_HEAD, expand=True)
    rows.add_column("", width=4)
    rows.add_column("line", ratio=4)
    rows.add_column("expected", ratio=5)
    rows.add_column("actual", ratio=5)
    for found in results:
        expected = "; ".join(outcome.expectation.text for outcome in found.outcomes)
        actual = "; ".join(found.outcomes[0].actual) if found.outcomes else ""
        if found.misheard:
            actual = (
                f'heard "{found.heard}"; {actual}' if found.heard else f"nothing heard; {actual}"
            )
        verdict = Text("ok", "green") if found.ok else Text("FAIL", "bold red")
        rows.add_row(
            verdict, found.text, expected, actual or "nothing", style="" if found.ok else "red"
        )
    return rows
