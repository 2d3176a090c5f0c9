"""What two are to each other: "Kim and Rosa are friends" is "Kim is Rosa's friend and Rosa is Kim's friend"."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.sorts import classes

MYSELF: Final = ("i", "me")
WHOSE: Final = {"i": "my", "me": "my", "you": "your"}
PLURAL: Final = ("akos",)


def of_each(said: AList) -> list[AList]:
    """The same clause with each of several things: "Ann and Bob are tall"."""
    if (both := said.find("both_of", "several_np")) is None:
        return [said]
    if told := each_other(said, both.all("np")):
        return told
    at = said.parts.index(both)
    return [AList("clause", (*said.parts[:at], np, *said.parts[at + 1 :])) for np in both.all("np")]


def each_other(said: AList, subjects: list[AList]) -> list[AList]:
    """The predicate as it is told of each, that is no speaker's own; none where it is nothing they are to each other.

    Args:
        said: bracket with the predicate.
        subjects: noun phrases of those it is told of.
    """
    pred = said.find("pred")
    kindof = None if pred is None else pred.find("kindof")
    if pred is None or kindof is None or len(subjects) != 2 or not _is_mutual(kindof):
        return []
    rest = tuple(part for part in said if part.name not in ("both_of", "pred"))
    told = []
    for one, other in (subjects, subjects[::-1]):
        if one.slot("pron") not in MYSELF:
            told.append(AList(said.name, (one, *rest, AList("pred", (_whose(kindof, other),)))))
    return told


def _is_mutual(kindof: AList) -> bool:
    return kindof.slot("akos") in classes()["mutual"] and not kindof.has("owner")


def _whose(kindof: AList, other: AList) -> AList:
    """The kind as one is it to the other: "Rosa's friend", "my friend"."""
    pron = other.slot("pron")
    whose = AList("own", value=WHOSE[pron]) if pron in WHOSE else AList("owner", other.parts)
    of_kind = (AList("ako", value=p.value) if p.name in PLURAL else p for p in kindof)
    return AList("kindof", (whose, *of_kind))
