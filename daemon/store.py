"""Lessons that survive: one SQLite file, one daemon, one writer.

The notation is the lesson, the words are evidence. Rows carry the version of the net they were written in; a lesson
that cannot be read any more is kept, rests and is reported. A lesson counts as learned only once it is durable
(WAL, synchronous=FULL).
"""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final, cast, get_args

from daemon.schema import SCHEMA
from daemon.store_file import StoreError, connected, locked
from kernel.errors import NotationError
from kernel.memory.change import Adapted, Change
from kernel.memory.lesson import Lesson, LessonKind, Resting
from kernel.memory.notation import read, write
from kernel.memory.policy import Policy

NET_VERSION: Final = 1
UTTERANCES_KEPT: Final = 10_000
ADAPTATIONS_KEPT: Final = 20  # of one lesson; the older ones explain nothing any more
NET_MIGRATIONS: Final[Mapping[int, Callable[[str], str]]] = {}  # notation of version n to n + 1


@dataclass(frozen=True, slots=True)
class Loaded:
    """The journal, oldest change first, without lessons that rest; and these."""

    changes: tuple[Change, ...]
    resting: tuple[Resting, ...] = ()

    @property
    def lessons(self) -> tuple[Lesson, ...]:
        """Lessons in force, oldest first."""
        policy = Policy()
        for change in self.changes:
            policy.apply(change)
        return tuple(sorted(policy.lessons.values(), key=lambda lesson: lesson.ident))


