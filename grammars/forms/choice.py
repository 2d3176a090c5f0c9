"""Which one is meant: understood only while the robot asks that."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build
from grammars.registry import sentence_form
from kernel.memory.meaning import Choice

EXAMPLES = ("the red one", "the red block", "red", "the one on the left")


@sentence_form("choice", "answer", EXAMPLES, expected=True)
def choice(alist: AList) -> Choice:
    """The description of one thing."""
    build = Build()
    with build.drawing(pattern=True):
        if (np := alist.find("np")) is not None:
            return Choice(build.graphlet(build.thing(_of_any_kind(np))))
        name = build.add("obj", ref="one")
        build.quality(name, alist.first("qual"))
        return Choice(build.graphlet(name))


def _of_any_kind(np: AList) -> AList:
    """ "One" is no kind here: "the red one" is red, whatever it is."""
    parts = (AList("one") if p.name == "ako" and p.value == "one" else p for p in np)
    return AList(np.name, tuple(parts), np.value)
