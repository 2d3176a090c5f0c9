"""What is said over the control socket: one JSON object a line, version 1.

A client sends requests, the daemon answers each with any number of `Happened` and one `Done`, `Told` or `Wrong`.
"""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

import msgspec

LINE_BYTES: Final = 16_384  # longest request
TEXT_LENGTH: Final = 1_000
NAME_LENGTH: Final = 60
REQUESTS_A_SECOND: Final = 20.0
BURST: Final = 40
LESSONS_AT_ONCE: Final = 500
FORGET_AT_ONCE: Final = 100
LOG_AT_ONCE: Final = 1_000

Text = Annotated[str, msgspec.Meta(min_length=1, max_length=TEXT_LENGTH)]
Name = Annotated[str, msgspec.Meta(max_length=NAME_LENGTH)]
Number = Annotated[int, msgspec.Meta(ge=0, le=2**62)]
OutcomeWord = Literal["done", "failed", "not_understood", "running"]


class Request(
    msgspec.Struct,
    frozen=True,
    tag_field="do",
    tag=str.lower,
    forbid_unknown_fields=True,
    kw_only=True,
):
    """Something the daemon is asked to do.

    Attributes:
        v: version of this protocol.
        id: the client's number for it, repeated in every answer; requests of one connection run side by side.
    """

    v: Literal[1]
    id: int = 0


class Say(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """One typed utterance; answered when nothing is going on any more. aloud: lessons are acknowledged by voice."""

    text: Text
    speaker: Name = ""
    aloud: bool = True


class Hear(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Recognise a WAV file of the daemon's machine and take what it says. path: absolute."""

    path: Text
    speaker: Name = ""


class Stop(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Stop everything, now."""


class Status(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """How are hearing, mind and link?"""


class Lessons(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Lessons with a greater number than `after`, at most `most`, those taken back as well."""

    after: Number = 0
    most: Annotated[int, msgspec.Meta(ge=1, le=LESSONS_AT_ONCE)] = LESSONS_AT_ONCE


class Forget(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Take these lessons back; all of them or, where one is not in force, none."""

    lessons: Annotated[tuple[Number, ...], msgspec.Meta(min_length=1, max_length=FORGET_AT_ONCE)]
    speaker: Name = ""


class Log(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The last entries of the log."""

    last: Annotated[int, msgspec.Meta(ge=1, le=LOG_AT_ONCE)] = 20


class Watch(Request, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Every event from now on, until the connection is closed."""


class Answer(msgspec.Struct, frozen=True, tag_field="is", tag=str.lower, kw_only=True):
    """Something the daemon answers. id: the request's."""

    id: int = 0


class Happened(Answer, frozen=True, kw_only=True):
    """An event, as in `rehearse --json`."""

    event: dict[str, Any]


class Done(Answer, frozen=True, kw_only=True):
    """What the utterance came to."""

    outcome: OutcomeWord
    text: str = ""


class Told(Answer, frozen=True, kw_only=True):
    """The answer to Status, Stop (epoch), Lessons (lessons: rows of daemon/lessons.py; more) or Log (entries)."""

    facts: dict[str, Any]


class Wrong(Answer, frozen=True, kw_only=True):
    """The request was not taken; nothing changed."""

    error: str


AnyRequest = Say | Hear | Stop | Status | Lessons | Forget | Log | Watch
AnyAnswer = Happened | Done | Told | Wrong

_requests: Final[msgspec.json.Decoder[AnyRequest]] = msgspec.json.Decoder(AnyRequest)
_answers: Final[msgspec.json.Decoder[AnyAnswer]] = msgspec.json.Decoder(AnyAnswer)


def read_request(line: bytes) -> AnyRequest:
    """Decode one line.

    Raises:
        ValueError: not a request; the message says what is wrong with it.
    """
    try:
        return _requests.decode(line)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ValueError(str(error)) from error


def read_answer(line: bytes) -> AnyAnswer:
    """Decode one line of the daemon's.

    Raises:
        ValueError: not an answer.
    """
    try:
        return _answers.decode(line)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ValueError(str(error)) from error


def line(message: Request | Answer) -> bytes:
    """Encode, with the end of line."""
    return msgspec.json.encode(message) + b"\n"
