"""Finding lessons by words: those that a word concerns, or all that the net has every word for.

However many lessons share a word ("grab" in ten thousand prohibitions), a search never walks more of them than there
are words in mind.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import Generic, TypeVar

from kernel.net.node import Net

T = TypeVar("T", bound=Hashable)


class WordIndex(Generic[T]):
    """Items, each filed under its keys, and once more under the rarest of all the words it needs.

    An item without keys concerns everything.
    """

    def __init__(self) -> None:
        self._entries: dict[T, tuple[frozenset[str], frozenset[str], str]] = {}
        self._by_key: dict[str, dict[T, None]] = {}
        self._by_rarest: dict[str, dict[T, None]] = {}
        self._open: dict[T, None] = {}
        self._uses: dict[str, int] = {}

    def __len__(self) -> int:
        return len(self._entries)

    def add(self, item: T, keys: Iterable[str], words: Iterable[str]) -> None:
        """File an item. words: all of them have to be in the net for the item to be of any use."""
        keys, words = frozenset(keys), frozenset(words)
        rarest = min(words, key=lambda w: (self._uses.get(w, 0), -len(w), w), default="")
        self._entries[item] = keys, words, rarest
        for word in words:
            self._uses[word] = self._uses.get(word, 0) + 1
        for key in keys:
            self._by_key.setdefault(key, {})[item] = None
        if not keys:
            self._open[item] = None
        self._by_rarest.setdefault(rarest, {})[item] = None

    def remove(self, item: T) -> None:
        """Take an item out; one that is not filed is no matter."""
        if item not in self._entries:
            return
        keys, words, rarest = self._entries.pop(item)
        self._open.pop(item, None)
        for word in words:
            self._uses[word] -= 1
            if not self._uses[word]:
                del self._uses[word]
        for index, key in [(self._by_key, key) for key in keys] + [(self._by_rarest, rarest)]:
            del index[key][item]
            if not index[key]:
                del index[key]

    def possible(self, net: Net) -> list[T]:
        """Items all of whose words are in the net."""
        return self._with_words(self._by_presence(net), net)

    def concerned(self, words: Iterable[str], net: Net) -> list[T]:
        """Items filed under any of these words, and those without keys, all of whose words are in the net."""
        keys = sorted(word for word in words if word in self._by_key)
        if sum(len(self._by_key[key]) for key in keys) <= len(net.present_words()):
            found = [*self._open]
            for key in keys:
                found += self._by_key[key]
        else:
            wanted = frozenset(keys)
            found = [
                item
                for item in self._by_presence(net)
                if item in self._open or not wanted.isdisjoint(self._entries[item][0])
            ]
        return self._with_words(found, net)

    def _by_presence(self, net: Net) -> list[T]:
        """Items whose rarest word is in the net, found from the side that has fewer words."""
        found = [*self._by_rarest.get("", ())]
        present = net.present_words()
        here, there = self._by_rarest, present
        for word in here if len(here) < len(present) else there:
            if word and word in here and word in there:
                found += here[word]
        return found

    def _with_words(self, found: list[T], net: Net) -> list[T]:
        if len(found) > 1:
            found = list(dict.fromkeys(found))
        return [item for item in found if all(map(net.has_word, self._entries[item][1]))]