class Store:
    """The open store. Use from one thread at a time; `daemon/writer.py` gives it a thread of its own."""

    def __init__(self, connection: sqlite3.Connection, lock: int | None) -> None:
        self._db, self._lock = connection, lock

    @classmethod
    def open(cls, path: Path) -> Store:
        """Open or create the file and lock it against other daemons.

        Raises:
            StoreError: another daemon has it; it is damaged, from a newer version, or not a store; no room or right.
        """
        lock = locked(path)
        try:
            return cls(connected(path), lock)
        except sqlite3.Error as error:
            os.close(lock)
            kept = "the file was kept; move it away to begin with an empty store"
            raise StoreError(path, f"damaged ({error}); {kept}") from error
        except StoreError:
            os.close(lock)
            raise

    @classmethod
    def in_memory(cls) -> Store:
        """A store that lives as long as the object (rehearsals)."""
        db = sqlite3.connect(":memory:", check_same_thread=False, isolation_level=None)
        db.executescript(SCHEMA)
        return cls(db, None)

    def load(self, abilities: frozenset[str] | None = None) -> Loaded:
        """Read the whole journal.

        Args:
            abilities: grounding functions of the body; a lesson that calls another one rests. None: do not look.
        """
        learned, resting = self._lessons(abilities)
        retracted = self._by_change("SELECT change, lesson FROM retraction")
        undone = self._by_change("SELECT change, undone FROM undoing")
        adapted: dict[int, list[Adapted]] = {}
        for change, *moved in self._db.execute(
            "SELECT change, lesson, before, after FROM adaptation"
        ):
            adapted.setdefault(change, []).append(Adapted(*moved))
        changes = tuple(
            Change(
                ident,
                by,
                words,
                at_s,
                tuple(learned.get(ident, ())),
                tuple(retracted.get(ident, ())),
                tuple(adapted.get(ident, ())),
                tuple(undone.get(ident, ())),
                bool(own),
            )
            for ident, by, words, at_s, own in self._db.execute(
                "SELECT ident, by, words, at_s, own FROM change ORDER BY ident"
            )
        )
        return Loaded(changes, tuple(resting))

    def _lessons(
        self, abilities: frozenset[str] | None
    ) -> tuple[dict[int, list[Lesson]], list[Resting]]:
        """Lessons by the change that taught them, and those that rest, with their reasons if they are in force."""
        learned: dict[int, list[Lesson]] = {}
        resting = []
        rows = self._db.execute(
            "SELECT ident, kind, notation, net_version, words, teacher, at_s, origins, change"
            " FROM lesson ORDER BY ident"
        )
        for ident, kind, notation, version, words, teacher, at_s, origins, change in rows:
            try:
                content = read(_migrated(notation, version))
                _check(kind, content, abilities)
            except (NotationError, ValueError) as error:
                resting.append(Resting(ident, words, str(error), kind, teacher, at_s, change))
                continue
            made_of = tuple(map(int, origins.split()))
            lesson = Lesson(ident, cast(LessonKind, kind), content, words, teacher, at_s, made_of)
            learned.setdefault(change, []).append(lesson)
        return learned, resting

    def _by_change(self, query: str) -> dict[int, list[int]]:
        found: dict[int, list[int]] = {}
        for change, other in self._db.execute(query):
            found.setdefault(change, []).append(other)
        return found

    def add(self, change: Change, source: str = "") -> Change:
        """Make a change durable, all of it or nothing; the same with the numbers it and its lessons now have."""
        with self._transaction():
            cursor = self._db.execute(
                "INSERT INTO change (at_s, by, words, own, source) VALUES (?, ?, ?, ?, ?)",
                (change.at_s, change.by, change.words, change.own, source),
            )
            ident = cursor.lastrowid
            assert ident is not None
            learned = tuple(self._add_lesson(lesson, ident) for lesson in change.learned)
            self._db.executemany(
                "INSERT INTO retraction VALUES (?, ?)", [(ident, n) for n in change.retracted]
            )
            self._db.executemany(
                "INSERT INTO undoing VALUES (?, ?)", [(ident, n) for n in change.undone]
            )
            for adapted in change.adapted:
                self._adapt(ident, adapted)
            if change.adapted:
                self._tidy()
        return replace(change, ident=ident, learned=learned)

    def _add_lesson(self, lesson: Lesson, change: int) -> Lesson:
        cursor = self._db.execute(
            "INSERT INTO lesson (kind, notation, net_version, words, teacher, at_s, origins, change)"
            " VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
            (
                lesson.kind,
                write(lesson.content),
                NET_VERSION,
                lesson.words,
                lesson.teacher,
                lesson.at_s,
                " ".join(map(str, lesson.origins)),
                change,
            ),
        )
        assert cursor.lastrowid is not None
        return replace(lesson, ident=cursor.lastrowid)

    def _adapt(self, change: int, adapted: Adapted) -> None:
        """Note it; of the robot's own adaptations of a lesson only the last few are kept."""
        self._db.execute(
            "INSERT INTO adaptation VALUES (?, ?, ?, ?)",
            (change, adapted.lesson, adapted.before, adapted.after),
        )
        self._db.execute(
            "DELETE FROM adaptation WHERE lesson = ? AND change IN (SELECT adaptation.change FROM adaptation"
            " JOIN change ON change.ident = adaptation.change WHERE lesson = ? AND own"
            " ORDER BY adaptation.change DESC LIMIT -1 OFFSET ?)",
            (adapted.lesson, adapted.lesson, ADAPTATIONS_KEPT),
        )

    def _tidy(self) -> None:
        """Forget changes of the robot's own of which nothing is left."""
        self._db.execute(
            "DELETE FROM change WHERE own AND ident NOT IN (SELECT change FROM adaptation)"
            " AND ident NOT IN (SELECT change FROM lesson) AND ident NOT IN (SELECT undone FROM undoing)"
            " AND ident NOT IN (SELECT change FROM undoing) AND ident NOT IN (SELECT change FROM retraction)"
        )

    @contextmanager
    def _transaction(self) -> Iterator[None]:
        self._db.execute("BEGIN IMMEDIATE")
        try:
            yield
        except BaseException:
            self._db.execute("ROLLBACK")
            raise
        self._db.execute("COMMIT")

    def log(self, at_s: float, text: str, speaker: str, source: str, kind: str) -> None:
        """Note an utterance; the oldest are dropped beyond the bound."""
        self._db.execute(
            "INSERT INTO utterance (at_s, text, speaker, source, kind) VALUES (?, ?, ?, ?, ?)",
            (at_s, text, speaker, source, kind),
        )
        self._db.execute(
            "DELETE FROM utterance WHERE ident <= (SELECT max(ident) FROM utterance) - ?",
            (UTTERANCES_KEPT,),
        )

    def utterances(self, last: int = 20) -> list[tuple[float, str, str, str, str]]:
        """The last ones, oldest first: time, text, speaker, source, kind."""
        rows = self._db.execute(
            "SELECT at_s, text, speaker, source, kind FROM utterance ORDER BY ident DESC LIMIT ?",
            (last,),
        ).fetchall()
        return rows[::-1]

    def close(self) -> None:
        """Close the file and give up the lock."""
        self._db.close()
        if self._lock is not None:
            os.close(self._lock)
            self._lock = None


def _migrated(notation: str, version: int) -> str:
    if version > NET_VERSION:
        raise ValueError(f"net version {version} is newer than {NET_VERSION}")
    for step in range(version, NET_VERSION):
        notation = NET_MIGRATIONS[step](notation)
    return notation


def _check(kind: str, content: object, abilities: frozenset[str] | None) -> None:
    if kind not in get_args(LessonKind):
        raise ValueError(f"unknown kind of lesson {kind!r}")
    chain = getattr(content, "chain", None)
    if abilities is None or chain is None:
        return
    for directive in chain.directives():
        if directive.tag == "FCN" and not directive.graphlet.words() <= abilities:
            lacking = ", ".join(sorted(directive.graphlet.words() - abilities))
            raise ValueError(f"the body lacks {lacking}")
