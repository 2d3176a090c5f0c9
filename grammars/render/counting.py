"""That there are so many, in words."""

from __future__ import annotations

from grammars.manners import MORE_THAN_ONE, so_many
from grammars.render.telling import Telling
from grammars.render.things import thing
from kernel.net.graphlet import Term


def there_are(telling: Telling, term: Term, name: str) -> tuple[str, str, str]:
    """What is said after "there": "are", "are 2 people", "2 people"."""
    telling.release([term])
    there = thing(telling, name, "subject")
    telling.hold_back([term])
    verb = "is" if there.startswith(so_many(MORE_THAN_ONE)) else "are"
    return verb, f"{verb} {there}", there
