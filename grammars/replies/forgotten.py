"""Lessons were forgotten: which."""

from __future__ import annotations

from grammars.render import act_in_words, render, thing_in_words
from grammars.replies import Said, both, renders
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.reply import Forgotten


@renders(Forgotten)
def forgotten(reply: Forgotten) -> Said:
    """ "I have forgotten how to salute." """
    about = reply.about
    if about is not None and about.main.startswith("act"):
        how = f"how to {act_in_words(about)}"
        return both(f"I have forgotten {how}" if reply.lessons else f"I don't know {how}")
    if about is not None:
        thing = thing_in_words(about.main, (about,))
        if not reply.lessons:
            return both(f"I know nothing about {thing}")
        return both(f"I have forgotten what I was told about {thing}")
    named = [*map(_named, reply.lessons)]
    if reply.resting:
        named += [
            "a lesson that rested" if reply.resting == 1 else f"{reply.resting} lessons that rested"
        ]
    if not named:
        return both("I never learned that")
    return both(f"I have forgotten {' and '.join(named)}")


def _named(lesson: Lesson) -> str:
    """What to call a lesson in a sentence."""
    content = lesson.content
    if isinstance(content, Operator) and content.trigger.tag == "DO" and content.trigger.graphlet:
        return f"how to {act_in_words(content.trigger.graphlet)}"
    return f"that {render(content, 'robot')}"
