"""Verb phrases: actions as orders, infinitives, gerunds and statements, with all that modifies them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal

from grammars.morphology import article, comparative, gerund, past, plural, third_person
from grammars.pacing import TIMES
from grammars.remarks import FOND
from grammars.render.names import literally
from grammars.render.qualities import BOUNDED, degree, measured
from grammars.render.telling import Telling, linked, word
from grammars.render.things import place, thing
from grammars.vocabulary import BORN
from kernel.memory.editing import OTHER_WAY
from kernel.net.graphlet import Term

VerbForm = Literal["base", "gerund", "third", "past"]

# Each inflects the first word of a phrase.
_FORMS: Final[dict[VerbForm, Callable[[str], str]]] = {
    "base": str, "gerund": gerund, "third": third_person, "past": past,
}  # fmt: skip
_WAITING: Final = ("wait", "pause", "rest")
_GOING: Final = ("go", "drive", "move", "step", "roll", "run", "walk", "come", "climb")
_SENSING: Final = ("see", "hear", "watch", "notice", "feel")
_TELLING: Final = ("tell", "ask")
_WISHING: Final = ("want", "need")
_KNOWING: Final = ("know", "remember", "learn", "forget")
_TAUGHT: Final = (*_TELLING, "teach")
_GIVING: Final = ("show", "give", "bring")
_SIZES: Final = {
    "little": "a little",
    "fully": "all the way",
    "much": "a lot",
    "half": "halfway",
    "more": "further",
}
# Directions that before an amount would mean "roughly".
_APPROXIMATE: Final = ("around", "about")
# Directions said before what they lead past: "go out the door".
_LEADING: Final = ("out", "in", "inside", "off", "over", "down", "up")
# They stand before a particle: "put it back".
_PRONOUNS: Final = [
    ["it"],
    ["yourself"],
    ["myself"],
    ["them"],
    ["him"],
    ["her"],
    ["me"],
    ["you"],
    ["that"],
    ["this"],
]
# They stay behind their verb: "wait for me".
_BOUND: Final = ("for", "at", "after", "of", "to")
_YOURSELF: Final = {"teacher": "yourself", "robot": "myself"}
_COUNTS: Final = {"1": "once", "2": "twice"}
_KNOWN_ROLES: Final = ("agt", "obj", "dest", "cmd")


def be(subject: str) -> str:
    """The form of "be" that agrees with a subject."""
    return {"I": "am", "you": "are", "they": "are", "we": "are"}.get(subject, "is")


def deed(telling: Telling, name: str, form: VerbForm = "base", told: bool = False) -> str:
    """The action as a verb phrase: "drive forward 10 inches slowly", "turning left twice".

    told: of somebody, who "gives the ball to Mary".
    """
    term = telling.term(name)
    telling.stated.add(name)
    verb, _, particle = (word(term) or "do something").partition(" ")
    arguments = _arguments(telling, term, told)
    parted = (
        bool(particle)
        and particle not in _BOUND
        and arguments[:1] in _PRONOUNS
        and linked(term, "obj") != ""
    )
    said = [arguments[0], particle, *arguments[1:]] if parted else [particle, *arguments]
    words = [verb, *filter(None, said), *_modifiers(telling, term)]
    return _FORMS[form](" ".join(words))


def _arguments(telling: Telling, term: Term, told: bool) -> list[str]:
    obj, dest, cmd = (linked(term, role) for role in ("obj", "dest", "cmd"))
    parts = []
    itself = not told and obj and telling.term(obj).lex == {"you"}
    silent = word(term) == "say" and not obj
    what = _YOURSELF[telling.voice] if itself else _object(telling, obj, word(term)) if obj else ""
    what = "anything" if silent else what
    if dest and (word(term) in _TAUGHT or (not told and _is_given(telling, term))):
        parts += [thing(telling, dest), what]
    else:
        ways = [
            degree(telling, way.name) + word(way).replace(OTHER_WAY, f"the {OTHER_WAY}")
            for way in telling.about(term.name, "dir")
            if not (word(way) in _APPROXIMATE and telling.about(term.name, "amt"))
        ]
        leading = [
            way for way in ways if what and word(term) in (*_GOING, "look") and way in _LEADING
        ]
        parts += [*leading, what, *(way for way in ways if way not in leading)]
        back = [how for how in telling.about(term.name, "mod") if dest and word(how) == "back"]
        telling.hold_back(back)
        parts += [f"{'back ' if back else ''}to {thing(telling, dest)}" if dest else ""]
    if obj and word(term) in _SENSING:
        parts += [deed(telling, seen.name, "gerund") for seen in telling.about(obj, "agt")]
    if cmd:
        parts.append(("to " if word(term) in _TAUGHT else "") + deed(telling, cmd))
    for role, other in term.links:
        if role not in _KNOWN_ROLES:
            parts.append(f"{role} {thing(telling, other)}")
    return [part for part in parts if part]


def _is_given(telling: Telling, term: Term) -> bool:
    """ "Bring Mary the cup", "sing me a song"."""
    mine = not telling.term(linked(term, "dest")).lex.isdisjoint(("me", "you"))
    return word(term) in _GIVING or (mine and "GIVE" in BORN.readings(word(term)))


def _object(telling: Telling, name: str, verb: str) -> str:
    """Quoted speech, a thing, or the whereabouts of one: "where my phone is"."""
    term = telling.term(name)
    if term.literal is not None:
        return literally(term.literal)
    if term.kind == "act":
        agent = linked(term, "agt")
        whom = f"{thing(telling, agent)} " if agent else ""
        done = deed(telling, name)
        if whom:  # "want me to help"
            return f"{whom}to {done}"
        if verb in _WISHING and " " not in done:  # "a rest"
            return f"{article(done)} {done}"
        return f"how to {done}" if verb in _KNOWING else f"to {done}"
    sought = linked(term, "loc")
    if sought and not term.lex:
        telling.stated.add(name)
        subject = thing(telling, sought, "subject")
        return f"where {subject} {'are' if telling.several(sought) else be(subject)}"
    said = thing(telling, name)
    det, _, sort = said.partition(" ")
    return plural(sort) if verb in FOND and det in ("a", "an") else said  # "likes apples"


def _modifiers(telling: Telling, term: Term) -> list[str]:
    """Place, amount, degree, manner and count; "turn 10 degrees around", as "around 10" is roughly 10."""
    name, verb = term.name, word(term)
    places = [place(telling, where) for where in telling.take(name, "loc")]
    measures = amounts(telling, name, verb)
    if measures:
        measures += [word(way) for way in telling.about(name, "dir") if word(way) in _APPROXIMATE]
    degrees = [_SIZES.get(word(size), word(size)) for size in telling.take(name, "deg")]
    manners = [_manner(telling, how) for how in telling.take(name, "mod")]
    counts = [_times(count.literal or "1") for count in telling.take(name, "cnt")]
    # "a little quickly" would be little of the quickness
    how = (*manners, *degrees) if manners else degrees
    return [part for part in (*places, *measures, *how, *counts) if part]


def _manner(telling: Telling, how: Term) -> str:
    """ "Very slowly", "faster"."""
    said = degree(telling, how.name)
    flat = said == "more " and "ADJ" in BORN.readings(word(how))
    if like := linked(how, "as"):
        return f"as {word(how)} as {_pacer(telling, like)}"
    paced = f" than {_pacer(telling, linked(how, 'than'))}" if linked(how, "than") else ""
    return (comparative(word(how)) if flat else said + word(how)) + paced


def _pacer(telling: Telling, name: str) -> str:
    """ "Than Mary", "than you can see"."""
    term = telling.term(name)
    if term.kind != "act":
        return thing(telling, name)
    telling.stated.add(name)
    return f"{thing(telling, linked(term, 'agt'), 'subject')} can {word(term)}"


def _times(number: str) -> str:
    """Twice; 3 times; over 3 times."""
    if number[:1] in BOUNDED:
        return f"{BOUNDED[number[:1]]}{number[1:].strip()} times"
    return _COUNTS.get(number, f"{number} times")


def amounts(telling: Telling, name: str, verb: str = "wait") -> list[str]:
    """How far or how long: "10 inches", "for 2 seconds" where the verb is none of waiting."""
    return [_amount(telling, amount, verb) for amount in telling.take(name, "amt")]


def _amount(telling: Telling, term: Term, verb: str) -> str:
    unit = word(term)
    bound = degree(telling, term.name)
    number = term.literal or "1"
    if not unit and verb == "count":
        return f"to {number}"
    if number[:1] in BOUNDED:
        bound, number = BOUNDED[number[:1]], number[1:].strip()
    if not unit:  # "strikes 12"
        return number
    lasting = unit in TIMES and verb not in _WAITING
    lead = "for " if lasting else "at " if " " in unit and not bound else ""
    return f"{lead}{bound}{measured(number, unit)}"
