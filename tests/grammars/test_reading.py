"""What is tried upon one sentence is bounded."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from grammars import parse as parsing
from grammars.errors import BrokenOffError, NotUnderstoodError
from grammars.lattice import Lexer, Token
from grammars.normalise import pieces
from grammars.reading import Attempts
from grammars.vocabulary import BORN


def tokens(text: str) -> list[Token]:
    return Lexer(BORN, parsing.grammar().literal).tokens(pieces(text), False)


def attempts() -> tuple[Attempts, list[str]]:
    """Attempts, and the sentences that were really read."""
    read: list[str] = []

    def derive(said: Sequence[Token]) -> object:
        read.append(" ".join(token.piece.text for token in said))
        return parsing.grammar().forest(said)

    return Attempts(derive), read


def test_what_broke_off_once_is_not_read_again() -> None:
    tried, read = attempts()
    for text in ("grab the cup zork now", "grab the cup zork at the wall"):
        with pytest.raises(BrokenOffError) as caught:
            tried.forest(tokens(text))
        assert caught.value.at == 3
    tried.forest(tokens("grab the cup now"))
    assert read == ["grab the cup zork now", "grab the cup now"]


def test_a_sentence_that_ended_too_soon_may_go_on() -> None:
    tried, read = attempts()
    for _ in range(2):
        with pytest.raises(BrokenOffError):
            tried.forest(tokens("push the"))
    tried.forest(tokens("push the ball"))
    assert read == ["push the", "push the ball"]


@pytest.mark.parametrize(
    "text",
    [
        "back up if anything gets too clokse am",
        "lift the biggest block thein cups are sometimes fragile",
        "turn lef then push tha bal and gra the cu then turn right never",
        "grab the cp if thy are clse to yu or the wal is no near yu the",
    ],
)
def test_few_words_are_read_of_what_is_refused(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[Attempts] = []
    monkeypatch.setattr(
        parsing, "Attempts", lambda derive: made.append(Attempts(derive)) or made[0]
    )
    with pytest.raises(NotUnderstoodError):
        parsing.parse(text)
    assert made[0].words <= parsing.MOST_READ + 2 * len(text.split())
