"""Amounts told in two parts: "two feet and three inches", "an inch and a quarter"."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError

# How many of the smaller unit the greater one is.
PARTS: Final = {
    ("foot", "inch"): 12,
    ("yard", "foot"): 3,
    ("yard", "inch"): 36,
    ("mile", "foot"): 5280,
    ("meter", "centimeter"): 100,
    ("meter", "millimeter"): 1000,
    ("centimeter", "millimeter"): 10,
    ("kilometer", "meter"): 1000,
    ("hour", "minute"): 60,
    ("hour", "second"): 3600,
    ("minute", "second"): 60,
    ("pound", "ounce"): 16,
    ("kilo", "gram"): 1000,
}


FRACTIONS: Final = {"more_half": 0.5, "more_quarter": 0.25}


def summed(amt: AList) -> AList:
    """The amount as one number, in the smaller of its units."""
    for name, part in FRACTIONS.items():
        if amt.has(name):  # "a second and a half"
            number = AList("num", value=f"{float(amt.slot('num', '1')) + part:g}")
            return AList("amt", (number, *(one for one in amt if one.name not in ("num", name))))
    units = [unit.value or "" for unit in amt.all("unit")]
    if len(units) < 2:
        return amt
    *first, last = [float(number.value or "1") for number in amt.all("num")]
    if (parts := PARTS.get((units[0], units[1]))) is None:
        raise NoMeaningError(str(amt))
    total = (first[0] if first else 1.0) * parts + last
    return AList("amt", (AList("num", value=f"{total:g}"), AList("unit", value=units[1])))
