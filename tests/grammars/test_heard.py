"""What the recognisers are told may be said."""

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
LISTED = {symbol for _, symbols in heard_rules([], HEARD) for symbol in symbols} - {"choice"}
"""Forms with a rule of the ears; a choice means something only while its question is open."""
FORMS = [form for form in discover().values() if form.name in LISTED]
SAID_EITHER_WAY = {"command": {"control", "feedback"}, "prohibition": {"control"}}
"""To stop is something to do, and what ends what is done."""


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
    assert skeleton().size < 1_530


@pytest.mark.parametrize("words", [BORN, TAUGHT], ids=["born", "taught"])
@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.name)
def test_what_may_be_said_is_read_as_its_form(form: Form, words: Vocabulary) -> None:
    """A rule of the ears that drifts from the parser's would be listened for in vain."""
    rules = heard_rules(spoken_rules(), HEARD)
    language = expand(compile_rules(rules, form.name), spoken_words(words))
    kinds = {form.kind} | SAID_EITHER_WAY.get(form.name, set())
    said = sample(language, 25, random.Random(7))
    assert said
    for sentence in said:
        if not _is_known_misreading(sentence):
            assert parse(sentence, words).kind in kinds, sentence


@pytest.mark.parametrize("words", [BORN, TAUGHT], ids=["born", "taught"])
def test_whatever_may_be_said_parses(words: Vocabulary) -> None:
    answers = expand(compile_rules(heard_rules([], HEARD), "choice"), spoken_words(words))
    for sentence in phrases(words, 200, seed=8):
        if not answers.accepts(sentence.split()) and not _is_known_misreading(sentence):
            parse(sentence, words)


@pytest.mark.parametrize("name", sorted({form.name for form in FORMS}))
def test_each_form_that_is_heard_hears_an_example_of_its_own(name: str) -> None:
    """Which others are typed only is told at the end of docs/language.md."""
    language = automaton(BORN)
    assert any(
        language.accepts(re.findall(r"[\w'-]+", example.lower()))
        for example in discover()[name].examples
    )


@pytest.mark.parametrize(("form", "sentence"), CONSTRUCTIONS)
def test_each_construction_that_is_heard_is_accepted_and_parses(form: str, sentence: str) -> None:
    assert automaton(BORN).accepts(sentence.split())
    assert parse(sentence).kind == discover()[form].kind


def test_replaced_rules_name_rules_and_words_that_exist() -> None:
    """A rule renamed in the grammar would silently be heard no more."""
    rules = heard_rules(spoken_rules(), "")
    known = {origin for origin, _ in rules}
    of_its_own = {origin for origin, _ in heard_rules([], HEARD)}
    for origin, symbols in heard_rules([], HEARD):
        for symbol in symbols:
            assert symbol.startswith('"') or symbol.isupper() or symbol in known | of_its_own, (
                origin,
                symbol,
            )


def _is_known_misreading(sentence: str) -> bool:
    """What no rule without its words can leave out: sayings, a thing said to be itself (by a synonym perhaps), and a
    quote in the lesson of a quote, where the parser may take "you are not the boss of me" for what follows."""
    said = sentence.removesuffix(" please").split()
    if is_chatter(tuple(piece.text for piece in pieces(sentence))):
        return True
    if said[:3] == ["when", "i", "say"]:
        return "say" in said[3:]
    *before, last = (word.removesuffix("s") for word in said)
    return bool({"means", "is", "are"} & set(said)) and last in before
