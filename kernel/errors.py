"""Errors of the mind. They carry data; the English for a person is made in grammars.replies."""

from __future__ import annotations


class KernelError(Exception):
    """Base of every error raised by the kernel."""


class NotationError(KernelError):
    """A text is not net notation."""

    def __init__(self, line: int, text: str, expected: str) -> None:
        super().__init__(f"line {line}: {text!r}: expected {expected}")
        self.line, self.text, self.expected = line, text, expected


class NotGroundedError(KernelError):
    """A command reached the body but its wording names nothing the body can do.

    Attributes:
        verb: the action's word.
        wanted: what is missing or not known: "direction", or the word itself.
    """

    def __init__(self, verb: str, wanted: str) -> None:
        super().__init__(f"{verb}: {wanted}")
        self.verb, self.wanted = verb, wanted


class LimitError(KernelError):
    """A command asks for more than the body may do. detail names the limit: "2 meters"."""

    def __init__(self, verb: str, detail: str) -> None:
        super().__init__(f"{verb}: more than {detail}")
        self.verb, self.detail = verb, detail


class NoSenseError(KernelError):
    """Nothing on this body can perceive what was asked for. what: the verb's object, or the verb."""

    def __init__(self, what: str) -> None:
        super().__init__(f"no sense for {what}")
        self.what = what


class MotionFailedError(KernelError):
    """The body reports that an action cannot be executed to its end. why: as in BodyState.failed."""

    def __init__(self, ticket: int, why: str) -> None:
        super().__init__(f"action {ticket}: {why}")
        self.ticket, self.why = ticket, why
