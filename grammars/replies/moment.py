"""When something was done."""

from __future__ import annotations

from grammars.render import act_in_words
from grammars.render.moments import moment
from grammars.render.reasons import asked_act
from grammars.replies import Said, both, renders
from kernel.memory.explanation import Moment


@renders(Moment)
def when_done(reply: Moment) -> Said:
    """ "I turned left today at 14:05." """
    deed, asked = reply.deed, reply.asked
    if deed is None:
        return both(f"I did not {asked_act(reply.question.about)}")
    if deed.going_on:
        return both(f"I am {act_in_words(deed.act, (), 'gerund')} now")
    when = moment(deed.wall_s or 0.0, asked.at_s, asked.utc_offset_s)
    done = act_in_words(deed.act, (), "past")
    return both(f"I {done} {when}" if when else f"I {done}, but I don't know when")
