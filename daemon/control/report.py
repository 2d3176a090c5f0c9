"""Events as lines for a person at a terminal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def line(event: Mapping[str, Any]) -> str | None:
    """One event, as `events.as_dict` or the control socket gives it; None where a person need not see it.

    >>> line({"t": 0.0, "event": "heard", "text": "dance"})
    'heard       dance'
    """
    match event:
        case {"event": "heard", "text": text}:
            return _row("heard", text)
        case {"event": "understood", "readback": readback, "kind": kind}:
            return _row("understood", f"{readback} ({kind})")
        case {"event": "not_understood", "reason": reason}:
            return _row("unclear", reason)
        case {"event": "replied", "shown": shown, "spoken": spoken} if shown:
            return _row("said" if spoken else "shown", shown)  # at once, be the voice busy or slow
        case {"event": "say_started", "told": True}:
            return None
        case {"event": "say_started", "text": text}:
            return _row("said", text)
        case {"event": "action_started", "text": text, "function": function}:
            return _row("doing", text or function)
        case {"event": "action_ended", "text": text, "function": function, "verdict": verdict}:
            return _row("done", f"{text or function}: {verdict}")
        case {"event": "prohibited", "by": by}:
            return _row("forbidden", f"by: {by}")
        case {"event": "retracted", "ident": ident, "words": words}:
            return _row("forgotten", f"{ident}: {words}")
        case {"event": "stopped"}:
            return _row("stopped", "")
        case {"event": "link", "up": False}:
            return _row("link", "down")
        case {"event": "error", "part": part, "text": text}:
            return _row("error", f"{part}: {text}")
    return None


def _row(label: str, text: str) -> str:
    return f"{label:<11} {text}".rstrip()
