"""A robot that is taught, told and asked by different people at known times of the day."""

from typing import Any

import pytest

from kernel.memory.lesson import Operator, Rule
from kernel.memory.meaning import Ask, Command, Fact, Heard, Meaning, Question, Teach, Utterance
from kernel.memory.notation import read
from kernel.memory.reply import Reply
from tests.kernel.conftest import Robot, chain, net, notation

MORNING_S = 1_700_000_000.0  # 14 November 2023, 22:13 UTC
FORWARD = "DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]"
LEFT = "DO[ act-5 -lex- turn; dir-6 -lex- left; -dir-> act-5 ]"
DANCE = f"trig: DO[ act-9 -lex- dance ]; pref: 1.0; ---------------; {FORWARD}; {LEFT}"
BACK_OFF = (
    "trig: NOTE[ hq-1 -lex- close; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1 ]; pref: 1.0; "
    "---------------; DO[ act-4 -lex- drive; dir-5 -lex- backward; -dir-> act-4 ]"
)
NEVER_GRAB = (
    "trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]; pref: 1.0; "
    "---------------; PUNT[ ]"
)
GRAB_MARY = "FIND[ obj-1 -lex- mary ]; DO[ act-2 -lex- grab; -obj-> obj-1 ]"


class Questioned(Robot):
    """The bench, with people: everything said is dated a minute after what was said before."""

    wall_s = MORNING_S

    def utter(self, speaker: str, words: str, meaning: Meaning) -> None:
        self.wall_s += 60
        self._heard.append(Heard(Utterance(words, speaker, self.wall_s), meaning))
        self.settle()

    def taught(self, speaker: str, words: str, text: str, kind: Any = "procedure") -> None:
        content = read(notation(text))
        assert isinstance(content, Rule | Operator)
        self.utter(speaker, words, Teach(kind, content))

    def rule(self, speaker: str, one: str, other: str) -> None:
        text = f"if: ako-1 -lex- {one}; -ako-> obj-2; then: ako-3 -lex- {other}; -ako-> obj-2; belief: 1.0"
        self.taught(speaker, f"a {one} is a {other}", text, "rule")

    def told(self, speaker: str, words: str, fact: str, *finds: str) -> None:
        self.utter(speaker, words, Fact(net(fact), tuple(map(net, finds))))

    def told_kind(self, speaker: str, name: str, kind: str) -> None:
        self.told(
            speaker,
            f"{name} is a {kind}",
            f"ako-1 -lex- {kind}; -ako-> obj-2",
            f"obj-2 -lex- {name}",
        )

    def ordered(self, speaker: str, words: str, text: str) -> None:
        self.utter(speaker, words, Command(chain(text)))

    def asked(
        self, ask: Ask, about: str, topic: str, speaker: str = "janey", supposed: str = ""
    ) -> Reply:
        before = len(self.replies)
        question = Question(ask, net(about), "", topic, chain(supposed) if supposed else None)
        self.utter(speaker, "a question", question)
        assert len(self.replies) == before + 1
        return self.replies[-1]


@pytest.fixture
def robot() -> Questioned:
    return Questioned()
