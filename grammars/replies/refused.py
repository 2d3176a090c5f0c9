"""An act was vetoed by a lesson: which one, whose, and what it rests on."""

from __future__ import annotations

from grammars.render import act_in_words, claim_in_words
from grammars.render.names import literally
from grammars.render.reasons import exact_words, said_by
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.lesson import LEARN
from kernel.memory.reply import Refused


@renders(Refused)
def refused(reply: Refused) -> Said:
    """ "I may not grab Mary: Freddy told me "never grab a person"." """
    lesson = reply.by
    learning = reply.act.head is not None and reply.act.head.lex == {LEARN}
    act = "learn that" if learning else act_in_words(reply.act)
    said = f"I may not {act}: {said_by(lesson.teacher)} {literally(exact_words(lesson))}"
    reasons = " and ".join(claim_in_words(graphlet) for graphlet in reply.because)
    return Said(sentence(f"{said}, and {reasons}" if reasons else said), aloud(said))
