"""Lessons as text: canonical, and read back as what was written."""

import random
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kernel.action.chain import Chain, Directive, Loop, Part, Play, sequence
from kernel.errors import NotationError
from kernel.memory.lesson import Operator, Rule
from kernel.memory.meaning import (
    Command,
    Control,
    Fact,
    Feedback,
    Identity,
    Question,
    Revision,
    Social,
    Teach,
)
from kernel.memory.notation import Written, canonical, read, read_chain, write, write_meaning
from kernel.net.graphlet import Graphlet, Sketch, Term

WORDS = ("grab", "block", "red", "person", "I'm not allowed to")


@st.composite
def graphlets(draw: st.DrawFn) -> Graphlet:
    """Names are drawn from few, so that the graphlets of one lesson share them."""
    count = draw(st.integers(1, 3))
    numbers = draw(st.lists(st.integers(1, 5), min_size=count, max_size=count, unique=True))
    terms: list[Term] = []
    for number in numbers:
        links: tuple[tuple[str, str], ...] = ()
        if terms:
            targets = st.sampled_from([term.name for term in terms])
            links = tuple(
                draw(st.sets(st.tuples(st.sampled_from(("ako", "obj")), targets), max_size=1))
            )
        lex = draw(st.frozensets(st.sampled_from(WORDS), min_size=1, max_size=2))
        belief = draw(st.sampled_from((1.0, 0.7)))
        terms.append(Term(f"obj-{number}", lex, None, "", draw(st.booleans()), belief, links))
    return Graphlet(tuple(terms), terms[0].name)


directives = st.one_of(
    st.builds(Directive, st.sampled_from(("DO", "FIND", "CHK")), graphlets()),
    st.just(Directive("PUNT")),
)


def _plays(parts: st.SearchStrategy[Part]) -> st.SearchStrategy[Play]:
    return st.builds(
        Play,
        st.lists(parts, min_size=1, max_size=2).map(tuple),
        st.lists(parts, max_size=1).map(tuple),
    )


_maybe = st.none() | graphlets()
loops = st.builds(
    Loop,
    st.lists(_plays(directives), min_size=1, max_size=2).map(tuple).map(Chain),
    st.none() | st.integers(1, 30),
    _maybe,
    _maybe,
    _maybe,
)
plays = _plays(st.one_of(directives, loops, st.builds(sequence, directives, loops)))
chains = st.lists(plays, max_size=2).map(tuple).map(Chain)
several = st.lists(graphlets(), max_size=2).map(tuple)
contents: st.SearchStrategy[Written] = st.one_of(
    graphlets(),
    st.builds(Rule, graphlets(), graphlets(), several, st.sampled_from((1.0, 0.8, 0.05))),
    st.builds(
        Operator,
        st.builds(Directive, st.sampled_from(("DO", "ANTE", "NOTE")), graphlets()),
        chains,
        several,
        several,
        st.sampled_from((1.0, 1.2, 0.8)),
    ),
)


@settings(max_examples=60)
@given(contents)
def test_reading_what_was_written_gives_the_same(content: Written) -> None:
    assert read(write(content)) == canonical(content)


@settings(max_examples=30)
@given(contents)
def test_writing_again_changes_nothing(content: Written) -> None:
    assert write(read(write(content))) == write(content)
    assert canonical(canonical(content)) == canonical(content)


@settings(max_examples=30)
@given(chains)
def test_a_chain_alone_is_read_as_well(chain: Chain) -> None:
    assert read_chain(write(chain)) == canonical(chain)


PROHIBITION = """trig: ANTE[ act-1 -lex-  grab
                  -obj-> obj-2
            ako-3 -lex-  person
                  -ako-> obj-2 ]
pref: 1.0
---------------
DO[ act-4 -lex-  say
          -obj-> txt-5
    txt-5 -str-  I'm not allowed to ]
PUNT[ ]"""


def test_the_papers_prohibition_as_it_is_printed() -> None:
    content = read(PROHIBITION)
    assert isinstance(content, Operator)
    assert content.prohibits
    assert write(content) == PROHIBITION


def test_what_a_reordered_and_renumbered_lesson_says_is_the_same() -> None:
    twisted = """
        trig: ANTE[ act-9 -lex- grab
                          -obj-> obj-8
                    ako-2 -lex- person
                          -ako-> obj-8 ]
        pref: 1
        ---
        DO[ act-1 -obj-> txt-3
                  -lex- say
            txt-3 -str- I'm not allowed to ]
        PUNT[ ]
    """
    assert write(read(twisted)) == PROHIBITION


@pytest.mark.parametrize(
    "change",
    [
        ("grab", "lift"),
        ("ANTE", "DO"),
        ("pref: 1.0", "pref: 1.2"),
        ("-ako-> obj-2", "-hq-> obj-2"),
        ("I'm not allowed to", "no"),
        ("PUNT[ ]", ""),
        ("-lex-  person", "-lex-  person\n-neg-  yes"),
        ("-lex-  person", "-lex-  person\n-bel-  0.5"),
    ],
    ids=lambda change: change[1],
)
def test_another_lesson_has_another_text(change: tuple[str, str]) -> None:
    assert write(read(PROHIBITION.replace(*change))) != PROHIBITION


