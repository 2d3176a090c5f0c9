"""Forms are found by file, and words of the body's abilities are words of the language."""

from __future__ import annotations

import importlib
import pkgutil

import kernel.grounding
from grammars.earley import closed_words
from grammars.registry import discover
from grammars.vocabulary import BORN
from kernel.action.call import GROUNDINGS


def test_every_form_is_listed_once_in_order() -> None:
    names = list(discover())
    assert names == sorted(names)
    assert {form.name for form in discover().values()} == set(names)


def test_every_verb_of_the_body_is_a_word() -> None:
    for module in pkgutil.iter_modules(kernel.grounding.__path__):
        importlib.import_module(f"kernel.grounding.{module.name}")
    words = {
        w for grounding in GROUNDINGS.values() for verb in grounding.verbs for w in verb.split()
    }
    assert words
    assert words <= {word for word in words if BORN.knows(word) or word in closed_words()}
