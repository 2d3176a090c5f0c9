"""Why something was done, or was not."""

from __future__ import annotations

from grammars.render import act_in_words
from grammars.render.reasons import (
    asked_act,
    forbidden,
    lines,
    reasoning,
    said_by,
    same_act,
    taught,
    what_was,
)
from grammars.replies import Said, aloud, renders
from grammars.replies.failed import failure
from kernel.memory.experience import Deed, Trouble
from kernel.memory.explanation import Asked, Because
from kernel.memory.lesson import Lesson
from kernel.memory.reply import Failed
from kernel.net.graphlet import Graphlet


@renders(Because)
def because(reply: Because) -> Said:
    """ "Because something was very close, and Freddy taught me: if something is very close then drive backwards." """
    return Said(lines(_told(reply, reply.asked)), aloud(lines(_told(reply, None))))


def _told(reply: Because, asked: Asked | None) -> list[str]:
    """The sentences; asked: with when each lesson was taught."""
    deed, about = reply.deed, reply.question.about
    main = about.head
    denied = main is not None and main.negated
    if deed is None:
        if reply.trouble is not None:
            first, *more = trouble_in_words(reply.trouble, None, asked)
            return [f"because {first}", *more]
        if main is None or not main.lex:
            return ["I did nothing"]
        return [
            f"nobody told me to {asked_act(about)}" if denied else f"I did not {asked_act(about)}"
        ]
    if deed.trouble is not None:
        return _failed(reply, deed, deed.trouble, denied, asked)
    if denied:
        return [f"I am {_act(deed.act, True)}" if deed.going_on else f"I did {_act(deed.act)}"]
    return _cause(deed, reply.root or deed, reply.way, asked)


def _act(act: Graphlet, going_on: bool = False) -> str:
    return act_in_words(act, (), "gerund" if going_on else "base")


def _failed(
    reply: Because, deed: Deed, trouble: Trouble, denied: bool, asked: Asked | None
) -> list[str]:
    first, *more = trouble_in_words(trouble, deed.act, asked)
    if denied:
        return [f"because {first}", *more]
    no = "no, " if reply.question.ask == "yesno" else ""
    if trouble.reason == "stopped" and deed.ended_s != deed.began_s:
        return [f"{no}I began to {_act(deed.act)}, but {first}", *more]
    return [f"{no}I did not {_act(deed.act)}, because {first}", *more]


def _cause(deed: Deed, root: Deed, way: Lesson | None, asked: Asked | None) -> list[str]:
    """What set it off, the operator that led from there to it or else says how, and what had to be concluded."""
    lessons: list[Lesson] = [lesson for lesson in deed.within if lesson.words]
    if not lessons and way is not None and way.words:
        lessons = [way]
    more = []
    if (occasion := deed.occasion) is not None:
        first = f"because {what_was(occasion.fact)}, and {taught(occasion.lesson, asked)}"
        lessons = [lesson for lesson in lessons if lesson != occasion.lesson]
        more = [taught(lessons[-1], asked)] if lessons else []
        more += [reasoning(occasion.steps)]
        return [first, *more]
    if root.source is None:
        return ["I don't know why"]
    first = f"because {said_by(root.source.teacher)} to {_act(root.act)}"
    if lessons:
        first += f", and {taught(lessons[-1], asked)}"
    return [first]


def trouble_in_words(
    trouble: Trouble, act: Graphlet | None, asked: Asked | None = None
) -> list[str]:
    """Why it came to nothing; a step that failed is named where it is another act than the one in question."""
    if trouble.reason == "stopped":
        return ["I was stopped"]
    if forbidden(trouble) and trouble.by is not None:
        first = taught(trouble.by, asked)
        if act is not None and trouble.act is not None and not same_act(act, trouble.act):
            first = f"I may not {_act(trouble.act)}, as {first}"
        return [first, reasoning(trouble.steps)]
    return [failure(Failed(trouble.act, trouble.reason, trouble.detail))]
