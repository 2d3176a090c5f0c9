"""Lessons written as English and learned again: the policy is the same, whatever was taught."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from daemon.lessonfile import Line, NotTextError, read_lines, written
from daemon.lessons import Row, rows
from daemon.teaching import Plan, changed, lessons_of, plan
from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from kernel.memory.change import Adapted, Change
from kernel.memory.lesson import Lesson, Resting
from kernel.memory.meaning import Fact, Meaning
from kernel.memory.notation import write
from tests.grammars import nets

LISTS = Path(__file__).parents[1] / "grammars"


def policy(lessons: Iterable[Lesson]) -> Counter[tuple[str, str]]:
    """What is in force, identity, time and adaptation aside."""
    return Counter((lesson.kind, write(lesson.content)) for lesson in lessons)


def teaching(number: int, lesson: Lesson, teacher: str = "") -> Change:
    """The change that teaches it, one a minute."""
    at_s = 60.0 * number
    taught = Lesson(number, lesson.kind, lesson.content, lesson.words, teacher, at_s)
    return Change(number, teacher, lesson.words, at_s, (taught,))


def stored(lessons: Sequence[Lesson], teacher: str = "") -> tuple[Row, ...]:
    """The rows of a store that was taught these, one after another."""
    return rows([teaching(n, lesson, teacher) for n, lesson in enumerate(lessons, start=1)])


def text_of(table: Iterable[Row], *kinds: str) -> str:
    return "".join(f"{line}\n" for line in written(table, kinds))


def planned(text: str, table: Iterable[Row] = ()) -> Plan:
    return plan(read_lines(text.encode()), table)


def learned(made: Plan) -> Counter[tuple[str, str]]:
    return policy(lesson for _, lessons in made.new for lesson in lessons)


def of(*sentences: str) -> list[Lesson]:
    """The lessons of sentences, each understood alone."""
    return [as_lesson(parse(sentence).meaning, sentence) for sentence in sentences]


def as_lesson(meaning: Meaning, words: str = "") -> Lesson:
    (lesson,) = lessons_of(meaning, words)
    return lesson


def lasts(lesson: Lesson) -> bool:
    """Facts are stored where they say of what kind somebody with a name is (kernel/attending.py)."""
    if lesson.kind != "fact":
        return True
    graphlet = lesson.content
    named = {t.name for t in graphlet.terms if t.kind == "obj" and t.lex - {"you", "me"}}  # type: ignore[union-attr]
    main = next(t for t in graphlet.terms if t.name == graphlet.main)  # type: ignore[union-attr]
    return any(role == "ako" and to in named for role, to in main.links)


@st.composite
def named(draw: st.DrawFn) -> Meaning:
    """A fact that is stored: "Mary is not a girl"."""
    name, kind = draw(st.sampled_from(nets.NAMES)), draw(st.sampled_from(["girl", "toy", "person"]))
    meaning = parse(f"{name} is{draw(st.sampled_from(['', ' not']))} a {kind}").meaning
    assert isinstance(meaning, Fact)
    return meaning


drawn = st.one_of(
    *(nets.procedures, nets.arounds, nets.reactions, nets.prohibitions),
    *(nets.permissions, nets.trusts, nets.rules, named()),
).map(as_lesson)


@settings(max_examples=40, deadline=None)
@given(st.lists(drawn, min_size=1, max_size=6))
def test_any_lessons_are_learned_again(lessons: list[Lesson]) -> None:
    text = text_of(stored(lessons))
    made = planned(text)
    assert (made.wrong, made.known) == ((), ())
    assert learned(made) == policy(lessons), text


def listed_lessons() -> list[Lesson]:
    """Those of the sentences of tests/grammars that are stored."""
    found: list[Lesson] = []
    for path in sorted(LISTS.glob("*.tsv")):
        for line in path.read_text(encoding="utf8").splitlines():
            try:
                lessons = lessons_of(parse(line.split("\t")[1]).meaning, line.split("\t")[1])
            except (NotUnderstoodError, IndexError):
                continue
            found += filter(lasts, lessons)
    return found


def test_a_store_of_everything_ever_taught_is_learned_again() -> None:
    lessons = listed_lessons()
    assert len(lessons) > 300
    made = planned(text_of(stored(lessons)))
    assert made.wrong == ()
    assert learned(made) == policy(lessons)


def test_the_file_is_english_by_kind_with_who_taught_it_when_and_how() -> None:
    table = stored(
        of(
            "you could drive backwards if something is very close",
            "to zorp, turn left",
            "never grab a cup",
            "Mary is a girl",
            "widdershins means counterclockwise",
        ),
        teacher="mary",
    )
    text = text_of(table)
    assert [line for line in text.splitlines() if line and line[0] != "#"] == [
        "widdershins means counterclockwise",
        "to zorp, turn left",
        "if something is very close, you could drive backward",
        "Mary is a girl",
        "never grab a cup",
    ]
    comment = text.splitlines()[text.splitlines().index("to zorp, turn left") - 1]
    assert comment.startswith("# Mary, 19")
    assert "zorp" not in comment, "words that do not differ are not repeated"
    assert ": you could drive backwards if something is very close\n" in text
    assert "to zorp" not in text_of(table, "prohibition", "fact")


def test_what_is_not_in_force_is_not_written_as_if_it_were() -> None:
    taught = of("never grab a cup", "to zorp, turn left", "if something is a girl it is a person")
    one, two, three = (teaching(number, lesson) for number, lesson in enumerate(taught, start=1))
    own = Lesson(4, "rule", three.learned[0].content, origins=(1, 2))
    changes = [one, two, three, Change(4, learned=(own,), own=True), Change(5, retracted=(1,))]
    resting = [
        Resting(9, "to hover, lift off\x1b[2J", "the body lacks\nhover", "procedure", "rick")
    ]
    text = text_of(rows(changes, resting))
    assert "grab" not in text
    assert "# Left out: 1 that it made by itself, and will make again." in text
    assert "# to hover, lift off [2J (rests: the body lacks hover)" in text
    assert len(planned(text).new) == 2


def test_taught_strength_is_written_not_the_adapted_one() -> None:
    lesson = of("if something is close, you could drive backward")[0]
    table = rows([teaching(1, lesson), Change(2, adapted=(Adapted(1, 0.8, 0.3),), own=True)])
    assert table[0].strength == 0.3
    assert learned(planned(text_of(table))) == policy([lesson])


def test_a_prohibition_and_the_permission_that_followed_stay_in_order() -> None:
    sentences = ("you may grab a cup", "never grab a cup", "you may grab a red cup")
    text = text_of(stored(of(*sentences)))
    places = [text.index(f"\n{sentence}\n") for sentence in sentences]
    assert places == sorted(places)


def test_what_is_known_is_left_out_as_often_as_it_is_known() -> None:
    text = "never grab a cup\nto zorp, turn left\nnever grab a cup\n"
    made = planned(text, stored(of("never grab a cup")))
    assert [line.number for line in made.known] == [1]
    assert [line.number for line, _ in made.new] == [2, 3]


def test_a_line_may_use_words_that_a_later_line_brings() -> None:
    made = planned("to fribble, zorp then blick\nto zorp, turn left\nto blick, turn right\n")
    assert made.wrong == ()
    assert [line.number for line, _ in made.new] == [2, 3, 1]


def test_wrong_lines_are_named_with_what_is_wrong() -> None:
    made = planned("to zorp, turn left\n\ndrive forward\n# note\nzork the if\nwho am I\n")
    assert [(wrong.line.number, wrong.line.text) for wrong in made.wrong] == [
        (3, "drive forward"),
        (5, "zork the if"),
        (6, "who am I"),
    ]
    whys = [wrong.why for wrong in made.wrong]
    assert whys[0].startswith("a command is no lesson")
    assert "zork" in whys[1]
    assert whys[2].startswith("a question is no lesson")


def test_a_speaker_whose_name_is_too_long_is_a_wrong_line() -> None:
    made = planned(f"you({'x' * 61}): never grab a cup\n")
    assert "60 characters" in made.wrong[0].why


def test_dialogue_lines_say_who_teaches() -> None:
    data = "\ufeffyou: to zorp, turn left\r\nyou(Mary): never grab a cup\n  you (unknown):  Rick is a boy \n#x\n"
    assert read_lines(data.encode()) == (
        Line(1, "to zorp, turn left"),
        Line(2, "never grab a cup", "Mary"),
        Line(3, "Rick is a boy", ""),
    )


@pytest.mark.parametrize(("data", "at"), [(b"a\nb\xff\n", 2), (b"\x00", 1), (b"a\n\nx\x00y", 3)])
def test_what_is_no_text_is_refused_with_its_line(data: bytes, at: int) -> None:
    with pytest.raises(NotTextError) as error:
        read_lines(data)
    assert error.value.at == at


@given(st.binary(max_size=200))
def test_any_bytes_are_lines_or_no_text(data: bytes) -> None:
    try:
        lines = read_lines(data)
    except NotTextError as refused:
        at = refused.at
        lines = read_lines(b"".join(data.splitlines(keepends=True)[: at - 1]))
    assert all(line.text.strip() == line.text for line in lines)


def test_recheck_tells_whose_words_mean_something_else() -> None:
    kept, other = of("never grab a cup", "to zorp, turn left")
    moved = Lesson(0, "procedure", other.content, "to zorp, turn right")
    gone = Lesson(0, "procedure", other.content, "the if of zorp")
    command = Lesson(0, "procedure", other.content, "drive forward")
    found = [(row.ident, now) for row, now in changed(stored([kept, moved, gone, command]))]
    assert found == [(2, "procedure"), (3, "no longer understood"), (4, "now a command")]
