"""The association list: slots, values and constituent brackets of a sentence, as in the paper's figure.

    proc( pref=could trig( act=cha-cha ) chain( play( action( act=drive dir=forward ) ) ... ) )

Source: Connell 2019, section 4.1: "digested into an association list consisting of a number of slots and values,
along with constituent bracketing, by walking the tree and retaining selected nodes".
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class AList:
    """A bracket: named, with slots and inner brackets in reading order.

    Attributes:
        name: of the grammar rule.
        parts: slots and brackets.
        value: of a slot; None for a bracket.
    """

    name: str
    parts: tuple[AList, ...] = ()
    value: str | None = None

    def __iter__(self) -> Iterator[AList]:
        return iter(self.parts)

    def __str__(self) -> str:
        if self.value is not None:
            return f"{self.name}={self.value}"
        return (
            f"{self.name}( {' '.join(map(str, self.parts))} )" if self.parts else f"{self.name}()"
        )

    def all(self, *names: str) -> list[AList]:
        """Direct parts of these names."""
        return [part for part in self.parts if part.name in names]

    def find(self, *names: str) -> AList | None:
        """First direct part of these names."""
        return next((part for part in self.parts if part.name in names), None)

    def first(self, *names: str) -> AList:
        """First direct part of these names.

        Raises:
            KeyError: there is none; the grammar and its builder disagree.
        """
        part = self.find(*names)
        if part is None:
            raise KeyError(f"{names} in {self}")
        return part

    def slot(self, name: str, default: str = "") -> str:
        """Value of the first slot of that name."""
        part = self.find(name)
        return default if part is None or part.value is None else part.value

    def has(self, name: str) -> bool:
        """There is a direct part of that name."""
        return self.find(name) is not None

    def walk(self) -> Iterator[AList]:
        """This bracket and all inner ones, in reading order."""
        yield self
        for part in self.parts:
            yield from part.walk()
