"""Lessons by the thousand: the nets of taught sentences, each with words of its own.

Of `lessons(size)` 50 rules fire on the hundred facts of `tell`, and 25 more on what these conclude; all others are
about words that are not there, or have only the first of two conditions met.
"""

from dataclasses import replace

from grammars.parse import parse
from kernel.memory.lesson import Lesson, Rule
from kernel.memory.meaning import Fact, Teach
from kernel.memory.notation import mapped
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet
from kernel.net.node import Node

FACTS, FIRING, SECOND = 100, 50, 25
# The grammar has no rules with exceptions yet: the exception is the net of "it is red" in the same sentence.
SENTENCES = {
    "one": "if something is a girl it is tall",
    "join": "if something is a girl and it is heavy then it is tall",
    "unless": "if something is a girl and it is heavy then it is tall",
    "second": "if something is tall it is happy",
    "kind": "Mary is a girl",
    "quality": "Mary is heavy",
    "procedure": "to dance drive forward",
    "grab": "you should never grab a girl",
    "reaction": "if something is tall drive backwards",
}


def _meanings() -> dict[str, object]:
    found = {name: parse(sentence).meaning for name, sentence in SENTENCES.items()}
    rules = {n: m.content for n, m in found.items() if isinstance(m, Teach)}
    excepted = rules["unless"]
    assert isinstance(excepted, Rule)
    terms = excepted.condition.terms
    heavy = next(t for t in terms if "heavy" in t.lex)
    rules["unless"] = replace(
        excepted,
        condition=Graphlet(tuple(t for t in terms if t is not heavy), excepted.condition.main),
        unless=(Graphlet((heavy,), heavy.name),),
    )
    facts = {n: m.fact for n, m in found.items() if isinstance(m, Fact)}
    return {**rules, **facts}


def _reworded(graphlet: Graphlet, words: dict[str, str]) -> Graphlet:
    """The graphlet with these words in place of those."""
    terms = (replace(t, lex=frozenset(words.get(w, w) for w in t.lex)) for t in graphlet.terms)
    return Graphlet(tuple(terms), graphlet.main)


class Nets:
    """The nets of the sentences, parsed once."""

    def __init__(self) -> None:
        self._nets = _meanings()

    def make(self, name: str, **words: str) -> object:
        """A net with other words."""
        return mapped(self._nets[name], lambda graphlet: _reworded(graphlet, words))


NETS = Nets()


def kind_of(number: int) -> str:
    """Which sentence the rule with this number is made like."""
    if number % 5 == 3:
        return "join"
    return "unless" if number % 5 == 4 else "one"


def rule(ident: int, number: int, prefix: str = "") -> Lesson:
    words = {
        "girl": f"{prefix}kind{number}",
        "heavy": f"{prefix}heavy{number}",
        "tall": f"{prefix}tall{number}",
    }
    return Lesson(ident, "rule", NETS.make(kind_of(number), **words))  # type: ignore[arg-type]


def lessons(size: int) -> list[Lesson]:
    """So many rules and as many operators: procedures, prohibitions and reactions."""
    firing = min(FIRING, size)
    second = min(SECOND, size - firing)
    made = [rule(n + 1, n) for n in range(firing)]
    for n in range(second):
        content = NETS.make("second", tall=f"tall{n}", happy=f"happy{n}")
        made.append(Lesson(1000 + n, "rule", content))  # type: ignore[arg-type]
    made += [rule(2000 + n, n, "other") for n in range(size - len(made))]
    for n in range(size):
        name = ("procedure", "grab", "reaction")[n % 3]
        content = NETS.make(name, dance=f"verb{n}", girl=f"kind{n}x", tall=f"tall{n}x")
        made.append(Lesson(100_000 + n, "procedure", content))  # type: ignore[arg-type]
    return made


def tell(memory: WorkingMemory) -> list[tuple[Graphlet, Node]]:
    """A hundred facts about things that are in mind; what was told, to be told again."""
    told: list[tuple[Graphlet, Node]] = []
    for number in range(FIRING):
        thing = memory.net.new("obj", f"thing{number}")
        memory.net.link(memory.me, "near", thing)
        told.append((NETS.make("kind", girl=f"kind{number}"), thing))  # type: ignore[arg-type]
        # What a join needs, and what an exception of another rule would be.
        word = f"heavy{number}" if kind_of(number) == "join" else f"heavy{number}x"
        told.append((NETS.make("quality", heavy=word), thing))  # type: ignore[arg-type]
    for fact, thing in told:
        say(memory, fact, thing)
    memory.refresh()
    return told


def say(memory: WorkingMemory, fact: Graphlet, thing: Node) -> Node:
    """Tell a fact about a thing; its main node."""
    (name,) = fact.mentioned - fact.names
    return memory.tell(fact, {name: thing})[1][0]
