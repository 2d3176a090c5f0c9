"""What the recognisers are told may be said."""

from __future__ import annotations

import json
import random
from functools import cache
from importlib.resources import files
from itertools import pairwise

import pytest

from grammars.automaton import sample
from grammars.chains import TURNING
from grammars.chatter import is_chatter
from grammars.finite_state import Compiler, expand
from grammars.heard import (
    COMPILED,
    automaton,
    compile_heard,
    heard_rules,
    parser_rules,
    phrases,
    said,
    skeleton,
    spoken_words,
    stand_ins,
)
from grammars.normalise import pieces
from grammars.parse import parse
from grammars.registry import Form, discover
from grammars.vocabulary import BORN, Vocabulary

DEMONSTRATION = """drive forward
to cha-cha drive forward then drive backwards
to shimmy turn left then turn right
to dance cha-cha then shimmy
please dance
if something is very close then drive backwards
you should never grab a person but instead say i'm not allowed to
if something is a girl it is a person
mary is a girl
grab the block
grab mary
turn means rotate
widdershins means counterclockwise
to turn widdershins turn counterclockwise
if rick tells you to do something don't but instead complain
to complain say i don't take orders from you
i am rick
turn left
stop""".splitlines()
MANAGING = """repeat turn left then turn right three times
to patrol drive forward until something is close then turn around
keep turning left
make sure the gripper is closed
find out whether something is close
wait until the gripper is open
undo everything from today
forget that
why didn't you turn left
how many times did you turn left
what would you do if i said dance then turn left
no drive backwards instead of turning left
if you fail to grab the block say sorry
the red one""".splitlines()
CONSTRUCTIONS = [
    tuple(row.split(": "))
    for row in """permission: it is okay to lift the cup
permission: you can grab a person if bob is hurt
trust: never turn left when mary tells you to
trust: never learn anything from joe
trust: you may take orders from alice
finding: to find out whether a box is heavy lift the box
finding: to know whether something is open look
finding: to find out where bob is look around
procedure: to make sure the door is closed push the door
procedure: to make the door open pull it
procedure: to patrol means to drive forward then turn around
reaction: when you are stuck turn left
reaction: if you can not do something say sorry
before: always say excuse me before you turn left
before: before turning left say sorry
after: after turning left raise the lift
revision: not the red one the blue one
revision: not the red block the blue cup
revision: turn right instead of turning left
question: how many red cups are there
question: why is the red block heavy
question: when did you grab bob
question: are you allowed to drive forward
question: what do you do before you turn left
fact: his name is bob
fact: there is something very close
rule: cups are usually light
rule: a red thing is dangerous
control: forget everything about the red block
control: forget that mary is a girl
identity: it is me bob
feedback: hey stop that
command: would you mind turning left
command: find out where the ball is""".splitlines()
]
TAUGHT = Vocabulary(
    BORN.born,
    {
        "zork": {"VERB": "zork"},
        "blick": {"NOUN": "blick"},
        "blicks": {"NOUNS": "blick"},
        "mauve": {"ADJ": "mauve"},
        "pookie": {"PROPER": "pookie"},
        "widdershins": {"DIR": "widdershins"},
    },
)
FORMS = [form for form in discover().values() if not form.expected]
SAID_EITHER_WAY = {
    "command": {"control", "feedback"},
    "prohibition": {"control"},
    "revision": {"reaction"},
}
"""To stop is something to do, and what ends what is done. To "put it first" is as well."""
TYPED_ONLY = {
    "Let me teach you to stretch: raise the lift, wait one second, then lower it.",
}
"""Examples that mean something only with their commas, which nobody hears."""


@pytest.mark.parametrize("sentence", DEMONSTRATION + MANAGING)
def test_the_demonstration_and_what_manages_it_may_be_said(sentence: str) -> None:
    assert automaton(BORN).accepts(sentence.split())


@pytest.mark.parametrize(
    "sentence", ["drive", "grab the", "forward the then", "", "to", "two large pizzas"]
)
def test_what_is_no_sentence_may_not_be_said(sentence: str) -> None:
    assert automaton(BORN).accepts(sentence.split()) is (sentence == "drive")


def test_sampling_is_repeatable() -> None:
    assert phrases(BORN, 20, seed=1) == phrases(BORN, 20, seed=1) != phrases(BORN, 20, seed=2)


