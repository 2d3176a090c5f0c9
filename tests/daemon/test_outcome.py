"""What an utterance came to, judged by what follows it."""

from __future__ import annotations

import pytest

from daemon import events
from daemon.control.messages import OutcomeWord
from daemon.outcome import EXIT_STATUS, Following

T = 1.0


def replied(ok: bool) -> events.Replied:
    return events.Replied(t=T, kind="Failed", shown="", spoken="", ok=ok)


@pytest.mark.parametrize(
    ("happened", "outcome"),
    [
        ([], "done"),
        ([events.Ended(t=T, text="", verdict="succeeded", utterance="dance")], "done"),
        ([events.Ended(t=T, text="", verdict="failed", utterance="dance")], "failed"),
        ([events.Ended(t=T, text="", verdict="stopped", utterance="dance")], "failed"),
        ([events.Ended(t=T, text="", verdict="failed", utterance="another")], "done"),
        ([events.NotUnderstood(t=T, text="dance", reason="")], "not_understood"),
        ([events.NotUnderstood(t=T, text="another", reason="")], "done"),
        ([events.NotUnderstood(t=T, text="dance", reason=""), replied(False)], "not_understood"),
        ([events.Prohibited(t=T, by="never dance")], "failed"),
        ([replied(True)], "done"),
        ([replied(False)], "failed"),
        ([events.Error(t=T, part="store", text="disk full")], "failed"),
        ([events.Error(t=T, part="hearing", text="no microphone")], "done"),
    ],
)
def test_outcomes(happened: list[events.Event], outcome: OutcomeWord) -> None:
    following = Following("dance")
    for event in happened:
        following.see(event)
    assert following.outcome == outcome


def test_whatever_is_heard_counts_where_no_text_is_given() -> None:
    following = Following()
    following.see(events.Ended(t=T, text="", verdict="failed", utterance="dance"))
    assert following.outcome == "failed"


def test_an_utterance_is_over_once_it_itself_has_ended() -> None:
    following = Following("dance")
    following.see(events.Ended(t=T, text="", verdict="succeeded", utterance="another"))
    assert not following.over_for(0.0, T + 9.0)
    following.see(events.Ended(t=T, text="", verdict="succeeded", utterance="dance"))
    assert not following.over_for(2.0, T + 1.5)
    assert following.over_for(2.0, T + 2.0)


def test_exit_statuses_are_those_of_the_help() -> None:
    assert EXIT_STATUS == {"done": 0, "running": 0, "failed": 1, "not_understood": 3}
