"""From an utterance to its meaning; and the words that stop the robot before anything is understood."""

from __future__ import annotations

import gc
import threading
from dataclasses import dataclass, replace
from typing import Final

from grammars.asking import AskWord
from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.render import render
from grammars.vocabulary import Vocabulary
from kernel.memory.meaning import Command, Control, Feedback, Heard, Meaning, Revision, Utterance
from kernel.memory.reply import AskKeep, AskWhich

STOP_WORDS: Final = frozenset({"stop", "halt", "freeze"})
BESIDE_STOP: Final = frozenset({"robot", "sayso", "please", "now", "hey"})


def _said(text: str) -> list[str]:
    """The words, the robot's name and manners aside."""
    words = "".join(c if c.isalpha() or c == "'" else " " for c in text.lower()).split()
    return [word for word in words if word not in BESIDE_STOP]


def is_stop(text: str) -> bool:
    """It begins with a stop word, the robot's name and manners aside.

    Whatever follows and whether it is understood: "stop it right now" stops too, before it is parsed.

    >>> is_stop("Robot, stop it!"), is_stop("to stop say hi")
    (True, False)
    """
    return next(iter(_said(text)), "") in STOP_WORDS


NO_ACTIVITY: Final = frozenset({"everything", "anything", "something", "nothing", "thing"})
FEW_WORDS: Final = 8


def names_activity(text: str) -> bool:
    """It begins as "stop turning" does, so that it may be meant to halt one activity alone.

    Only such a text waits for the parser before STOP is sent, a few milliseconds, as only by its meaning it is known
    whether the rest may go on; unless it is then fully understood as that, STOP is sent all the same. Every other text
    that begins with a stop word stops the robot before it is parsed. In spoken words the stop word alone stops it, as
    soon as it is heard (hearing/stop_spotter.py): what follows comes too late to be waited for.

    >>> names_activity("stop turning"), names_activity("stop everything"), names_activity("stop now")
    (True, False, False)
    """
    said = [word for word in _said(text) if word not in ("the", "all")]
    if len(said) < 2 or len(said) > FEW_WORDS or said[0] not in STOP_WORDS:
        return False
    return said[1].endswith("ing") and said[1] not in NO_ACTIVITY


SAY_AGAIN: Final = "Please say that again."
UNCLEAR: Final = {  # hearing's reason: what is shown, and whether the robot asks again
    "noise": ("I heard no words.", False),
    "unfinished": ("That broke off.", True),
    "outside": ("I did not understand.", False),
    "unsure": ("I am not sure that I heard that right.", True),
    "too_long": ("That was too long for me.", True),
    "fragment": ("That goes on from a lesson I have taken already.", False),
    "lost": ("My ears failed for a moment.", True),
}

# The compiled grammar keeps its place in the sentence while it parses.
_one_at_a_time = threading.Lock()


@dataclass(frozen=True, slots=True)
class Understanding:
    """What parsing made of an utterance: either heard, or the error that says what was understood.

    taught: a word that is now known to be something to do.
    """

    utterance: Utterance
    kind: str
    readback: str
    heard: Heard | None
    error: NotUnderstoodError | None = None
    taught: str = ""


def understand(
    utterance: Utterance,
    vocabulary: Vocabulary,
    expecting: AskWhich | AskKeep | AskWord | None = None,
) -> Understanding:
    """Parse it. Hearing has chosen among its alternatives before. May run in any thread.

    expecting: the robot's open question.
    """
    try:
        with _one_at_a_time:
            parsed = parse(utterance.text, vocabulary, expecting)
    except NotUnderstoodError as error:
        return Understanding(utterance, "not_understood", "", None, error)
    readback = render(parsed.meaning, "teacher")
    heard = Heard(replace(utterance, text=parsed.text), parsed.meaning)
    return Understanding(utterance, parsed.kind, readback, heard, taught=parsed.taught)


def warm_up(vocabulary: Vocabulary) -> None:
    """Load what understanding and refusing need, once. What stays for good is left out of the collector's rounds: one
    over all rules of the grammar takes longer than to refuse a sentence."""
    for text in ("stop", "grab teh flibbit slolwy zork"):
        understand(Utterance(text), vocabulary)
    gc.collect()
    gc.freeze()


def forgetting(numbers: tuple[int, ...], speaker: str, at_s: float) -> Understanding:
    """Lessons are to be taken back by their numbers: a meaning that no sentence has."""
    listed = ", ".join(map(str, numbers))
    utterance = Utterance(f"forget {listed}", speaker, at_s)
    heard = Heard(utterance, Control("forget", lessons=numbers))
    readback = f"forget lesson{'s' if len(numbers) > 1 else ''} {listed}"
    return Understanding(utterance, "control", readback, heard)


def halts(meaning: Meaning) -> bool:
    """Everything is to stop: such a meaning does not wait for the mind."""
    if isinstance(meaning, Feedback):
        return meaning.stop
    return isinstance(meaning, Control) and meaning.act == "stop" and meaning.about is None


def halts_one(meaning: Meaning) -> bool:
    """One activity is to stop, "stop turning": the mind knows which one that is, and what may go on."""
    return isinstance(meaning, Control) and meaning.act == "stop" and meaning.about is not None


def at_once(text: str) -> bool:
    """Everything is to stop before the text is parsed."""
    return is_stop(text) and not names_activity(text)


def stops(understanding: Understanding) -> bool:
    """Everything is to stop, and that has not been seen to before it was parsed."""
    text, heard = understanding.utterance.text, understanding.heard
    if is_stop(text):
        return names_activity(text) and (heard is None or not halts_one(heard.meaning))
    return heard is not None and halts(heard.meaning)


def moves(meaning: Meaning) -> bool:
    """It may set the robot in motion by itself: an order, a correction of one, "go on", "repeat that"."""
    if isinstance(meaning, Control):
        return meaning.act in ("resume", "repeat")
    return isinstance(meaning, Command | Revision)