def test_a_taught_word_may_be_said() -> None:
    taught = Vocabulary(
        BORN.born, {"widdershins": {"DIR": "widdershins"}, "zork": {"VERB": "zork"}}
    )
    assert automaton(taught).accepts("turn widdershins then zork the block".split())
    assert not automaton(BORN).accepts("zork the block".split())


def test_a_thousand_names_change_the_language_at_once() -> None:
    names = {f"name{number}": {"PROPER": f"name{number}"} for number in range(1000)}
    assert automaton(Vocabulary(BORN.born, names)).accepts("grab name999".split())
    assert skeleton().size < 2_100


@cache
def _compiler() -> Compiler:
    return Compiler(heard_rules())


@pytest.mark.parametrize("words", [BORN, TAUGHT], ids=["born", "taught"])
@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.name)
def test_what_may_be_said_is_read_as_its_form(form: Form, words: Vocabulary) -> None:
    """A rule of the ears that drifts from the parser's would be listened for in vain."""
    kinds = {form.kind} | SAID_EITHER_WAY.get(form.name, set())
    spoken, compiler = spoken_words(words), _compiler()
    for origin, symbols in heard_rules():
        if origin == form.name:
            rule = expand(compiler.sequence(symbols), spoken)
            for sentence in sample(rule, 2, random.Random(7)) if rule.arcs else ():
                if not _is_known_misreading(sentence):
                    assert parse(sentence, words).kind in kinds, sentence


@pytest.mark.parametrize("words", [BORN, TAUGHT], ids=["born", "taught"])
def test_whatever_may_be_said_parses(words: Vocabulary) -> None:
    answers = [
        expand(_compiler().compiled(name), spoken_words(words))
        for name in ("choice", "refusal", "_answer")
    ]
    for sentence in phrases(words, 200, seed=8):
        asked = any(answer.accepts(sentence.split()) for answer in answers)
        if not asked and not _is_known_misreading(sentence):
            parse(sentence, words)


@pytest.mark.parametrize("form", discover().values(), ids=lambda form: form.name)
def test_each_example_may_be_said(form: Form) -> None:
    language = automaton()
    for example in form.examples:
        assert language.accepts(said(example).split()) != (example in TYPED_ONLY), example


def test_other_things_and_words_may_be_said_in_an_example() -> None:
    """To "forget what I told you about Mary" is an example, these are not."""
    language = automaton(TAUGHT)
    for sentence in (
        "forget what i told you about the green cup",
        "please forget what i told you about pookie",
        "alice may tell you to zork the blick",
        "make sure the mauve blick is open",
    ):
        assert language.accepts(sentence.split()), sentence
        parse(sentence, TAUGHT)


def test_the_compiled_skeleton_is_fresh() -> None:
    """python scripts/compile_grammar.py"""
    kept = json.loads(files("grammars").joinpath(COMPILED).read_text("utf8"))
    assert kept == json.loads(json.dumps(compile_heard()))


@pytest.mark.parametrize(("form", "sentence"), CONSTRUCTIONS)
def test_each_construction_that_is_heard_is_accepted_and_parses(form: str, sentence: str) -> None:
    assert automaton(BORN).accepts(sentence.split())
    assert parse(sentence).kind == discover()[form].kind


def test_replaced_rules_name_rules_and_words_that_exist() -> None:
    """A rule renamed in the grammar would silently be heard no more."""
    own = list(stand_ins())
    known = {origin for origin, _ in (*parser_rules(), *own)} | {"_form"}
    for origin, symbols in own:
        for symbol in symbols:
            assert symbol.startswith('"') or symbol.isupper() or symbol in known, (origin, symbol)


def _is_known_misreading(sentence: str) -> bool:
    """What no rule without its words can leave out: sayings, a thing said to be itself (by a synonym perhaps), a quote
    in the lesson of a quote, where the parser may take "you are not the boss of me" for what follows, "twirl up"."""
    said = sentence.removesuffix(" please").split()
    if is_chatter(tuple(piece.text for piece in pieces(sentence))):
        return True
    if said[:3] == ["when", "i", "say"]:
        return "say" in said[3:]
    if any(verb in TURNING and way in ("up", "down") for verb, way in pairwise(said)):
        return True
    *before, last = (word.removesuffix("s") for word in said)
    return bool({"means", "is", "are"} & set(said)) and last in before
