"""Who taught or told something, and when."""

from __future__ import annotations

from grammars.render import claim_in_words
from grammars.render.reasons import asked_act, lines, reasoning, taught, told
from grammars.replies import Said, both, renders
from kernel.memory.explanation import Taught
from kernel.net.graphlet import Term

MOST = 2  # lessons told in one answer


@renders(Taught)
def who_taught(reply: Taught) -> Said:
    """ "Freddy taught me: to bow lower the lift then raise the lift." """
    return both(lines(_told(reply)))


def _told(reply: Taught) -> list[str]:
    asked = reply.asked if reply.question.ask == "when" else None
    if reply.lessons:
        if asked is not None and not reply.lessons[0].at_s:
            return ["I don't know when that was"]
        return [taught(lesson, asked) for lesson in reply.lessons[:MOST]]
    if reply.told is not None:
        return [told(reply.told, asked)]
    if reply.steps:
        return [f"I concluded that: {reasoning(reply.steps)}"]
    if reply.noticed:
        return ["I noticed that myself"]
    about = reply.question.about
    main = about.head or Term(about.main)
    if reply.born:
        return [f"I was born knowing how to {asked_act(about)}"]
    if main.kind != "act" or any(role == "agt" for role, _ in main.links):
        return [f"nobody told me that {claim_in_words(about)}"]
    if not main.lex:
        return ["nobody taught me anything"]
    denied = "not " if main.negated else ""
    return [f"nobody taught me {denied}to {asked_act(about)}"]
