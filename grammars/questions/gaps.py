"""What is missing in a clause, put where it belongs: "which shelf did you put it on"."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.mentions import PLACES
from grammars.usage import particles


def fill(build: Build, act: str, thing: str, strand: str, asks: AList) -> None:
    """Put the thing where it is missing: as what the deed is done to, or behind the word left over at the end."""
    term = build.sketch.terms[act]
    if term.kind == "act" and not term.lex and not strand:
        build.sketch.link(act, "obj", thing)
        return
    has_object = any(role == "obj" for role, _ in term.links)
    verb = min(term.lex, default="")
    if f"{verb} {strand}" in particles() and not has_object:
        build.sketch.change(act, lex=frozenset((particles()[f"{verb} {strand}"][0],)))
        build.sketch.link(act, "obj", thing)
    elif strand == "to" and term.kind == "act":
        build.sketch.link(act, "dest", thing)
    elif strand:
        build.add("loc", PLACES.get(strand, strand), loc=act, wrt=thing)
    elif term.kind == "act" and not has_object:
        build.sketch.link(act, "obj", thing)
    else:
        raise NoMeaningError(str(asks))