@settings(max_examples=40)
@given(st.integers())
def test_what_has_no_order_is_put_into_one(seed: int) -> None:
    """Exceptions that look alike but speak of different things included."""
    rule = read("""
        if:     act-1 -lex- carry
                      -obj-> obj-2
                      -dest-> obj-3
        unless: hq-4 -lex- close
                     -hq-> obj-2
        unless: hq-5 -lex- close
                     -hq-> obj-3
        unless: hq-6 -lex- heavy
                     -hq-> obj-2
        then:   hq-7 -lex- busy
                     -hq-> obj-3
        belief: 1.0
    """)
    assert isinstance(rule, Rule)
    unless = random.Random(seed).sample(rule.unless, len(rule.unless))
    assert write(replace(rule, unless=tuple(unless))) == write(rule)


PLAYS = """
    PLAY{
      DO[ act-1 -lex- drive
          dir-2 -lex- forward
                -dir-> act-1 ]
      CHAIN{
        DO[ act-3 -lex- raise ]
        DO[ act-4 -lex- lower ]
      }
    WITH
      DO[ act-5 -lex- say
                -obj-> txt-6
          txt-6 -str- beep ] }
"""


def test_plays_with_parallel_auxiliary_and_nested_parts() -> None:
    chain = read_chain(PLAYS)
    (play,) = chain.plays
    assert len(play.required) == 2
    assert len(play.auxiliary) == 1
    nested = next(part for part in play.required if isinstance(part, Chain))
    assert len(nested.plays) == 2
    assert read_chain(write(chain)) == canonical(chain)


LOOP = """LOOP{
  times: 3
  until: hq-1 -lex-  close
              -hq-> obj-2
  while: hq-3 -lex-  open
              -hq-> obj-4
  each: obj-5
        ako-6 -lex-  block
              -ako-> obj-5
  DO[ act-7 -lex-  push
            -obj-> obj-5 ]
}"""


def test_a_loop_says_how_long_and_what() -> None:
    chain = read_chain(LOOP)
    (loop,) = chain.plays[0].required
    assert isinstance(loop, Loop)
    assert (loop.times, [g.main for g in loop.conditions()]) == (3, ["hq-1", "hq-3", "obj-5"])
    assert [d.tag for d in chain.directives()] == ["DO"]
    assert len(list(chain.graphlets())) == 4
    assert write(chain) == LOOP


def test_parts_of_a_play_have_no_order_but_plays_have() -> None:
    left, right = (Directive("DO", _act(word)) for word in ("raise", "drive"))
    both = Chain((Play((left, right)),))
    assert write(both) == write(Chain((Play((right, left)),)))
    assert write(Chain((Play((left,)), Play((right,))))) != write(
        Chain((Play((right,)), Play((left,))))
    )
    assert write(both) != write(Chain((Play((left,), (right,)),)))


def _act(word: str) -> Graphlet:
    sketch = Sketch()
    return sketch.graphlet(sketch.add("act", word))


@pytest.mark.parametrize(
    "wrong",
    [
        "",
        "if: ako-1 -lex- girl",
        "trig: DO[ act-1 -lex- drive",
        "trig: DO[ act-1 -lex- drive ]\npref: much\n---",
        "then: ako-1 -lex- girl\nif: ako-1 -lex- girl\nbelief: 1.0",
        "act-1 -lex- drive\nif: act-2 -lex- drive",
        PROHIBITION + "\n]",
        PROHIBITION + "\nLOOP{ times: often\nPUNT[ ] }",
        PROHIBITION + "\nLOOP{ times: 3\nPUNT[ ]",
        PROHIBITION.replace("]", "", 1),
    ],
)
def test_what_is_no_lesson_is_refused(wrong: str) -> None:
    with pytest.raises(NotationError):
        read(wrong)


DRIVE = _act("drive")


@pytest.mark.parametrize(
    ("meaning", "texts"),
    [
        (Command(Chain((Play((Directive("DO", DRIVE),)),))), ("DO[ act-1 -lex-  drive ]",)),
        (Fact(DRIVE), ("NOTE[ act-1 -lex-  drive ]",)),
        (Teach("rule", Rule(DRIVE, DRIVE)), ("if:   act-1 -lex-  drive\nthen: act-1 -lex-  drive\nbelief: 1.0",)),
        (Question("what", DRIVE, DRIVE.main, "did"), ("ASK what did act-1", "act-1 -lex-  drive")),
        (Feedback(good=False, stop=True), ("bad", "stop")),
        (Identity("rick"), ("user-1 -lex- rick",)),
        (Identity("pixel", robot=True), ("obj-1 -lex- pixel",)),
        (Social("hello"), ("hello",)),
        (Control("forget", DRIVE), ("forget", "act-1 -lex-  drive")),
        (Revision(Chain(), instead_of=DRIVE), ("", "instead of:\nact-1 -lex-  drive")),
    ],
    ids=lambda value: type(value).__name__,
)  # fmt: skip
def test_every_kind_of_meaning_has_a_text(meaning: object, texts: tuple[str, ...]) -> None:
    assert write_meaning(meaning) == texts  # type: ignore[arg-type]
