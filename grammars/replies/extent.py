"""How far or how long something was done."""

from __future__ import annotations

from grammars.render import act_in_words
from grammars.render.deeds import amounts
from grammars.render.moments import lasting
from grammars.render.reasons import asked_act
from grammars.render.telling import Telling
from grammars.replies import Said, both, renders
from kernel.memory.experience import Deed
from kernel.memory.explanation import Extent


@renders(Extent)
def extent(reply: Extent) -> Said:
    """ "10 inches"; "4 seconds"."""
    deed, about = reply.deed, reply.question.about
    if deed is None:
        never = (
            "I don't know how long it takes to" if reply.question.topic == "takes" else "I did not"
        )
        return both(f"{never} {asked_act(about)}")
    if reply.question.topic != "extent" and deed.ended_s is not None:
        return both(lasting(deed.ended_s - deed.began_s))
    return both(_far(deed))


def _far(deed: Deed) -> str:
    """As far as it was told to; where it was told no measure, what it did."""
    told = amounts(Telling((deed.act,)), deed.act.main)
    return " ".join(told) if told else f"I {act_in_words(deed.act, (), 'past')}"
