"""Several things fit equally well: which is meant?"""

from __future__ import annotations

from grammars.render import thing_in_words
from grammars.render.telling import SAYING
from grammars.replies import Said, aloud, listed, renders
from kernel.memory.reply import AskWhich
from kernel.net.graphlet import Graphlet, Term


@renders(AskWhich)
def ask_which(reply: AskWhich) -> Said:
    """ "Which block: the red one or the blue one?" """
    options = [_apart(option, reply) for option in reply.options]
    said = f"{_which(reply)}: {listed(options, 'or')}?"
    return Said(said, aloud(said))


def _which(reply: AskWhich) -> str:
    """ "Which red block": what was said of it."""
    said = thing_in_words(reply.wanted.main, (reply.wanted,))
    return f"Which {said.removeprefix('the ')}"


def _apart(option: Graphlet, reply: AskWhich) -> str:
    """A thing by what is not said of all of them."""
    main = option.term(option.main)
    if main.lex:
        return thing_in_words(main.name, (option,))
    shared = frozenset.intersection(*(frozenset(_sayings(other)) for other in reply.options))
    apart = [term for saying, term in _sayings(option).items() if saying not in shared]
    if not apart:
        return "the other one"
    others = [_sayings(other) for other in reply.options if other is not option]
    alone = [t for saying, t in _sayings(option).items() if not any(saying in o for o in others)]
    kept = _with_marks(option, alone[:1] or apart)
    one = Term(main.name, ref="one")
    return thing_in_words(main.name, (Graphlet((one, *kept), main.name),))


def _sayings(option: Graphlet) -> dict[tuple[str, ...], Term]:
    """What is said of the thing, by its words."""
    said = {}
    for term in option:
        role = next((r for r in SAYING if (r, option.main) in term.links), "")
        if role:
            degrees = (w for t in option if ("deg", term.name) in t.links for w in t.lex)
            landmarks = (o for r, o in term.links if r in ("wrt", "of", "than"))
            said[role, str(term.negated), *sorted(term.lex), *sorted(degrees), *landmarks] = term
    return said


def _with_marks(option: Graphlet, apart: list[Term]) -> list[Term]:
    """The terms with what they are told by: degrees, landmarks, owners."""
    kept = list(apart)
    for term in kept:
        near = {other for role, other in term.links if other != option.main}
        kept += [
            t
            for t in option
            if t not in kept
            and t.name != option.main
            and (t.name in near or any(other in {term.name, *near} for _, other in t.links))
            and ("ako", option.main) not in t.links
        ]
    return kept
