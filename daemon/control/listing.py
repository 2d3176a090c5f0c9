"""`sayso lessons`: rows as a table or as JSON."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

from daemon.lessonfile import plain, when
from daemon.lessons import Row

WIDE = 160
"""Columns where the output is no terminal."""


def choose(rows: Sequence[Row], text: str, *, everything: bool) -> list[Row]:
    """Those that count, or all of them, in which every word of the text occurs."""
    wanted = text.casefold().split()
    return [
        row
        for row in rows
        if (everything or row.counts)
        and all(
            word in f"{row.text} {row.words} {row.kind} {row.teacher}".casefold() for word in wanted
        )
    ]


def as_json(rows: Sequence[Row], **more: str) -> None:
    """One object a line."""
    for row in rows:
        click.echo(json.dumps(_object(row) | more, ensure_ascii=False))


def _object(row: Row) -> dict[str, object]:
    return {
        "number": row.ident,
        "kind": row.kind,
        "text": row.text,
        "words": row.words,
        "teacher": row.teacher,
        "at_s": row.at_s,
        "made_of": list(row.origins),
        "taught_strength": row.taught,
        "strength": row.strength,
        "standing": row.standing,
        "why": row.why,
        "notation": row.notation.splitlines(),
    }


def show(
    rows: Sequence[Row],
    chosen: Sequence[Row],
    *,
    everything: bool,
    filtered: bool,
    bare: bool = False,
) -> None:
    """A table, and what is not in it. bare: without bold type."""
    if chosen:
        console(bare=bare).print(_table(chosen, everything=everything))
    elif filtered:
        click.echo("no lesson has these words")
    elif rows:
        click.echo("no lesson is in force")
    else:
        click.echo('nothing was taught (try: sayso say "to dance, turn around twice")')
    hidden = {s: sum(row.standing == s for row in rows) for s in ("taken back", "rests")}
    if not everything and (told := _hidden(hidden["taken back"], hidden["rests"])):
        click.echo(f"{told} (sayso lessons --all)", err=True)


def _hidden(gone: int, resting: int) -> str:
    told = [f"{gone} taken back"] if gone else []
    if resting:
        told.append(f"{resting} lesson{' rests' if resting == 1 else 's rest'}")
    return ", ".join(told)


def _table(rows: Sequence[Row], *, everything: bool) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for heading in ("no.", "kind", "lesson", "taught by", "when"):
        table.add_column(heading, justify="right" if heading == "no." else "left", overflow="fold")
    moved = any(row.strength != row.taught for row in rows)
    for heading, wanted in (("strength", moved), ("", everything)):
        if wanted:
            table.add_column(heading)
    for row in rows:
        cells = [str(row.ident), row.kind, row.text, _teacher(row), when(row.at_s)]
        cells += [_strength(row)] if moved else []
        cells += [_standing(row)] if everything else []
        table.add_row(*(Text(plain(cell)) for cell in cells), style=None if row.counts else "dim")
    return table


def _teacher(row: Row) -> str:
    if row.origins:
        return f"itself, from {', '.join(map(str, row.origins))}"
    return row.teacher.title() or "-"


def _strength(row: Row) -> str:
    return "" if row.strength == row.taught else f"{row.strength:.2f} (taught {row.taught:.2f})"


def _standing(row: Row) -> str:
    return f"{row.standing}: {row.why}" if row.standing == "rests" else row.standing


def show_changed(rows: Sequence[Row], chosen: Sequence[Row], *, as_json: bool) -> None:
    """Lessons whose words would teach something else today; they stay as they are."""
    from daemon.teaching import changed

    wanted = {row.ident for row in chosen}
    found = [(row, now) for row, now in changed(rows) if row.ident in wanted]
    if as_json:
        for row, now in found:
            click.echo(json.dumps(_object(row) | {"now": now}, ensure_ascii=False))
        return
    if not found:
        click.echo("the words of every lesson mean what they meant")
        return
    table = Table(box=None, pad_edge=False, header_style="bold")
    for heading in ("no.", "lesson", "words", "the words now"):
        table.add_column(heading, justify="right" if heading == "no." else "left", overflow="fold")
    for row, now in found:
        table.add_row(*map(Text, (str(row.ident), row.text, row.words, now)))
    console().print(table)
    click.echo(
        "the lessons stay as they are; to change one: sayso forget N, then teach it again", err=True
    )


def console(*, bare: bool = False) -> Console:
    """For tables: as wide as the terminal, and wide where there is none."""
    terminal = sys.stdout.isatty()
    styled = False if bare else None
    return Console(highlight=False, width=None if terminal else WIDE, force_terminal=styled)
