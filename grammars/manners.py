"""How something is done, and how much of it, into nets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import degree
from grammars.vocabulary import BORN

if TYPE_CHECKING:
    from grammars.things import Things

PACES: Final = {"at_full_speed": "fast", "at_low_speed": "slowly"}
BOUNDS: Final = {"over": "over", "under": "under", "up_to": "at most"}
_LITTLE: Final = ("deg", "little")
NOT_TOO: Final = {
    **dict.fromkeys(("far", "much", "high", "low", "long", "wide"), _LITTLE),
    **dict.fromkeys(("fast", "quickly", "quick", "rapidly", "suddenly"), ("mod", "slowly")),
    **dict.fromkeys(("hard", "firmly", "tightly"), ("mod", "gently")),
    **dict.fromkeys(("loudly", "loud"), ("mod", "quietly")),
    "slowly": ("mod", "quickly"),
}
SIZES: Final = {
    "all the way": "fully",
    "completely": "fully",
    "fully": "fully",
    "a lot": "much",
    "a whole lot": "much",
    "halfway": "half",
    "half way": "half",
    "further": "more",
    "some more": "more",
}


def bounded(build: Things, amt: str, said: AList) -> None:
    """ "Above ten inches". What a deed is matched with cannot be so: it would match no other amount."""
    bound = next((word for name, word in BOUNDS.items() if said.has(name)), "")
    if bound and (build.trigger or (said.has("under") and not build.pattern)):
        raise NoMeaningError(str(said))
    if bound:
        build.add("deg", bound, deg=amt)


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
    if faster is not None:
        word = faster.slot("adv") or faster.value or ""
        if "ADV" not in BORN.readings(word):  # "drive bigger"
            raise NoMeaningError(str(said))
    mod = build.add("mod", word, mod=act)
    if faster is not None:
        build.add("deg", "more", deg=mod)
    for deg in said.all("deg"):
        build.add("deg", degree(deg.value or ""), deg=mod)
