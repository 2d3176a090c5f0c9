"""The tables of the store, and how a file of an older schema becomes one of this."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

APPLICATION: Final = 0x53415953  # "SAYS" in the file's header: whose file it is
SCHEMA_VERSION: Final = 2

_CHANGES: Final = """
CREATE TABLE change (
    ident INTEGER PRIMARY KEY AUTOINCREMENT,
    at_s REAL NOT NULL,
    by TEXT NOT NULL,
    words TEXT NOT NULL,
    own INTEGER NOT NULL,
    source TEXT NOT NULL
) STRICT;
CREATE TABLE retraction (
    change INTEGER NOT NULL REFERENCES change,
    lesson INTEGER NOT NULL REFERENCES lesson
) STRICT;
CREATE TABLE adaptation (
    change INTEGER NOT NULL REFERENCES change,
    lesson INTEGER NOT NULL REFERENCES lesson,
    before REAL NOT NULL,
    after REAL NOT NULL
) STRICT;
CREATE TABLE undoing (
    change INTEGER NOT NULL REFERENCES change,
    undone INTEGER NOT NULL REFERENCES change
) STRICT;
CREATE INDEX retraction_change ON retraction (change);
CREATE INDEX adaptation_change ON adaptation (change);
CREATE INDEX adaptation_lesson ON adaptation (lesson);
CREATE INDEX undoing_change ON undoing (change);
"""
_LESSON: Final = """
CREATE TABLE lesson (
    ident INTEGER PRIMARY KEY AUTOINCREMENT,
    kind TEXT NOT NULL,
    notation TEXT NOT NULL,
    net_version INTEGER NOT NULL,
    words TEXT NOT NULL,
    teacher TEXT NOT NULL,
    at_s REAL NOT NULL,
    origins TEXT NOT NULL DEFAULT '',
    change INTEGER NOT NULL REFERENCES change
) STRICT;
CREATE INDEX lesson_change ON lesson (change);
"""
_UTTERANCE: Final = """
CREATE TABLE utterance (
    ident INTEGER PRIMARY KEY AUTOINCREMENT,
    at_s REAL NOT NULL,
    text TEXT NOT NULL,
    speaker TEXT NOT NULL,
    source TEXT NOT NULL,
    kind TEXT NOT NULL
) STRICT;
"""
SCHEMA: Final = f"""
{_CHANGES}{_LESSON}{_UTTERANCE}
PRAGMA application_id = {APPLICATION};
PRAGMA user_version = {SCHEMA_VERSION};
"""

# Version 1 had no journal: each lesson becomes a change of its own number, each retraction in force a later one.
_FROM_1: Final = f"""
ALTER TABLE retraction RENAME TO old_retraction;
ALTER TABLE lesson RENAME TO old_lesson;
{_CHANGES}{_LESSON}
INSERT INTO change SELECT ident, at_s, teacher, words, 0, source FROM old_lesson;
INSERT INTO lesson SELECT ident, kind, notation, net_version, words, teacher, at_s, '', ident FROM old_lesson;
INSERT INTO change (at_s, by, words, own, source) SELECT at_s, by, 'old ' || ident, 0, '' FROM old_retraction
    WHERE NOT undone ORDER BY ident;
INSERT INTO retraction SELECT change.ident, old_retraction.lesson FROM old_retraction
    JOIN change ON change.words = 'old ' || old_retraction.ident AND change.ident NOT IN (SELECT ident FROM old_lesson);
UPDATE change SET words = '' WHERE ident IN (SELECT change FROM retraction);
DELETE FROM sqlite_sequence WHERE name = 'lesson';
INSERT INTO sqlite_sequence SELECT 'lesson', seq FROM sqlite_sequence WHERE name = 'old_lesson';
DROP TABLE old_retraction;
DROP TABLE old_lesson;
PRAGMA user_version = 2;
"""
MIGRATIONS: Final[Mapping[int, str]] = {1: _FROM_1}  # script from version n to n + 1
