"""What the robot is born knowing: the compiled file is fresh, and says what it should."""

from __future__ import annotations

from importlib.resources import files

import pytest

from grammars import knowledge
from grammars.knowledge import born
from grammars.knowledge.compiling import NoLessonError, compiled, sentences
from grammars.render import render
from kernel.errors import NotationError
from kernel.memory.lesson import INNATE, Operator


def test_the_compiled_file_is_fresh() -> None:
    kept = files(knowledge).joinpath(knowledge.COMPILED).read_text("utf8")
    assert kept == compiled(), "run scripts/compile_knowledge.py"


def test_every_sentence_became_a_lesson_with_a_number_below_zero() -> None:
    lessons = born()
    assert [lesson.words for lesson in lessons] == list(sentences())
    assert len({lesson.ident for lesson in lessons}) == len(lessons)
    assert all(INNATE < lesson.ident < 0 for lesson in lessons)
    assert all(not lesson.teacher for lesson in lessons)


def test_the_number_of_a_lesson_is_its_own_whatever_stands_before_it() -> None:
    """The journal of what was forgotten names lessons by number."""
    kept = files(knowledge).joinpath(knowledge.COMPILED).read_text("utf8")
    later = knowledge.lessons("# fact: mary is a girl\nako-1 -lex- girl\n\n" + kept)
    assert [lesson.ident for lesson in later[1:]] == [lesson.ident for lesson in born()]


def test_picking_up_is_grabbing_then_raising() -> None:
    lesson = born()[0]
    assert lesson.kind == "procedure"
    assert isinstance(lesson.content, Operator)
    assert render(lesson.content, "teacher") == "to pick up something, grab it then raise the lift"


def test_nothing_born_reacts_forbids_or_names() -> None:
    """A fresh robot has the body's skills and their stock words only: no advice of its own on anything it may sense."""
    assert {lesson.kind for lesson in born()} <= {"procedure"}


@pytest.mark.parametrize(
    "damaged",
    [
        "act-1 -lex- drive",
        "# song: la la la\nact-1 -lex- drive",
        "# fact: mary is a girl\nact-1 -lex-> drive",
        "# procedure: to bow, lower the lift\n",
    ],
)
def test_a_damaged_file_is_an_error(damaged: str) -> None:
    with pytest.raises(NotationError):
        knowledge.lessons(damaged)


def test_a_sentence_that_teaches_nothing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("grammars.knowledge.compiling.sentences", lambda: ["drive forward"])
    with pytest.raises(NoLessonError, match="drive forward"):
        compiled()
