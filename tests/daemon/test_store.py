"""Whatever was acknowledged is there again, whatever happens; whatever is wrong with a file, it is told and kept."""

from __future__ import annotations

import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from daemon.schema import APPLICATION, SCHEMA_VERSION
from daemon.store import ADAPTATIONS_KEPT, NET_VERSION, UTTERANCES_KEPT, Store
from daemon.store_file import StoreError
from kernel.action.chain import Directive, sequence
from kernel.memory.change import Adapted, Change
from kernel.memory.lesson import Content, Lesson, Operator, Rule
from kernel.memory.notation import canonical, write
from kernel.memory.policy import Policy
from kernel.net.graphlet import Graphlet, Sketch, Term

WORDS = st.text("abcdefghijklmnopqrstuvwxyz-' äß", min_size=1, max_size=12).filter(
    lambda word: word == word.strip()
)


@st.composite
def graphlets(draw: st.DrawFn, kind: str = "act") -> Graphlet:
    sketch = Sketch()
    main = sketch.add(kind, draw(WORDS))
    others = [
        sketch.add(role, draw(WORDS), negated=draw(st.booleans()), **{role: main})
        for role in draw(st.lists(st.sampled_from(["dir", "mod", "hq"]), max_size=3, unique=True))
    ]
    if draw(st.booleans()):
        quote = st.text(min_size=1, max_size=30).filter(str.isprintable)
        text = sketch.add("txt", literal=draw(quote))
        sketch.link(main, "obj", text)
        others.append(text)
    return sketch.graphlet(main, *others)


@st.composite
def contents(draw: st.DrawFn) -> Content:
    first, second = draw(graphlets()), draw(graphlets())
    names = {name: f"{name}9" for name in second.names}  # two parts, two sets of names
    second = second.renamed(names)
    match draw(st.sampled_from(["fact", "rule", "operator"])):
        case "fact":
            return first
        case "rule":
            return Rule(first, second, belief=draw(st.sampled_from([1.0, 0.8, 0.5])))
    tag = draw(st.sampled_from(["DO", "NOTE", "ANTE", "POST"]))
    chain = sequence(Directive("DO", second), Directive("PUNT"))
    return Operator(Directive(tag, first), chain, preference=draw(st.sampled_from([0.8, 1.0, 1.2])))


lessons = st.builds(
    Lesson,
    ident=st.just(0),
    kind=st.sampled_from(["procedure", "rule", "fact", "prohibition"]),
    content=contents(),
    words=st.text(st.characters(codec="utf-8"), max_size=40),
    teacher=st.text(st.characters(codec="utf-8"), max_size=10),
    at_s=st.floats(0, 2e9),
)


def a_lesson(words: str = "to hop drive forward") -> Lesson:
    sketch = Sketch()
    hop = sketch.graphlet(sketch.add("act", "hop"))
    drive = sketch.add("act", "drive")
    way = sketch.add("dir", "forward", dir=drive)
    chain = sequence(Directive("DO", sketch.graphlet(drive, way)))
    return Lesson(0, "procedure", Operator(Directive("DO", hop), chain), words, "Mary", 1e9)


def keep(store: Store, *taught: Lesson) -> int:
    """Store lessons in one change; the number of the first."""
    return store.add(Change(by="Mary", learned=taught)).learned[0].ident


@given(st.lists(lessons, max_size=4))
@settings(max_examples=60, deadline=None)
def test_what_is_stored_comes_back(taught: list[Lesson]) -> None:
    store = Store.in_memory()
    numbers = [keep(store, lesson) for lesson in taught]
    loaded = store.load()
    assert not loaded.resting
    assert [lesson.ident for lesson in loaded.lessons] == numbers
    for before, after in zip(taught, loaded.lessons, strict=True):
        assert after.content == canonical(before.content)
        assert (after.kind, after.words, after.teacher, after.at_s) == (
            before.kind,
            before.words,
            before.teacher,
            before.at_s,
        )
    store.close()


