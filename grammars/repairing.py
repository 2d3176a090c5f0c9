"""What speakers put right as they speak: "turn left no right" is "turn right"."""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from typing import Final

from grammars.normalise import UNFINISHED, Piece, texts

# Categories whose words are put right one for one: "turn left no right". A verb takes all after it along.
REPAIRABLE: Final = ("DIR", "ADV", "UNIT", "ADJ", "NOUN", "PROPER", "VERB")
THANKING: Final = ("thanks", "thank")
COUNTING: Final = frozenset("there is are was were has have had with see means say".split())


def repaired_by_speaker(
    found: Sequence[Piece], sorts: Callable[[str], Container[str]] = lambda _: ()
) -> list[Piece]:
    """Self-repair carried out: "turn left i mean right" is "turn right", "five no six inches" is "6 inches".

    sorts: the categories of a word; the correction takes the place of what is of its sort.
    """
    said = texts(found)
    for marker in (
        ["no", "i", "mean"],
        ["sorry", ",", "i", "meant"],
        ["sorry", "i", "meant"],
        ["no", "sorry"],
        ["wait", "no"],
        ["i", "meant"],
        ["make", "that"],
        ["i", "mean"],
        ["no", "wait"],
        ["or", "rather"],
        ["sorry"],
        ["no"],
    ):
        for at in range(1, len(said) - len(marker)):
            if said[at : at + len(marker)] != marker:
                continue
            if marker == ["no"] and said[at - 1] in COUNTING:
                continue  # "there are no free lunches"
            if said[at + len(marker)] in THANKING:
                continue
            before = [piece for piece in found[:at] if piece.kind != "comma"]
            after = [piece for piece in found[at + len(marker) :] if piece.kind != "comma"]
            if marker == ["no"] and after and "VERBING" in sorts(after[0].text):
                continue  # "no shouting" forbids something
            return _put_right(before, after, sorts) if after else before
    return list(found)


def _put_right(
    before: list[Piece], after: list[Piece], sorts: Callable[[str], Container[str]]
) -> list[Piece]:
    """The correction in the place of the same word, else of a word of its sort, else of as many words; what followed a
    single word that was corrected stays."""
    new = after[0]
    is_deed = "VERB" in sorts(new.text)
    if is_deed and not any("VERB" in sorts(piece.text) for piece in before):
        return []  # there was no deed that could be put right
    sort = [name for name in REPAIRABLE if name in sorts(new.text)]
    if is_deed and len(after) > 1:
        sort = ["VERB"]
    same = [at for at, piece in enumerate(before) if piece.text == new.text]
    number = [at for at, piece in enumerate(before) if piece.kind == new.kind == "number"]
    told = [is_deed and piece.text in UNFINISHED for piece in before]  # "the lift" is none
    loose = [at for at in range(len(before)) if not any(told[at - 1 : at])]
    alike = [at for at in loose if any(name in sorts(before[at].text) for name in sort)]
    places = same or number or alike
    again = places[-1] if places else max(0, len(before) - len(after))
    back = [sorts(piece.text) for piece in before[again:]]
    if is_deed and any("VERBED" in one and not any(s in one for s in REPAIRABLE) for one in back):
        return []  # no order is taken back: "knock made mile no recite"
    stays = bool(places) and len(after) == 1 and sort != ["VERB"]
    return [*before[:again], *after, *(before[again + 1 :] if stays else ())]
