"""Chains of plays: the procedure part of an operator, and of a command.

Source: Connell 2019, section 3: a chain is plays one after another; a play is directives at the same time, all of
which must complete, and optional auxiliary ones that end when the required ones end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kernel.net.graphlet import Graphlet


@dataclass(frozen=True, slots=True)
class Directive:
    """A tag on a graphlet: DO[act-1 -lex- drive]. PUNT carries none.

    What is carried out is a file in kernel/directives; ANTE, POST and ALLOW are tags of triggers alone.
    """

    tag: str
    graphlet: Graphlet | None = None


@dataclass(frozen=True, slots=True)
class Play:
    """Directives (or whole chains, or loops) side by side.

    Attributes:
        required: all must succeed; one failing ends the others and the play.
        auxiliary: run beside the required ones and end with them.
    """

    required: tuple[Part, ...]
    auxiliary: tuple[Part, ...] = ()

    @property
    def only(self) -> Part | None:
        """Its one part; None where there are several."""
        return self.required[0] if len(self.required) == 1 and not self.auxiliary else None

    @property
    def find(self) -> Directive | None:
        """The FIND that is its one part; None for every other play."""
        return self.only if isinstance(self.only, Directive) and self.only.tag == "FIND" else None


@dataclass(frozen=True, slots=True)
class Chain:
    """Plays one after another."""

    plays: tuple[Play, ...] = ()

    def directives(self) -> Iterator[Directive]:
        """Every directive in reading order, however deep."""
        for play in self.plays:
            for part in (*play.required, *play.auxiliary):
                if isinstance(part, Directive):
                    yield part
                else:
                    yield from part.directives()

    def tagged(self, tag: str) -> list[Graphlet]:
        """Graphlets of the directives with that tag, in reading order, however deep."""
        return [d.graphlet for d in self.directives() if d.tag == tag and d.graphlet is not None]

    def graphlets(self) -> Iterator[Graphlet]:
        """Every graphlet in reading order, however deep: those of directives, and what loops ask for."""
        for play in self.plays:
            for part in (*play.required, *play.auxiliary):
                if not isinstance(part, Directive):
                    yield from part.graphlets()
                elif part.graphlet is not None:
                    yield part.graphlet

    def finds_first(self) -> Chain:
        """With every FIND beside other things in a play before these, so that their failure goes back to it (ours)."""
        plays: list[Play] = []
        for play in self.plays:
            finds = [p for p in play.required if isinstance(p, Directive) and p.tag == "FIND"]
            plays += [Play((find,)) for find in finds]
            others = tuple(part for part in play.required if part not in finds)
            if others or play.auxiliary:
                plays.append(Play(others, play.auxiliary))
        return Chain(tuple(plays))

    @property
    def parallel(self) -> bool:
        """True where some play holds two things at once."""
        return any(
            len(play.required) + len(play.auxiliary) > 1
            or any(
                not isinstance(part, Directive) and part.parallel
                for part in (*play.required, *play.auxiliary)
            )
            for play in self.plays
        )


@dataclass(frozen=True, slots=True)
class Loop:
    """A chain that is run again and again (mind.md: "chains may loop"; how a loop is written is ours).

    Attributes:
        body: what is repeated.
        times: so often, or None; with each, for so many of them at most.
        until: it ends, and succeeds, as soon as this is so, even in the middle of the body.
        whilst: the same as soon as this is not so: false or unknown.
        each: once for each known thing of this description, its main name bound to the thing.

    Without any of these it goes on until it is stopped.
    """

    body: Chain
    times: int | None = None
    until: Graphlet | None = None
    whilst: Graphlet | None = None
    each: Graphlet | None = None

    def directives(self) -> Iterator[Directive]:
        """Those of the body."""
        return self.body.directives()

    def conditions(self) -> Iterator[Graphlet]:
        """What it asks for, in the order of writing."""
        return (graphlet for graphlet in (self.until, self.whilst, self.each) if graphlet)

    def graphlets(self) -> Iterator[Graphlet]:
        """What it asks for, then those of the body."""
        yield from self.conditions()
        yield from self.body.graphlets()

    @property
    def parallel(self) -> bool:
        """As the body."""
        return self.body.parallel


Part = Directive | Chain | Loop


def sequence(*parts: Part) -> Chain:
    """A chain of one-part plays."""
    return Chain(tuple(Play((part,)) for part in parts))
