"""What an utterance came to, judged by the events that follow it."""

from __future__ import annotations

from typing import Final

from daemon import events
from daemon.control.messages import OutcomeWord

EXIT_STATUS: Final[dict[str, int]] = {"done": 0, "running": 0, "failed": 1, "not_understood": 3}


class Following:
    """Watches the events after an utterance.

    Args:
        text: the utterance, as it was given to the cycle; None: whatever is heard.
    """

    def __init__(self, text: str | None = None) -> None:
        self._text = text
        self._outcome: OutcomeWord = "done"
        self.over_s: float | None = None

    def over_for(self, seconds: float, now_s: float) -> bool:
        """The utterance itself came to its end at least so long ago, whatever else is still going on."""
        return self.over_s is not None and now_s - self.over_s >= seconds

    @property
    def outcome(self) -> OutcomeWord:
        """As things are now: meant to be read once nothing is going on any more."""
        return self._outcome

    def see(self, event: events.Event) -> None:
        """Take one event into account."""
        if self._ends(event):
            self.over_s = event.t
        match event:
            case events.NotUnderstood(text=text) if self._text in (None, text):
                self._outcome = "not_understood"
            case events.Replied(ok=False) | events.Prohibited():
                self._fail()
            case events.Ended(utterance=utterance, verdict=verdict) if verdict != "succeeded":
                if self._text in (None, utterance):
                    self._fail()
            case events.Error(part="mind" | "store" | "understanding"):
                self._fail()
            case _:
                pass

    def _ends(self, event: events.Event) -> bool:
        match event:
            case events.Ended(utterance=words) | events.NotUnderstood(text=words):
                return self._text is not None and words == self._text
        return False

    def _fail(self) -> None:
        if self._outcome == "done":
            self._outcome = "failed"
