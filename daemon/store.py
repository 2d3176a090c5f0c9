"""Lessons that survive: one SQLite file, one daemon, one writer.

The notation is the lesson, the words are evidence. Rows carry the version of the net they were written in; a lesson
that cannot be read any more is kept, rests and is reported. A lesson counts as learned only once it is durable
(WAL, synchronous=FULL).
"""

from __future__ import annotations

import fcntl
import os
import sqlite3
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final, cast, get_args

from kernel.errors import NotationError
from kernel.memory.lesson import Lesson, LessonKind
from kernel.memory.notation import read, write

APPLICATION: Final = 0x53415953  # "SAYS" in the file's header: whose file it is
SCHEMA_VERSION: Final = 1
NET_VERSION: Final = 1
UTTERANCES_KEPT: Final = 10_000
NET_MIGRATIONS: Final[Mapping[int, Callable[[str], str]]] = {}  # notation of version n to n + 1

SCHEMA: Final = f"""
CREATE TABLE lesson (
    ident INTEGER PRIMARY KEY AUTOINCREMENT,
    kind TEXT NOT NULL,
    notation TEXT NOT NULL,
    net_version INTEGER NOT NULL,
    words TEXT NOT NULL,
    teacher TEXT NOT NULL,
    at_s REAL NOT NULL,
    source TEXT NOT NULL
) STRICT;
CREATE TABLE retraction (
    ident INTEGER PRIMARY KEY AUTOINCREMENT,
    lesson INTEGER NOT NULL REFERENCES lesson,
    at_s REAL NOT NULL,
    by TEXT NOT NULL,
    undone INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE TABLE utterance (
    ident INTEGER PRIMARY KEY AUTOINCREMENT,
    at_s REAL NOT NULL,
    text TEXT NOT NULL,
    speaker TEXT NOT NULL,
    source TEXT NOT NULL,
    kind TEXT NOT NULL
) STRICT;
PRAGMA application_id = {APPLICATION};
PRAGMA user_version = {SCHEMA_VERSION};
"""


class StoreError(Exception):
    """The store cannot be used; the message is for a person, and the file was left as it is."""

    def __init__(self, path: Path | str, why: str) -> None:
        super().__init__(f"{path}: {why}")
        self.path, self.why = path, why


@dataclass(frozen=True, slots=True)
class Resting:
    """A lesson that is kept but not in force. why: what is wrong with it."""

    ident: int
    words: str
    why: str


@dataclass(frozen=True, slots=True)
class Loaded:
    """Lessons in force, oldest first, and those that rest."""

    lessons: tuple[Lesson, ...]
    resting: tuple[Resting, ...] = ()


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
        lock = _locked(path)
        try:
            return cls(_connected(path), lock)
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
        """Read every lesson that was not retracted.

        Args:
            abilities: grounding functions of the body; a lesson that calls another one rests. None: do not look.
        """
        rows = self._db.execute(
            "SELECT ident, kind, notation, net_version, words, teacher, at_s FROM lesson WHERE ident NOT IN"
            " (SELECT lesson FROM retraction WHERE NOT undone) ORDER BY ident"
        )
        lessons, resting = [], []
        for ident, kind, notation, version, words, teacher, at_s in rows:
            try:
                content = read(_migrated(notation, version))
                _check(kind, content, abilities)
            except (NotationError, ValueError) as error:
                resting.append(Resting(ident, words, str(error)))
                continue
            lessons.append(Lesson(ident, cast(LessonKind, kind), content, words, teacher, at_s))
        return Loaded(tuple(lessons), tuple(resting))

    def add(self, lesson: Lesson, source: str = "") -> int:
        """Make a lesson durable; its number."""
        cursor = self._db.execute(
            "INSERT INTO lesson (kind, notation, net_version, words, teacher, at_s, source)"
            " VALUES (?, ?, ?, ?, ?, ?, ?)",
            (
                lesson.kind,
                write(lesson.content),
                NET_VERSION,
                lesson.words,
                lesson.teacher,
                lesson.at_s,
                source,
            ),
        )
        assert cursor.lastrowid is not None
        return cursor.lastrowid

    def retract(self, ident: int, by: str, at_s: float) -> None:
        """Take a lesson out of force; the row stays."""
        self._db.execute(
            "INSERT INTO retraction (lesson, at_s, by) VALUES (?, ?, ?)", (ident, at_s, by)
        )

    def restore(self, ident: int) -> None:
        """Undo every retraction of a lesson."""
        self._db.execute("UPDATE retraction SET undone = 1 WHERE lesson = ?", (ident,))

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


def _locked(path: Path) -> int:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        lock = os.open(path.with_suffix(".lock"), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    except OSError as error:
        raise StoreError(path, f"cannot be opened ({error.strerror})") from error
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        owner = os.read(lock, 20).decode(errors="replace").strip()
        os.close(lock)
        why = f"in use by another sayso (process {owner or 'unknown'})"
        raise StoreError(path, f"{why}; stop it, or set SAYSO_STATE_DIR") from error
    os.truncate(lock, 0)
    os.write(lock, f"{os.getpid()}\n".encode())
    return lock


def _connected(path: Path) -> sqlite3.Connection:
    _check_header(path)
    db = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
    try:
        db.execute("PRAGMA synchronous = FULL")
        (application,) = db.execute("PRAGMA application_id").fetchone()
        (version,) = db.execute("PRAGMA user_version").fetchone()
        (tables,) = db.execute("SELECT count(*) FROM sqlite_schema").fetchone()
        if tables and application != APPLICATION:
            raise StoreError(path, "not a store of Sayso; it was not touched")
        if version > SCHEMA_VERSION:
            newer = f"written by a newer Sayso (schema {version}, this one knows {SCHEMA_VERSION})"
            raise StoreError(path, f"{newer}; it was kept as it is")
        (verdict,) = db.execute("PRAGMA quick_check(1)").fetchone()
        if verdict != "ok":
            raise sqlite3.DatabaseError(verdict)
        db.execute("PRAGMA journal_mode = WAL")
        if not tables:
            db.executescript(f"BEGIN IMMEDIATE; {SCHEMA} COMMIT;")
    except BaseException:
        db.close()
        raise
    return db


def _check_header(path: Path) -> None:
    """SQLite itself takes a file of a few bytes for an empty one and would write over it."""
    try:
        with path.open("rb") as file:
            start = file.read(16)
    except FileNotFoundError:
        return
    except OSError as error:
        raise StoreError(path, f"cannot be read ({error.strerror})") from error
    if start and start != b"SQLite format 3\0":
        raise sqlite3.DatabaseError("not a database file")


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
