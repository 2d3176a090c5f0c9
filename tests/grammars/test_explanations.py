"""What the robot says of itself: who, why, when and how often, in words."""

from __future__ import annotations

import pytest

from grammars.render.moments import lasting, moment
from grammars.replies import say
from kernel.action.verdict import Verdict
from kernel.memory.experience import Deed, Occasion, Source, Trouble
from kernel.memory.explanation import (
    Abilities,
    Allowed,
    Asked,
    Because,
    Counted,
    Knowledge,
    Lessons,
    Moment,
    Plan,
    PlanStep,
    Taught,
)
from kernel.memory.inference import Inference
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.meaning import Ask, Question
from kernel.memory.notation import read
from kernel.memory.reply import Reply
from kernel.net.graphlet import Graphlet

DAY_S = 86_400
NOON_S = 19_675 * DAY_S + 43_200  # 14 November 2023, 12:00 UTC
ASKED = Asked(NOON_S)


def net(text: str) -> Graphlet:
    """A graphlet from one line of items: "act-1 -lex- grab, -obj-> obj-2"."""
    content = read(text.replace(", ", "\n"))
    assert isinstance(content, Graphlet)
    return content


def lesson(words: str, teacher: str = "freddy", kind: str = "procedure") -> Lesson:
    return Lesson(7, kind, net("act-1 -lex- dance"), words, teacher, NOON_S - 3600)  # type: ignore[arg-type]


LEFT = net("act-1 -lex- turn, dir-2 -lex- left, -dir-> act-1")
BACK = net("act-1 -lex- drive, dir-2 -lex- backward, -dir-> act-1")
DANCE = net("act-1 -lex- dance")
GRAB_MARY = net("act-1 -lex- grab, -obj-> obj-2, obj-2 -lex- mary")
THAT = net("act-1 -ref- that")
VERY_CLOSE = net("hq-1 -lex- close, -hq-> obj-2, deg-3 -lex- very, -deg-> hq-1")
MARY_IS = "ako-1 -lex- {}, -ako-> obj-2, obj-2 -lex- mary"
NEVER = lesson("Never grab a person.")
TO_DANCE = lesson("to dance turn left")
GIRLS = Inference(
    net(MARY_IS.format("person")),
    lesson("a girl is a person", "janey", "rule"),
    (net(MARY_IS.format("girl")),),
)
REFUSED = Trouble("prohibited", GRAB_MARY, by=NEVER, steps=(GIRLS,))
BY_MARY = Source("mary", "dance", NOON_S)


def asked(ask: Ask, about: Graphlet = THAT, topic: str = "did") -> Question:
    return Question(ask, about, "", topic)


def deed(act: Graphlet = LEFT, **more: object) -> Deed:
    ended = {"ended_s": 2.0, "verdict": Verdict.SUCCEEDED, "source": BY_MARY, **more}
    return Deed(1, act, act, 1, 1.0, **ended)  # type: ignore[arg-type]


def because(
    done: Deed | None, ask: Ask = "why", about: Graphlet = THAT, root: Deed | None = None
) -> Because:
    return Because(asked(ask, about), ASKED, done, root or done)


CLOSE = Occasion(lesson("If something is very close then drive backwards."), VERY_CLOSE)
FAILED = {"verdict": Verdict.FAILED}

