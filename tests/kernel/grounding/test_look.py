"""This body has no eyes, and says so."""

from typing import Any

import pytest


@pytest.mark.parametrize("verb", ["find", "look for", "search for"])
def test_it_has_no_way_to_see(robot: Any, verb: str) -> None:
    robot.do(
        f"FIND[ obj-2; ako-3 -lex- box; -ako-> obj-2 ]; DO[ act-1 -lex- {verb}; -obj-> obj-2 ]"
    )
    assert robot.reasons == ["no_sense"]
    assert robot.moved == []
