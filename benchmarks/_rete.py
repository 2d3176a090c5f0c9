"""The same inference in CLIPS (its Rete, by way of clipspy), for comparison.

Conclusions are logical: they go with their reasons, as ours do.
"""

import time
from functools import partial
from statistics import median

import _timing
from _lessons import FACTS, FIRING, SECOND, kind_of

try:
    import clips
except ImportError:  # the benchmark runs without it
    clips = None

timed = partial(_timing.timed, clock=time.thread_time)


def rules(size: int) -> list[str]:
    """The rules of `_lessons.lessons` as defrules."""
    firing = min(FIRING, size)
    second = min(SECOND, size - firing)
    made = [_rule(n, "") for n in range(firing)]
    made += [
        f"(defrule second{n} (logical (hq tall{n} ?x)) => (assert (hq happy{n} ?x)))"
        for n in range(second)
    ]
    return made + [_rule(n, "other") for n in range(size - len(made))]


def _rule(number: int, prefix: str) -> str:
    condition = f"(ako {prefix}kind{number} ?x)"
    if kind_of(number) == "join":
        condition += f" (hq {prefix}heavy{number} ?x)"
    elif kind_of(number) == "unless":
        condition += f" (not (hq {prefix}heavy{number} ?x))"
    name = f"rule-{prefix}{number}"
    return f"(defrule {name} (logical {condition}) => (assert (hq {prefix}tall{number} ?x)))"


def facts() -> list[str]:
    """The facts of `_lessons.tell`."""
    made = []
    for number in range(FIRING):
        made.append(f"(ako kind{number} thing{number})")
        word = f"heavy{number}" if kind_of(number) == "join" else f"heavy{number}x"
        made.append(f"(hq {word} thing{number})")
    assert len(made) == FACTS
    return made


class Clips:
    """An environment with the rules, and the facts in it."""

    def __init__(self, size: int) -> None:
        self.environment = clips.Environment()
        for text in rules(size):
            self.environment.build(text)
        self.texts = facts()
        self.scratch()

    def scratch(self) -> None:
        """Everything afresh."""
        self.environment.reset()
        self.facts = [self.environment.assert_string(text) for text in self.texts]
        self.environment.run()

    def times(self, repeats: int) -> dict[str, float]:
        """Medians, ms: from scratch, a fact removed, a fact added."""
        scratch = [timed(self.scratch) for _ in range(max(5, repeats // 10))]
        removed, added = [], []
        for number in range(repeats):
            index = 2 * (number * 7 % FIRING)
            removed.append(timed(lambda at=index: self._remove(at)))  # type: ignore[misc]
            added.append(timed(lambda at=index: self._add(at)))  # type: ignore[misc]
        return {"scratch": median(scratch), "remove": median(removed), "add": median(added)}

    def _remove(self, index: int) -> None:
        self.facts[index].retract()
        self.environment.run()

    def _add(self, index: int) -> None:
        self.facts[index] = self.environment.assert_string(self.texts[index])
        self.environment.run()


def cross(candidates: int) -> float:
    """Median ms of a join with so many candidates a side, all pairs of which fit."""
    environment = clips.Environment()
    environment.build(
        "(defrule pair (logical (ako girl ?x) (ako ball ?y)) => (assert (like ?x ?y)))"
    )

    def work() -> None:
        environment.reset()
        for number in range(candidates):
            environment.assert_string(f"(ako girl girl{number})")
            environment.assert_string(f"(ako ball ball{number})")
        environment.run()

    return median(timed(work) for _ in range(50))
