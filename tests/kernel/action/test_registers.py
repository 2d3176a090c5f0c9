"""Files register themselves, each under a name of its own."""

import pytest

from kernel.action.call import GROUNDINGS, grounding_function
from kernel.action.discover import load_all
from kernel.action.sensing import SENSES, sense
from kernel.action.step import DIRECTIVES, directive


def test_importing_a_package_is_all_it_takes() -> None:
    load_all("kernel.directives")
    modules = load_all("kernel.grounding")
    assert {"NOTE", "DO", "PUNT", "CHK", "FIND", "FCN", "ADD", "ASK"} <= set(DIRECTIVES)
    assert {"base_drive", "base_turn", "fork_lift", "fork_grip", "say", "rest"} <= set(GROUNDINGS)
    assert "watch" in SENSES
    assert list(modules) == sorted(modules)


@pytest.mark.parametrize(
    ("register", "name"), [(directive, "DO"), (grounding_function, "base_drive"), (sense, "watch")]
)
def test_a_name_is_taken_once(register: object, name: str) -> None:
    load_all("kernel.directives")
    load_all("kernel.grounding")
    with pytest.raises(ValueError, match=name):
        register(name)(lambda: None)  # type: ignore[operator]


def test_no_verb_has_two_functions() -> None:
    load_all("kernel.grounding")
    verbs = [verb for grounding in GROUNDINGS.values() for verb in grounding.verbs]
    assert len(verbs) == len(set(verbs))
