"""Bodies are found by their folder."""

import pytest

from kernel.bodies import registry
from kernel.bodies.forklift.body import Forklift
from kernel.bodies.registry import UnknownBodyError


def test_the_forklift_is_there_and_fresh_each_time() -> None:
    assert "forklift" in registry.names()
    one, other = registry.make("forklift"), registry.make("forklift")
    assert isinstance(one, Forklift)
    assert one is not other


def test_an_unknown_body_is_named_with_the_known_ones() -> None:
    with pytest.raises(UnknownBodyError) as caught:
        registry.make("submarine")
    assert caught.value.name == "submarine"
    assert "forklift" in caught.value.known
