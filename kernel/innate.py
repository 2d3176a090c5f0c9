"""What comes with the body and the mind, without words: skills and how failures are told."""

from __future__ import annotations

from kernel.action.call import GROUNDINGS
from kernel.action.chain import Directive, sequence
from kernel.complaining import TELLING_FAILURES
from kernel.memory.lesson import INNATE, Lesson, Operator
from kernel.net.graphlet import Sketch


def innate() -> list[Lesson]:
    """The operator DO[verb] -> FCN[name] of every grounding function, and that failures are told; numbered below zero,
    without words."""
    lessons: list[Lesson] = [Lesson(INNATE, "reaction", TELLING_FAILURES)]
    for grounding in sorted(GROUNDINGS.values(), key=lambda g: g.name):
        for verb in grounding.verbs:
            sketch = Sketch()
            act = sketch.add("act", verb)
            function = sketch.add("fcn", grounding.name, arg=act)
            operator = Operator(
                Directive("DO", sketch.graphlet(act)),
                sequence(Directive("FCN", sketch.graphlet(function))),
            )
            lessons.append(Lesson(INNATE - len(lessons), "procedure", operator))
    return lessons
