"""What is said, told or asked, into nets: quoted speech, who hears it, and in what voice."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import asked_if, is_addressed, is_person

if TYPE_CHECKING:
    from grammars.build import Build

UNQUOTED: Final = frozenset("it them that this at to from for along out".split())
VOICES: Final = {"loud": "loudly", "quiet": "quietly"}


def spoken(build: Build, speech: AList) -> str:
    """Node of the act of speaking."""
    verb = next(part.name for part in speech if part.name in ("say", "tell", "ask"))
    links: dict[str, str] = {}
    if (asked := asked_if(speech)) is not None:
        links["obj"] = build.add("txt", literal=f"if {asked.slot('quote')}")
    elif (quote := speech.find("quote")) is not None:
        if not is_addressed(verb, speech):
            raise NoMeaningError(str(speech))
        links["obj"] = build.add("txt", literal=quote.value or "")
    elif speech.has("any_words"):  # "never say anything"
        pass
    elif not is_person(asked := speech.first("listener")) and asked.slot("pron") != "me":
        raise NoMeaningError(str(speech))
    hearer = speech.find("hearer", "listener")
    if hearer is not None and hearer.parts:
        every = hearer.find("every")
        np = hearer.find("np") or hearer
        links["dest"] = build.thing(np, person=True) if every is None else build.every(every)
    if "dest" not in links and verb == "tell":  # "tell everyone dinner is ready"
        verb = "say"
    act = build.add("act", verb, **links)
    voices = speech.first("say", "tell", "ask").parts  # "shout", "whisper"
    if voices and speech.slot("quote").lower().partition(" ")[0] in UNQUOTED:
        raise NoMeaningError(str(speech))  # "shout it out" says no "it out"
    for voice in voices:
        if voice.name in VOICES:
            build.add("mod", VOICES[voice.name], mod=act)
    build.modifiers(act, speech)
    return act