def test_it_survives_closing_and_numbers_are_never_used_again(tmp_path: Path) -> None:
    path = tmp_path / "lessons.sqlite"
    store = Store.open(path)
    first = keep(store, a_lesson("one"))
    second = keep(store, a_lesson("two"))
    gone = store.add(Change(by="Mary", at_s=5.0, retracted=(second,)))
    store.close()
    store = Store.open(path)
    assert [lesson.words for lesson in store.load().lessons] == ["one"]
    assert keep(store, a_lesson("three")) not in (first, second)
    store.add(Change(by="Mary", undone=(gone.ident,)))
    assert [lesson.words for lesson in store.load().lessons] == ["one", "two", "three"]
    store.close()


def test_the_journal_comes_back_as_it_was() -> None:
    store = Store.in_memory()
    taught = store.add(
        Change(0, "Mary", "to hop", 1.0, (a_lesson("one"), a_lesson("two"))), "typed"
    )
    one, two = taught.learned
    revised = Change(0, "John", "no", 2.0, (a_lesson("three"),), (one.ident,))
    adapted = Change(0, adapted=(Adapted(two.ident, 1.0, 0.9),), own=True)
    changes = [taught, store.add(revised), store.add(adapted)]
    changes.append(store.add(Change(0, "Mary", "undo that", 3.0, undone=(changes[1].ident,))))
    loaded = store.load().changes
    assert [write(x.learned[0].content) for x in loaded[:2]] == [write(one.content)] * 2
    assert [replace_content(c) for c in loaded] == [replace_content(c) for c in changes]
    chunk = Lesson(0, "rule", a_lesson().content, origins=(one.ident, two.ident))
    keep(store, chunk)
    assert store.load().lessons[-1].origins == (one.ident, two.ident)
    store.close()


def replace_content(change: Change) -> Change:
    """Contents come back canonical; that is tested apart."""
    return replace(
        change, learned=tuple(replace(x, content=Rule(NIL, NIL)) for x in change.learned)
    )


NIL = Graphlet((), "x-1")


def test_a_change_is_stored_whole_or_not_at_all(tmp_path: Path) -> None:
    store = Store.open(tmp_path / "lessons.sqlite")
    with pytest.raises(sqlite3.Error):
        store.add(Change(learned=(a_lesson("one"),), retracted=(object(),)))  # type: ignore[arg-type]
    assert store.load().changes == ()
    keep(store, a_lesson("two"))
    assert [lesson.words for lesson in store.load().lessons] == ["two"]
    store.close()


def test_a_sentence_it_was_born_with_stays_forgotten() -> None:
    """It has a number, though no row."""
    store = Store.in_memory()
    store.add(Change(retracted=(-77,)))
    policy = Policy()
    policy.bear(Lesson(-77, "fact", Graphlet((Term("obj-1", frozenset(("mary",))),), "obj-1")))
    for change in store.load().changes:
        policy.apply(change)
    assert policy.lessons == {}


def test_own_adaptations_are_bounded_and_the_newest_counts() -> None:
    store = Store.in_memory()
    one, two = keep(store, a_lesson("one")), keep(store, a_lesson("two"))
    for number in range(3 * ADAPTATIONS_KEPT):
        for lesson in (one, two):
            moved = Adapted(lesson, 1.0, 1 - number / 1000)
            store.add(Change(adapted=(moved,), own=True))
    loaded = store.load()
    assert len(loaded.changes) == 2 + 2 * ADAPTATIONS_KEPT
    policy = Policy()
    for change in loaded.changes:
        policy.apply(change)
    assert policy.strength(policy.lessons[two]) == 1 - (3 * ADAPTATIONS_KEPT - 1) / 1000
    store.close()


