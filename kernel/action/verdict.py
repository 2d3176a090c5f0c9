"""How a directive, play, chain or grounding function can end."""

from __future__ import annotations

from enum import Enum


class Verdict(Enum):
    """Source: Connell 2019, section 3; UNKNOWN and STOPPED are ours (mind.md)."""

    SUCCEEDED = "succeeded"
    FAILED = "failed"
    PUNTED = "punted"
    UNKNOWN = "unknown"  # CHK: neither true nor false
    STOPPED = "stopped"

    @property
    def ok(self) -> bool:
        """Only SUCCEEDED."""
        return self is Verdict.SUCCEEDED
