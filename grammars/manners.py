"""How something is done, and how much of it, into nets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import degree
from grammars.pacing import TIMES
from grammars.vocabulary import BORN

if TYPE_CHECKING:
    from grammars.things import Things

PACES: Final = {"at_full_speed": "fast", "at_low_speed": "slowly"}
BOUNDS: Final = {"over": "over", "under": "under", "up_to": "at most"}
COMPARED: Final = {"over": ">", "under": "<"}
# What the comparison is, and with how many more.
SO_MANY: Final = {
    "more_than": (">", 0),
    "at_least": (">", -1),
    "fewer": ("<", 0),
    "at_most": ("<", 1),
}
MORE_THAN_ONE: Final = "> 1"
VOICED: Final = {"loud": "loudly", "quiet": "quietly"}
POINTING: Final = ("this", "that", "it")
_LITTLE: Final = ("deg", "little")
NOT_TOO: Final = {
    **dict.fromkeys(("far", "much", "high", "low", "long", "wide"), _LITTLE),
    **dict.fromkeys(("fast", "quickly", "quick", "rapidly", "suddenly"), ("mod", "slowly")),
    **dict.fromkeys(("hard", "firmly", "tightly"), ("mod", "gently")),
    **dict.fromkeys(("loudly", "loud"), ("mod", "quietly")),
    "slowly": ("mod", "quickly"),
}
RESULTS: Final = frozenset("leave hold push pull paint slam kick prop bend".split())
ENDS: Final = frozenset("open closed shut on off locked unlocked".split())
SIZES: Final = {
    "the rest of the way": "fully",
    "the rest": "fully",
    "all the way": "fully",
    "completely": "fully",
    "fully": "fully",
    "a lot": "much",
    "a whole lot": "much",
    "halfway": "half",
    "half way": "half",
    "further": "more",
    "some more": "more",
    "bigger": "more",
    "larger": "more",
    "longer": "more",
}


def bounded(build: Things, amt: str, said: AList) -> None:
    """ "Above ten inches"; what a deed is matched with is a comparison (kernel.net.match)."""
    bound = next((word for name, word in BOUNDS.items() if said.has(name)), "")
    if bound and build.trigger:
        if bound not in COMPARED:
            raise NoMeaningError(str(said))
        number = build.sketch.terms[amt].literal
        build.sketch.change(amt, literal=f"{COMPARED[bound]} {number}")
    elif bound == "under" and not build.pattern:
        raise NoMeaningError(str(said))
    elif bound:
        build.add("deg", bound, deg=amt)


def limited(build: Things, cnt: AList, number: str) -> str:
    """How many times; "more than three times" is a comparison, and no number to do something."""
    bound = next((word for name, word in COMPARED.items() if cnt.has(name)), "")
    if cnt.has("up_to") or (bound and not build.pattern):
        raise NoMeaningError(str(cnt))
    return f"{bound} {number}".strip()


def how_many(build: Things, said: AList) -> str:
    """Number of things; "at least two" is a comparison, and no number to do something with."""
    number = said.slot("num")
    bound = next((part.name for part in said if part.name in SO_MANY), "")
    if not bound:
        return number
    if not build.pattern or not number.isdecimal():
        raise NoMeaningError(str(said))
    sign, more = SO_MANY[bound]
    return f"{sign} {int(number) + more}"


def so_many(literal: str) -> str:
    """The same in words: "more than 2"."""
    sign, _, number = literal.partition(" ")
    if literal == MORE_THAN_ONE:
        return "more than one"
    return {">": "more than ", "<": "fewer than "}.get(sign, sign) + number


def unit_of(amt: AList) -> str:
    """Inch; "inch per second"."""
    unit = amt.slot("unit") or amt.value or ""
    if (per := amt.find("per")) is None:
        return unit
    if unit in TIMES or per.slot("unit") not in TIMES:
        raise NoMeaningError(str(amt))
    return f"{unit} per {per.slot('unit')}"


def not_too(build: Things, act: str, said: AList) -> None:
    """ "But not too far": a little; "not too fast": slowly."""
    word = said.slot("adv") or said.value or ""
    if word not in NOT_TOO:
        raise NoMeaningError(str(said))
    role, other = NOT_TOO[word]
    build.add(role, other, **{role: act})


def manner(build: Things, act: str, said: AList) -> None:
    """Slowly, very slowly, faster, at full speed."""
    faster = said.find("faster")
    word = next((pace for name, pace in PACES.items() if said.has(name)), "")
    word = word or said.slot("adv") or said.value or ""
    if louder := said.slot("adjer"):
        word = BORN.readings(louder)["ADJER"]
    if faster is not None:
        word = faster.slot("adv") or faster.value or ""
        if "ADV" not in BORN.readings(word):  # "drive bigger"
            raise NoMeaningError(str(said))
    if not louder and "say" in build.sketch.terms[act].lex:  # "as loud as you can"
        word = VOICED.get(word, word)
    mod = build.add("mod", word, mod=act)
    if faster is not None or louder:
        build.add("deg", "more", deg=mod)
    if (paced := said.find("paced_as")) is not None:
        build.sketch.link(mod, "than", _pacer(build, paced))
    if (paced := said.find("paced_like")) is not None:
        build.sketch.link(mod, "as", _pacer(build, paced))
    for deg in said.all("deg"):
        build.add("deg", degree(deg.value or ""), deg=mod)


def _pacer(build: Things, paced: AList) -> str:
    """Node of what is no faster: "than Mary", "than you can see"."""
    np = paced.first("np", "base_np", "sorts_np")
    if np.slot("pron") in POINTING:  # "faster than that" corrects
        raise NoMeaningError(str(paced))
    other = build.aside(np)
    if does := next(filter(None, map(paced.slot, ("does", "state"))), ""):
        return build.add("act", does, agt=other)
    return other


def within(build: Things, act: str, near: AList) -> None:
    """ "Within a foot of the stove", where the deed is to be told by it."""
    measure = near.first("measure")
    loc = build.add("loc", "within", loc=act, wrt=build.aside(near.first("np")))
    build.add("amt", measure.slot("unit"), literal=measure.slot("num", "1"), amt=loc)


def resulting(build: Things, act: str, said: AList) -> None:
    """How it is left: "leave the door open"; nobody leaves luggage unattended here."""
    word = said.value or ""
    if build.sketch.terms[act].lex.isdisjoint(RESULTS) or word not in ENDS:
        raise NoMeaningError(str(said))
    build.add("mod", word, mod=act)