SCHEMA_1 = f"""
CREATE TABLE lesson (ident INTEGER PRIMARY KEY AUTOINCREMENT, kind TEXT NOT NULL, notation TEXT NOT NULL,
    net_version INTEGER NOT NULL, words TEXT NOT NULL, teacher TEXT NOT NULL, at_s REAL NOT NULL,
    source TEXT NOT NULL) STRICT;
CREATE TABLE retraction (ident INTEGER PRIMARY KEY AUTOINCREMENT, lesson INTEGER NOT NULL REFERENCES lesson,
    at_s REAL NOT NULL, by TEXT NOT NULL, undone INTEGER NOT NULL DEFAULT 0) STRICT;
CREATE TABLE utterance (ident INTEGER PRIMARY KEY AUTOINCREMENT, at_s REAL NOT NULL, text TEXT NOT NULL,
    speaker TEXT NOT NULL, source TEXT NOT NULL, kind TEXT NOT NULL) STRICT;
PRAGMA application_id = {APPLICATION};
PRAGMA user_version = 1;
"""


def test_a_file_of_the_first_schema_is_brought_up_to_date(tmp_path: Path) -> None:
    path = tmp_path / "lessons.sqlite"
    with sqlite3.connect(path) as db:
        db.executescript(SCHEMA_1)
        notation = write(a_lesson().content)
        for words in ("kept", "forgotten", "restored", "deleted"):
            db.execute(
                "INSERT INTO lesson (kind, notation, net_version, words, teacher, at_s, source)"
                " VALUES ('procedure', ?, 1, ?, 'Mary', 7.0, 'typed')",
                (notation, words),
            )
        db.execute("DELETE FROM lesson WHERE words = 'deleted'")
        db.execute("INSERT INTO retraction (lesson, at_s, by, undone) VALUES (3, 8.0, 'John', 1)")
        db.execute("INSERT INTO retraction (lesson, at_s, by, undone) VALUES (2, 9.0, 'John', 0)")
    db.close()
    for _ in range(2):
        store = Store.open(path)
        loaded = store.load()
        assert [(x.ident, x.words, x.teacher) for x in loaded.lessons] == [
            (1, "kept", "Mary"),
            (3, "restored", "Mary"),
        ]
        last = loaded.changes[-1]
        assert (last.by, last.at_s, last.retracted) == ("John", 9.0, (2,))
        store.close()
    store = Store.open(path)
    assert keep(store, a_lesson("new")) == 5  # the number of a deleted lesson is not used again
    store.close()


def test_a_second_daemon_is_refused_and_the_first_goes_on(tmp_path: Path) -> None:
    path = tmp_path / "lessons.sqlite"
    store = Store.open(path)
    with pytest.raises(StoreError, match=r"in use by another sayso \(process [0-9]+\)"):
        Store.open(path)
    keep(store, a_lesson())
    store.close()
    Store.open(path).close()


KILLED = """
import sys
from pathlib import Path
from daemon.store import Store
sys.path.insert(0, sys.argv[2])
from test_store import a_lesson, keep
store = Store.open(Path(sys.argv[1]))
while True:
    print(keep(store, a_lesson()), flush=True)
"""


@pytest.mark.parametrize("after", [1, 7, 40])
def test_kill_9_loses_nothing_acknowledged(tmp_path: Path, after: int) -> None:
    path = tmp_path / "lessons.sqlite"
    arguments = [sys.executable, "-c", KILLED, str(path), str(Path(__file__).parent)]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True) as writer:
        assert writer.stdout is not None
        told = [int(writer.stdout.readline()) for _ in range(after)]
        writer.send_signal(signal.SIGKILL)
        told += [int(line) for line in writer.stdout if line.endswith("\n")]
    store = Store.open(path)
    kept = [lesson.ident for lesson in store.load().lessons]
    store.close()
    assert kept[: len(told)] == told


def _damaged_text(path: Path) -> None:
    path.write_bytes(b"my shopping list\n" * 400)


def _damaged_few_bytes(path: Path) -> None:
    path.write_bytes(b"hello")


