"""The mind alone: making one, an idle tick, and the tick that takes a command to its first bid."""

from _timing import collect, report, timed

from grammars.knowledge import born
from grammars.parse import parse
from kernel.action.call import BodyState
from kernel.memory.exchange import Inputs
from kernel.memory.meaning import Heard, Utterance
from kernel.mind import Mind

TICK_S = 1 / 30
COMMANDS = ["drive forward", "turn left", "raise the lift", "say hello"]


def main() -> None:
    report("a mind with what it is born knowing", collect(lambda: Mind(born()), 20))

    mind, now_s = Mind(born()), 0.0

    def idle() -> None:
        nonlocal now_s
        now_s += TICK_S
        mind.tick(Inputs(now_s, BodyState(at_s=now_s)))

    idle()
    report("idle tick", collect(idle, 5000), "target < 0.2 ms")

    heard = [Heard(Utterance(text), parse(text).meaning) for text in COMMANDS]
    report(
        "tick that takes a command to its first bid", [to_first_bid(meant) for meant in heard * 25]
    )


def to_first_bid(meant: Heard) -> float:
    """The time of one tick of a fresh mind, ms."""
    mind = Mind(born())
    mind.tick(Inputs(0.0, BodyState()))
    return timed(lambda: mind.tick(Inputs(TICK_S, BodyState(at_s=TICK_S), (meant,))))


if __name__ == "__main__":
    main()
