"""Commands: do it now."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.chains import bare_chain
from grammars.mentions import is_definite
from grammars.registry import sentence_form
from grammars.ways import is_way
from kernel.action.chain import Chain
from kernel.memory.meaning import Command

EXAMPLES = (
    "drive forward",
    "go to the kitchen",
    "pick up the block",
    "could you back up a little please",
    "would you mind turning to the left",
    "turn left twice",
    "grab the block, then back up",
    "drive forward and turn right",
    "say hello three times",
    "turn left while saying excuse me",
    "grab the block that is not blue",
    "find out whether something is close",
    "check whether the gripper is empty then drive forward",
    "find out what color the block is",
    "find out what is near",
    "repeat turn left then turn right three times",
    "drive forward until something is very close",
    "turn left while the gripper is empty",
    "while the gripper is empty, turn left",
    "keep turning left",
    "turn left twice then right",
    "keep backing up until nothing is close",
    "grab each blue block",
    "for every block grab it then release it",
    "make sure the gripper is closed",
    "keep the gripper closed while driving forward",
    "wait until the light is green",
)


@sentence_form("command", "command", EXAMPLES)
def command(alist: AList) -> Command:
    """A chain to be run at once. "Ask your doctor" is said to persons; a lesson may have such a step."""
    if any(part.name == "speech" and _is_advice(part) for part in alist.walk()):
        raise NoMeaningError("advice for a person")
    if any(part.value == "think" for part in alist.walk() if part.name == "act"):
        raise NoMeaningError("stop and think")
    build = Build()
    if (wished_for := alist.find("wished_for")) is not None:
        np, act = wished_for.parts
        wanted = AList("play", (AList("action", (act, np)),))
        return Command(build.chain(AList("chain", (wanted,))))
    bare = alist.find("bare")
    if bare is not None and not is_way(bare):
        raise NoMeaningError("no way to go")
    if (topic := alist.find("topic")) is not None:
        return Command(_upon(build, topic, alist.first("chain")))
    return Command(build.chain(alist.first("chain") if bare is None else bare_chain(bare)))


def _upon(build: Build, topic: AList, chain: AList) -> Chain:
    """What is done to what was named first: "the red cup, pick it up"."""
    np = AList("np", topic.parts)
    if not is_definite(np):
        raise NoMeaningError(str(topic))
    with build.drawing(pattern=False):
        name = build.thing(np)
    made = build.chain(chain)
    if not any(
        name in d.graphlet.mentioned for d in made.directives() if d.graphlet and d.tag != "FIND"
    ):
        raise NoMeaningError(str(topic))
    return made


def _is_advice(speech: AList) -> bool:
    """Nothing is to be asked, and of nobody by name."""
    listener = speech.find("listener")
    return not speech.has("quote") and listener is not None and not listener.has("name")
