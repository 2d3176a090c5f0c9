"""A lesson that contradicts another, or can never come to anything: what is to be done with it?"""

from __future__ import annotations

from typing import Final

from grammars.render.reasons import taught
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.reply import AskKeep, Why

_NEVER: Final[dict[Why, str]] = {
    "both": "that can never happen as it asks for something and its opposite",
    "always_excepted": "that can never happen as its exception always holds",
    "only_itself": "that would never end",
    "denies_itself": "that contradicts itself",
    "nothing_new": "that says nothing new",
}


@renders(AskKeep)
def ask_keep(reply: AskKeep) -> Said:
    """ "That contradicts what Mary taught me: birds fly. Shall I keep both, replace it, or cancel?" """
    if reply.other is None:
        told, choice = _NEVER[reply.why], "Shall I keep it, or cancel?"
    else:
        told = f"that contradicts what {taught(reply.other)}"
        choice = "Shall I keep both, replace it, or cancel?"
    return Said(f"{sentence(told)} {choice}", f"{aloud(told)} {choice}")
