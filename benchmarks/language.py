"""Cost of understanding: medians of parse and build by length, of refusing, of starting; CPU time of one core.

python benchmarks/language.py
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from statistics import median

from daemon.understanding import warm_up
from grammars.earley import grammar
from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.vocabulary import BORN, Vocabulary

BY_LENGTH = {
    5: (
        "turn left then back up",
        "grab the big red block",
        "never lift a wooden cup",
        "drive forward very slowly please",
        "the red block is heavy",
    ),
    10: (
        "if something is very close then back up two inches",
        "to shimmy turn left then turn right then turn left",
        "grab the red block next to the wall then stop",
        "you should never grab a person but instead say sorry",
        "before you lift the small cup open the gripper slowly",
    ),
    20: (
        "open the gripper then drive forward ten inches then close it then raise the lift then turn slowly around",
        "if something is very close and it is a person then back up two inches then say pardon me quite slowly",
        "to deliver something drive to the small table next to the wall then lower the lift then release it slowly",
    ),
}
REFUSED = (
    "then the if of slowly block the",
    "if interest rates fall the bank will lower its forecast",
    "that was the shipping forecast and now the news at one",
    "in four hundred yards turn left onto the high street then take the motorway",
    "block forward until never drive who",
)
ROUNDS = 15


def near_misses() -> list[str]:
    """Sentences with a word misspelt and one too many: of these most is tried."""
    said = [text for sentences in BY_LENGTH.values() for text in sentences]
    misspelt = [f"{text[:-2]}{text[-1]}{text[-2]} the" for text in said]
    return [*misspelt, *(text.replace("e", "", 1) + " block" for text in said)]


def cost_ms(action: Callable[[], object]) -> float:
    """CPU time of one call, ms."""
    began = time.process_time()
    action()
    return (time.process_time() - began) * 1000


def read(text: str, vocabulary: Vocabulary = BORN) -> None:
    """Parse, whatever comes of it."""
    with suppress(NotUnderstoodError):
        parse(text, vocabulary)


def many_words(count: int) -> Vocabulary:
    """The born vocabulary with that many more nouns."""
    return Vocabulary(BORN.born, {f"thing{at}": {"NOUN": f"thing{at}"} for at in range(count)})


def main() -> None:
    """Print the table."""
    code = "from grammars.earley import grammar; grammar()"
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", code], check=True)
    print(
        f"interpreter, import and warm-up     {(time.perf_counter() - began) * 1000:8.0f} ms wall"
    )
    print(f"grammar alone                       {cost_ms(grammar):8.0f} ms")
    warm_up(BORN)
    for length, sentences in BY_LENGTH.items():
        first = [cost_ms(lambda text=text: parse(text)) for text in sentences]  # type: ignore[misc]
        again = [
            cost_ms(lambda text=text: parse(text))  # type: ignore[misc]
            for _ in range(ROUNDS)
            for text in sentences
        ]
        print(
            f"{length:2d} words, median (worst first time) {median(again):8.1f} ms ({max(first):.1f} ms)"
        )
    for name, texts in (("refused", REFUSED), ("near misses", near_misses())):
        cost = sorted(
            cost_ms(lambda text=text: read(text)) for _ in range(ROUNDS) for text in texts
        )  # type: ignore[misc]
        p99, worst = cost[len(cost) * 99 // 100], cost[-1]
        print(
            f"{name + ', median, p99 (worst)':36s}{median(cost):8.1f} ms {p99:.1f} ms ({worst:.1f} ms)"
        )
    large = many_words(20_000)
    read(BY_LENGTH[10][0], large)
    sized = [cost_ms(lambda: parse(BY_LENGTH[10][0], large)) for _ in range(ROUNDS)]
    plain = [cost_ms(lambda: parse(BY_LENGTH[10][0])) for _ in range(ROUNDS)]
    print(f"one sentence, born vocabulary       {median(plain):8.1f} ms")
    print(f"the same with 20,000 words more     {median(sized):8.1f} ms")


if __name__ == "__main__":
    main()
