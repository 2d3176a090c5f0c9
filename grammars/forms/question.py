"""Questions: what is asked, the net it is about, and the node that is wanted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.dates import day_asked
from grammars.questions import either, occasions, reasons, things, topics, wanted, whether
from grammars.registry import sentence_form
from grammars.sorts import is_kin_of_yours
from kernel.memory.meaning import Question

EXAMPLES = (
    "what is in front of you",
    "who is mary",
    "Where is the biggest block?",
    "which block is heavy",
    "are you holding a block",
    "did you turn left",
    "how many red blocks are there",
    "How many times did you turn?",
    "Why didn't you grab Mary?",
    "what are you doing",
    "what did you just do",
    "what do you know about mary",
    "Do you know how to dance?",
    "how do you cha-cha",
    "who taught you to dance",
    "Who told you that Mary is a girl?",
    "why not",
    "why is mary a person",
    "when did you turn left",
    "when did you learn to dance",
    "who told you not to grab mary",
    "are you allowed to grab mary",
    "what are you not allowed to do",
    "what happens when something is close",
    "what happens before you turn left",
    "what do you do after you turn left",
    "what would you do if I said turn left then grab the block",
    "what would you do if I said turn left while the gripper is empty",
    "what would you do if I said grab each blue block",
    "show me what you would do if something is very close",
    "which cup did Freddy tell you to lift",
    "did Mary tell you to turn left",
    "what are you afraid of",
    "where are you going",
    "how far did you drive",
    "how long did you wait",
    "when do you say hello",
    "do you dance when I sing",
    "are you allowed to touch the vase when nobody is watching",
    "is the gripper open or closed",
    "did you turn left or right",
    "is the cup red or is it blue",
    "does Lily know how to swim",
    "do you need a rest",
    "do you always do what Ben says",
    "you know what a cup is, don't you",
    "remind me where the cup is",
    "what are you not allowed to touch",
    "I wonder who may tell you to turn left",
)
# What stands before the question itself.
BEFORE: Final = ("roughly", "told_me")


@sentence_form("question", "question", EXAMPLES)
def question(alist: AList) -> Question:
    """The question; everything described is in the one net it is about."""
    roughly = alist.slot("roughly")
    body = next(part for part in alist if part.name not in BEFORE)
    if any(map(_is_done_by_kin, body.walk())):
        raise NoMeaningError("did your cousin call")
    build = Build()
    with build.drawing(pattern=True):
        asked = SO[body.name](build, body) if body.name in SO else topics.of_topic(build, body)
        if roughly and not topics.may_be_about(asked.ask, roughly):
            raise NoMeaningError(roughly)
        if asked.topic == "occasion" and alist.has("told_me"):
            raise NoMeaningError("let me know when you get there")
        if (occasion := alist.find("occasion")) is not None:
            return replace(asked, about=occasions.on_occasion(build, asked.about, body, occasion))
        return asked


def _is_done_by_kin(part: AList) -> bool:
    """What their kin do, persons ask each other."""
    return part.find(*topics.DEEDS, "does_q") is not None and any(
        map(is_kin_of_yours, part.all("np"))
    )


SO: Final[dict[str, Callable[[Build, AList], Question]]] = {
    "what": things.what,
    "holding": things.holding,
    "color": things.color,
    "how_much": things.how_much,
    "who": things.who,
    "whose": things.whose,
    "where": things.where,
    "either": things.either,
    "yesno": whether.yesno,
    "howmany": wanted.howmany,
    "why": reasons.why,
    "what_for": reasons.what_for,
    "what_thinks": reasons.what_thinks,
    "how_known": reasons.how_known,
    "what_stops": reasons.what_stops,
    "seeing": whether.seeing,
    "how_is": things.how_is,
    "named_what": things.named,
    "which_is": things.which_is,
    "cleft": whether.cleft,
    "obeys": topics.obeys,
    "either_so": either.either_so,
    "same_thing": whether.same_thing,
    "which_way": things.which_way,
    "steps": topics.steps,
    "occasional": occasions.occasional,
    "since_told": occasions.since_told,
    "when_learned": topics.when_learned,
    "day_so": day_asked,
    "what_day": day_asked,
    "subject": wanted.subject,
    "wanted": wanted.wanted,
    "adverbial": wanted.adverbial,
    "fronted": wanted.fronted,
}
