"""Whether an act is allowed."""

from __future__ import annotations

from grammars.render.reasons import asked_act, forbidden, lines
from grammars.replies import Said, both, renders
from grammars.replies.because import trouble_in_words
from kernel.memory.explanation import Allowed


@renders(Allowed)
def allowed(reply: Allowed) -> Said:
    """ "No, Freddy taught me: never grab a person. Mary is a girl, and Janey taught me: a girl is a person." """
    chain, trouble = reply.question.chain, reply.trouble
    about = reply.question.about if chain is None else next(chain.graphlets())
    if trouble is None:
        told = [f"yes, I may {asked_act(about)}"]
    else:
        first, *more = trouble_in_words(trouble, about)
        told = [f"{'no,' if forbidden(trouble) else 'yes, but'} {first}", *more]
    return both(lines(told))
