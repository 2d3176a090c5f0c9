"""Numbers a user may set for the mind."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

DAY_S: Final = 86_400


@dataclass(frozen=True, slots=True)
class Settings:
    """Defaults are those of mind.md.

    Attributes:
        threshold: belief below which a premise does not count.
        desperate_threshold: the same, while the robot is desperate: a DO found nothing applicable.
        prohibition_threshold: the same for prohibitions (caution); permission_threshold for permissions.
        least_preference: operators below it are not considered, unless the robot is desperate.
        sharpness: exponent on preference when choosing.
        owner: name of who, beside its teacher, may lift, forget and undo a prohibition; "" for no owner: anybody may.
        praise_step, blame_step: how far one word of praise or blame moves a preference.
        failure_step: how far it falls when the operator failed and another one succeeded.
        recovery_step: how far a lowered one rises with each success, up to the taught one.
        belief_step: how far a rule's belief moves when a person confirms or contradicts what it concluded.
        fade_s: how long a handled focus stays in attention, s.
        depth: operators within operators that are carried out; one more fails and is told.
        utc_offset_s: how far the clock on the wall is ahead of UTC, s: what "today" is.
    """

    threshold: float = 0.5
    desperate_threshold: float = 0.25
    prohibition_threshold: float = 0.2
    permission_threshold: float = 0.8
    least_preference: float = 0.2
    sharpness: float = 1.0
    fade_s: float = 30.0
    owner: str = ""
    depth: int = 20
    utc_offset_s: float = 0.0
    praise_step: float = 0.1
    blame_step: float = 0.2
    failure_step: float = 0.1
    recovery_step: float = 0.05
    belief_step: float = 0.1

    def premises(self, desperate: bool) -> float:
        """Belief below which a premise does not count."""
        return self.desperate_threshold if desperate else self.threshold

    def day(self, at_s: float) -> int:
        """Number of the day on the wall on which that is; at_s: s since 1970."""
        return int((at_s + self.utc_offset_s) // DAY_S)
