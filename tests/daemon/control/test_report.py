"""Events as lines: what the robot answers is told once, whether or not the voice has come to it."""

from __future__ import annotations

from daemon.control.report import line
from daemon.events import Replied, SayStarted, as_dict


def test_an_answer_is_told_with_the_reply_and_not_again_with_the_voice() -> None:
    reply = Replied(
        t=1.0, kind="Answer", shown='I was told "no".', spoken="I was told no.", ok=True
    )
    assert line(as_dict(reply)) == 'said        I was told "no".'
    assert line(as_dict(SayStarted(t=1.1, text="I was told no.", told=True))) is None
    assert line(as_dict(SayStarted(t=1.1, text="hello"))) == "said        hello"
    silent = Replied(t=1.0, kind="Answer", shown="Okay.", spoken="", ok=True)
    assert line(as_dict(silent)) == "shown       Okay."
