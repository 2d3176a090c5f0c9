"""Opening the store's file: locked, checked, of this schema; whatever is wrong with it, it is kept as it is."""

from __future__ import annotations

import fcntl
import os
import sqlite3
from pathlib import Path

from daemon.schema import APPLICATION, MIGRATIONS, SCHEMA, SCHEMA_VERSION


class StoreError(Exception):
    """The store cannot be used; the message is for a person, and the file was left as it is."""

    def __init__(self, path: Path | str, why: str) -> None:
        super().__init__(f"{path}: {why}")
        self.path, self.why = path, why


def locked(path: Path) -> int:
    """Lock the store of that path against other daemons; the descriptor that holds the lock.

    Raises:
        StoreError: another daemon has it, or no right.
    """
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


def connected(path: Path) -> sqlite3.Connection:
    """Open or create the file, of this schema; an older one is brought up to it.

    Raises:
        StoreError: of a newer version, or not a store.
        sqlite3.Error: damaged.
    """
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
        for step in range(version, SCHEMA_VERSION) if tables else ():
            db.executescript(f"BEGIN IMMEDIATE; {MIGRATIONS[step]} COMMIT;")
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
