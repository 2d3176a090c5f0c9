"""A lesson that contradicts another, or can never come to anything: what is to be done with it?"""

from __future__ import annotations

from typing import Final

from grammars.render import render
from grammars.render.things import literally
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.reply import AskKeep, Why

_NEVER: Final[dict[Why, str]] = {
    "both": "that can never happen as it asks for something and its opposite",
    "always_excepted": "that can never happen as its exception always holds",
    "only_itself": "that would never end",
}


@renders(AskKeep)
def ask_keep(reply: AskKeep) -> Said:
    """ "That contradicts "birds fly". Shall I keep both, replace it, or cancel?" """
    if reply.other is None:
        told, choice = _NEVER[reply.why], "Shall I keep it, or cancel?"
    else:
        told = f"that contradicts {literally(render(reply.other.content, 'robot'))}"
        choice = "Shall I keep both, replace it, or cancel?"
    return Said(f"{sentence(told)} {choice}", f"{aloud(told)} {choice}")
