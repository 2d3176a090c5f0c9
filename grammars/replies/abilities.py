"""What the robot can do."""

from __future__ import annotations

from typing import Final

from grammars.render import act_in_words
from grammars.replies import Said, both, listed, renders
from kernel.memory.explanation import Abilities

MOST: Final = 5
_SAID: Final = {"say": "speak"}  # "say" wants to be told what


@renders(Abilities)
def abilities(reply: Abilities) -> Said:
    """ "I can drive, turn and speak, and I was taught to dance." """
    said = f"I can {listed([_SAID.get(verb, verb) for verb in reply.born])}"
    if reply.taught:
        acts = [act_in_words(act) for act in reply.taught[:MOST]]
        more = len(reply.taught) - MOST
        said += (
            f", and I was taught to {listed([*acts, f'{more} things more'] if more > 0 else acts)}"
        )
    return both(said)