def _damaged_page(path: Path) -> None:
    store = Store.open(path)
    for _ in range(200):
        keep(store, a_lesson("x" * 100))
    store.close()
    data = bytearray(path.read_bytes())
    for at in range(4096, len(data), 4096):
        data[at : at + 64] = b"\xff" * 64
    path.write_bytes(data)


def _newer(path: Path) -> None:
    Store.open(path).close()
    with sqlite3.connect(path) as db:
        db.execute(f"PRAGMA user_version = {SCHEMA_VERSION + 1}")
    db.close()


def _foreign(path: Path) -> None:
    with sqlite3.connect(path) as db:
        db.execute("CREATE TABLE bookmarks (url TEXT)")
    db.close()


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (_damaged_text, "damaged"),
        (_damaged_few_bytes, "damaged"),
        (_damaged_page, "damaged"),
        (_newer, "newer"),
        (_foreign, "not a store"),
    ],
)
def test_a_file_that_cannot_be_used_is_refused_and_kept(
    tmp_path: Path, spoil: object, said: str
) -> None:
    path = tmp_path / "lessons.sqlite"
    spoil(path)  # type: ignore[operator]
    before = path.read_bytes()
    for _ in range(2):
        with pytest.raises(StoreError, match=said) as caught:
            Store.open(path)
        assert str(path) in str(caught.value)
    assert path.read_bytes() == before


def test_a_state_directory_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match="cannot be opened"):
        Store.open(tmp_path / "file" / "lessons.sqlite")


def test_lessons_that_cannot_be_read_rest_and_stay(tmp_path: Path) -> None:
    path = tmp_path / "lessons.sqlite"
    store = Store.open(path)
    for words in ("good", "broken", "too new", "of no kind"):
        keep(store, a_lesson(words))
    store.close()
    with sqlite3.connect(path) as db:
        db.execute("UPDATE lesson SET notation = 'act-1 -lex-' WHERE words = 'broken'")
        db.execute("UPDATE lesson SET net_version = ? WHERE words = 'too new'", (NET_VERSION + 1,))
        db.execute("UPDATE lesson SET kind = 'poem' WHERE words = 'of no kind'")
    db.close()
    for _ in range(2):
        store = Store.open(path)
        loaded = store.load()
        store.close()
        assert [lesson.words for lesson in loaded.lessons] == ["good"]
        assert [lesson.words for lesson in loaded.resting] == ["broken", "too new", "of no kind"]
        assert all(lesson.why for lesson in loaded.resting)


def test_a_lesson_that_calls_an_ability_the_body_lacks_rests() -> None:
    store = Store.in_memory()
    sketch = Sketch()
    trigger = Directive("DO", sketch.graphlet(sketch.add("act", "fly")))
    call = Directive("FCN", sketch.graphlet(sketch.add("fcn", "rotor_lift")))
    keep(store, Lesson(0, "procedure", Operator(trigger, sequence(call)), "to fly"))
    assert store.load().lessons
    (resting,) = store.load(frozenset({"base_drive"})).resting
    assert "rotor_lift" in resting.why
    store.close()


def test_the_utterance_log_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("daemon.store.UTTERANCES_KEPT", 5)
    assert UTTERANCES_KEPT > 5
    store = Store.in_memory()
    for number in range(12):
        store.log(float(number), f"utterance {number}", "", "typed", "command")
    assert [text for _, text, *_ in store.utterances(100)] == [
        f"utterance {number}" for number in range(7, 12)
    ]
    store.close()


def test_an_old_copy_opens_beside_its_write_ahead_log(tmp_path: Path) -> None:
    """What kill -9 leaves behind is file and log; both copied elsewhere are the same lessons."""
    path = tmp_path / "lessons.sqlite"
    store = Store.open(path)
    keep(store, a_lesson("durable"))
    with tempfile.TemporaryDirectory() as other:
        for file in tmp_path.glob("lessons.sqlite*"):
            shutil.copy(file, other)
        copy = Store.open(Path(other) / "lessons.sqlite")
        assert [lesson.words for lesson in copy.load().lessons] == ["durable"]
        copy.close()
    store.close()
