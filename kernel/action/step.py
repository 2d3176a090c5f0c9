"""Directives as generators: `yield` means "not done this tick", `return` gives the verdict."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from typing import Final, Literal, Protocol

from kernel.action.verdict import Verdict

Run = Generator[None, None, Verdict]
StepReason = Literal[
    "no_way", "given_up", "prohibited", "nothing_found", "not_so", "not_known", "not_achieved"
]


class Advice(Protocol):
    """An operator with the binding under which it applies; opaque to directives."""


class Step(Protocol):
    """One directive being carried out, as a directive's code sees it; the mind implements it."""

    def operators(self, tag: str) -> Iterator[Advice]:
        """Applicable operators of this tag, chosen one by one by weight, none twice."""

    def desperate(self) -> bool:
        """Lower the belief threshold for this step; False if it was lowered already."""

    def run(self, advice: Advice) -> Run:
        """Run an operator's chain."""

    def pursue(self, advice: Advice) -> Run:
        """Run an operator's chain, and end it as soon as the condition is so."""

    def is_so(self) -> bool:
        """Whether the condition of this step is so now."""

    def waits(self, what: str) -> None:
        """Name what it waits for, before every yield."""

    def pause(self, seconds: float) -> Run:
        """Let time pass."""

    def complain(self, reason: StepReason) -> None:
        """Say why, once, without failing."""

    @property
    def avoids(self) -> bool:
        """What is wanted is that the robot does something not."""

    def halt(self) -> None:
        """End every act that matches the graphlet, or that is to be avoided, in whatever is going on."""

    def truth(self) -> bool | None:
        """Whether memory holds the graphlet (True), its denial (False), or neither."""

    def look_up(self) -> Run:
        """Bind the main node to the next thing that fits, or assume one where that is allowed."""

    def call(self) -> Run:
        """Call the grounding function that the FCN node names, on the node its arg points to."""

    def learn(self) -> Run:
        """Make the lesson at hand durable, then put it in force."""

    def revise(self) -> Run:
        """Make the change at hand durable, then let it take effect."""

    def excuse(self) -> bool:
        """Give the explanation of the failure at hand; False where there is none."""

    def seeking(self) -> str:
        """Tag of the operators that may find the answer to the question at hand, "" where memory has it."""

    def answer(self) -> None:
        """Reply to the question at hand from memory."""

    def set_about(self) -> None:
        """The action begins, and nothing forbids it: a fact to whoever was told what to do "when you turn left"."""

    def times(self) -> int:
        """How often the action is to be done: "twice" is 2."""

    def explain(self, reason: StepReason) -> None:
        """Say why this step fails, unless something below it has said so already."""


def break_off(run: Run, over: Callable[[], bool]) -> Run:
    """Run it, and end it, succeeding, as soon as `over` says so: in that very tick, before it gets its turn, and after
    its turn, where it has made it so itself."""
    try:
        while not over():
            try:
                next(run)
            except StopIteration as end:
                verdict: Verdict = end.value
                return verdict
            if over():
                break
            yield
    finally:
        run.close()
    return Verdict.SUCCEEDED


DirectiveCode = Callable[[Step], Run]
DIRECTIVES: Final[dict[str, DirectiveCode]] = {}


def directive(tag: str) -> Callable[[DirectiveCode], DirectiveCode]:
    """Register the code of a directive under its tag.

    Raises:
        ValueError: the tag is taken.
    """

    def register(code: DirectiveCode) -> DirectiveCode:
        if tag in DIRECTIVES:
            raise ValueError(f"directive {tag} is registered twice")
        DIRECTIVES[tag] = code
        return code

    return register