CASES: list[tuple[str, Reply, str]] = [
    (
        "a reaction",
        because(deed(BACK, occasion=CLOSE, source=None, within=(CLOSE.lesson,))),
        "Because something was very close, and Freddy taught me: If something is very close then drive backwards.",
    ),
    (
        "a step of a reaction",
        because(deed(LEFT, occasion=CLOSE, source=None, within=(CLOSE.lesson, TO_DANCE))),
        "Because something was very close, and Freddy taught me: If something is very close then drive backwards."
        " Freddy taught me: to dance turn left.",
    ),
    ("a command", because(deed()), "Because Mary told me to turn left."),
    (
        "a command by nobody known",
        because(deed(source=Source())),
        "Because I was told to turn left.",
    ),
    (
        "a step",
        because(deed(within=(TO_DANCE,)), root=deed(DANCE)),
        "Because Mary told me to dance, and Freddy taught me: to dance turn left.",
    ),
    ("its own doing", because(deed(source=None)), "I don't know why."),
    (
        "a refusal",
        because(deed(GRAB_MARY, trouble=REFUSED, **FAILED)),
        "I did not grab Mary, because Freddy taught me: Never grab a person."
        " Mary is a girl, and Janey taught me: a girl is a person.",
    ),
    (
        "why not",
        because(deed(GRAB_MARY, trouble=REFUSED, **FAILED), about=GRAB_MARY.denied()),
        "Because Freddy taught me: Never grab a person. Mary is a girl, and Janey taught me: a girl is a person.",
    ),
    (
        "a step was refused",
        because(deed(DANCE, trouble=REFUSED, **FAILED), about=DANCE.denied()),
        "Because I may not grab Mary, as Freddy taught me: Never grab a person."
        " Mary is a girl, and Janey taught me: a girl is a person.",
    ),
    (
        "a failure, asked by yes or no",
        because(deed(GRAB_MARY, trouble=Trouble("nothing_gripped"), **FAILED), "yesno"),
        "No, I did not grab Mary, because I have nothing in my gripper.",
    ),
    (
        "cut short",
        because(deed(trouble=Trouble("stopped"), verdict=Verdict.STOPPED)),
        "I began to turn left, but I was stopped.",
    ),
    (
        "never begun",
        because(deed(trouble=Trouble("stopped"), verdict=Verdict.STOPPED, ended_s=1.0)),
        "I did not turn left, because I was stopped.",
    ),
    ("why not, and it did", because(deed(), about=LEFT.denied()), "I did turn left."),
    (
        "why not, and it is at it",
        because(deed(verdict=None, ended_s=None), about=LEFT.denied()),
        "I am turning left.",
    ),
    ("nothing at all", because(None), "I did nothing."),
    ("never done", because(None, about=LEFT), "I did not turn left."),
    ("never told", because(None, about=LEFT.denied()), "Nobody told me to turn left."),
    (
        "never told and forbidden",
        Because(asked("why", GRAB_MARY.denied()), ASKED, trouble=REFUSED),
        "Because Freddy taught me: Never grab a person. Mary is a girl, and Janey taught me: a girl is a person.",
    ),
    (
        "who taught",
        Taught(asked("who", DANCE, "taught"), ASKED, (TO_DANCE,)),
        "Freddy taught me: to dance turn left.",
    ),
    (
        "when",
        Taught(asked("when", DANCE, "taught"), ASKED, (TO_DANCE,)),
        "Freddy taught me today at 11:00: to dance turn left.",
    ),
    (
        "who told",
        Taught(asked("who", net(MARY_IS.format("girl")), "taught"), ASKED, told=Source("rick", "Mary is a girl.")),
        "Rick told me: Mary is a girl.",
    ),
    (
        "how it knows",
        Taught(asked("who", net(MARY_IS.format("person")), "taught"), ASKED, steps=(GIRLS,)),
        "I concluded that: Mary is a girl, and Janey taught me: a girl is a person.",
    ),
    ("noticed", Taught(asked("who", VERY_CLOSE, "taught"), ASKED, noticed=True), "I noticed that myself."),
    ("born", Taught(asked("how", LEFT, "know_how"), ASKED, born=True), "I was born knowing how to turn left."),
    ("nobody taught", Taught(asked("who", DANCE, "taught"), ASKED), "Nobody taught me to dance."),
    (
        "nobody told",
        Taught(asked("who", net(MARY_IS.format("girl")), "taught"), ASKED),
        "Nobody told me that Mary is a girl.",
    ),
    ("nobody forbade", Taught(asked("who", DANCE.denied(), "taught"), ASKED), "Nobody taught me not to dance."),
    ("nothing yet", Taught(asked("who", THAT, "taught"), ASKED), "Nobody taught me anything."),
    (
        "knowledge",
        Knowledge(
            asked("what", net("obj-2 -lex- mary"), "know_about"),
            (net(MARY_IS.format("girl")), net("hq-3 -lex- sad, -hq-> obj-2, obj-2 -lex- mary")),
            (net("ako-5 -lex- person, -ako-> obj-2, obj-2 -lex- mary"),),
            (NEVER,),
        ),
        "Mary is a girl and sad. From that I conclude that Mary is a person.",
    ),
    (
        "no knowledge",
        Knowledge(asked("what", net("obj-2 -lex- mary"), "know_about")),
        "I know nothing about Mary.",
    ),
    (
        "lessons by teacher",
        Lessons(asked("what", THAT, "learned"), (TO_DANCE, NEVER, lesson("Mary is a girl", "rick", "fact"))),
        "Freddy taught me: to dance turn left; Never grab a person. Rick told me: Mary is a girl.",
    ),
    (
        "at most five lessons",
        Lessons(asked("what", THAT, "learned"), tuple(lesson(f"lesson {n}") for n in range(8))),
        "Freddy taught me: lesson 0; lesson 1; lesson 2; lesson 3; lesson 4, and 3 more.",
    ),
    ("no lessons today", Lessons(asked("what", THAT, "learned")), "Nobody taught me anything today."),
    ("no way", Lessons(asked("how", DANCE, "know_how")), "I don't know how to dance."),
    ("nothing happens", Lessons(asked("what", VERY_CLOSE, "happens")), "Nothing that I was taught."),
    ("nothing forbidden", Lessons(asked("yesno", THAT, "allowed")), "Nobody has forbidden me anything."),
    (
        "abilities",
        Abilities(("drive", "turn", "say"), (DANCE, LEFT)),
        "I can drive, turn and speak, and I was taught to dance and turn left.",
    ),
    (
        "many abilities",
        Abilities(("drive",), (DANCE,) * 8),
        "I can drive, and I was taught to dance, dance, dance, dance, dance and 3 things more.",
    ),
    ("not once", Counted(asked("howmany", LEFT), 0), "I did not turn left."),
    ("once", Counted(asked("howmany", LEFT), 1), "I turned left once."),
    ("often", Counted(asked("howmany", LEFT), 3), "I turned left 3 times."),
    ("when done", Moment(asked("when", LEFT), ASKED, deed(wall_s=NOON_S - DAY_S)), "I turned left yesterday at 12:00."),
    ("when, not known", Moment(asked("when", LEFT), ASKED, deed()), "I turned left, but I don't know when."),
    ("when, never", Moment(asked("when", LEFT), ASKED), "I did not turn left."),
    ("allowed", Allowed(asked("yesno", LEFT, "allowed")), "Yes, I may turn left."),
    (
        "not allowed",
        Allowed(asked("yesno", GRAB_MARY, "allowed"), REFUSED),
        "No, Freddy taught me: Never grab a person. Mary is a girl, and Janey taught me: a girl is a person.",
    ),
    (
        "allowed but",
        Allowed(asked("yesno", DANCE, "allowed"), Trouble("no_way", DANCE)),
        "Yes, but I don't know how to dance.",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("reply", "spoken"), [pytest.param(r, s, id=i) for i, r, s in CASES])
def test_spoken(reply: Reply, spoken: str) -> None:
    assert say(reply).spoken == spoken


def test_the_screen_says_when_each_lesson_was_taught() -> None:
    shown = say(because(deed(within=(TO_DANCE,)), root=deed(DANCE))).shown
    assert shown == (
        "Because Mary told me to dance, and Freddy taught me today at 11:00: to dance turn left."
    )


def step(act: Graphlet, begin_s: float, end_s: float) -> PlanStep:
    return PlanStep(act, begin_s, end_s, Verdict.SUCCEEDED)


@pytest.mark.parametrize(
    ("plan", "spoken"),
    [
        ({}, "I would do nothing."),
        (
            {"steps": (step(LEFT, 0, 1), step(BACK, 1, 2)), "whole_s": 2.0},
            "I would turn left, then drive backward: 2 seconds in all.",
        ),
        (
            {"steps": (step(LEFT, 0, 1), step(BACK, 0.5, 1.5)), "whole_s": 1.5},
            "I would turn left and drive backward: 1.5 seconds in all.",
        ),
        (
            {"steps": tuple(step(LEFT, n, n + 1) for n in range(9)), "whole_s": 9.0},
            "I would turn left, then turn left, then turn left, then turn left, then turn left, then turn left,"
            " and 3 more steps: 9 seconds in all.",
        ),
        (
            {"steps": (step(LEFT, 0, 60),), "whole_s": 60.0, "unfinished": True},
            "I would turn left: and so on.",
        ),
        (
            {"trouble": REFUSED},
            "I would not grab Mary, because Freddy taught me: Never grab a person."
            " Mary is a girl, and Janey taught me: a girl is a person.",
        ),
        (
            {"trouble": Trouble("no_way", DANCE)},
            "I would not, because I don't know how to dance.",
        ),
        (
            {"steps": (step(LEFT, 0, 1),), "whole_s": 1.0, "trouble": Trouble("nothing_gripped")},
            "I would turn left: 1 second in all. But I have nothing in my gripper.",
        ),
    ],
)
def test_a_plan(plan: dict[str, object], spoken: str) -> None:
    assert say(Plan(asked("what", THAT, "would"), **plan)).spoken == spoken  # type: ignore[arg-type]


def test_a_plan_on_the_screen_has_its_times() -> None:
    reply = Plan(asked("what", THAT, "would"), (step(LEFT, 0, 1), step(BACK, 1, 2)), 2.0)
    assert say(reply).shown == (
        "I would turn left (0.0 to 1.0 s), then drive backward (1.0 to 2.0 s): 2 seconds in all."
    )


@pytest.mark.parametrize(
    ("fact", "words"),
    [
        ("hq-1 -lex- green, -hq-> obj-2, ako-3 -lex- light, -ako-> obj-2", "the light was green"),
        ("hq-1 -lex- low, -neg- yes, -hq-> obj-2, obj-2 -lex- mary", "Mary was not low"),
        ("hq-1 -lex- stuck, -hq-> obj-2, obj-2 -lex- you", "I was stuck"),
        ("act-1 -lex- drop, -agt-> obj-2, -obj-> obj-3, obj-2 -lex- you", "I dropped something"),
        ("act-1 -lex- hold, -neg- yes, -agt-> obj-2, obj-2 -lex- mary", "Mary did not hold"),
        ("input-1 -lex- tell, -agt-> user-2, user-2 -lex- rick", "Rick said something to me"),
    ],
)
def test_what_was_so_is_told_in_the_past(fact: str, words: str) -> None:
    occasion = Occasion(TO_DANCE, net(fact))
    assert f"Because {words}, and" in say(because(deed(occasion=occasion))).spoken


@pytest.mark.parametrize(
    ("at_s", "offset_s", "words"),
    [
        (NOON_S - 60, 0, "today at 11:59"),
        (NOON_S - 60, 7200, "today at 13:59"),
        (NOON_S - 12 * 3600 - 60, 0, "yesterday at 23:59"),
        (NOON_S - 12 * 3600 - 60, 3600, "today at 0:59"),
        (NOON_S - 195 * DAY_S, 0, "on 3 May"),
        (NOON_S - 400 * DAY_S, 0, "on 10 October 2022"),
        (0, 0, ""),
    ],
)
def test_moments(at_s: float, offset_s: float, words: str) -> None:
    assert moment(at_s, NOON_S, offset_s) == words


def test_lengths_of_time() -> None:
    assert [lasting(s) for s in (1.0, 4.04, 0.5)] == ["1 second", "4 seconds", "0.5 seconds"]


def test_what_has_no_words_is_read_back() -> None:
    content = read(
        "trig: DO[ act-1 -lex- dance ]\npref: 1.0\n---------------\nDO[ act-2 -lex- wait ]"
    )
    assert isinstance(content, Operator)
    by_itself = Lesson(3, "procedure", content)
    reply = Lessons(asked("how", DANCE, "know_how"), (by_itself,))
    assert say(reply).spoken == "I found out by myself: to dance, wait."
