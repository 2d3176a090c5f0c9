"""Scenes users write."""

import math

import pytest

from kernel.bodies.forklift import scene
from kernel.bodies.forklift.scene import SceneError, Thing, usual


def test_a_scene_is_read_whole() -> None:
    read = scene.read(
        """
        [robot]
        x_cm = 10
        heading_deg = 90
        [[thing]]
        noun = "block"
        colour = "red"
        name = "Bert"
        x_cm = 40
        y_cm = -2.5
        size_cm = [3, 5]
        turned_deg = 45
        low = true
        [[wall]]
        from_cm = [100, -50]
        to_cm = [100, 50]
        """
    )
    assert (read.x_cm, read.y_cm, read.heading_rad) == (10, 0, math.pi / 2)
    assert read.things == (
        Thing("block", "red", "Bert", True, 40, -2.5, math.pi / 4, 3, 5),
        Thing("wall", x_cm=100, y_cm=0, turned_rad=0, along_cm=2, across_cm=100),
    )


def test_an_empty_text_is_an_empty_scene() -> None:
    assert scene.read("") == scene.Scene()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("[[thing", "scene"),
        ("blocks = 3", "unknown key blocks"),
        ("robot = 3", "robot: expected a table"),
        ("[robot]\nspeed = 3", "robot: unknown key speed"),
        ("[robot]\nx_cm = 'far'", "robot: x_cm: expected a number"),
        ("[robot]\nx_cm = nan", "robot: x_cm: expected a number"),
        ("thing = 3", "thing: expected [[thing]] tables"),
        ("[[thing]]\nx_cm = 1\ny_cm = 1", "thing 1: noun is missing"),
        ("[[thing]]\nnoun = 'a'\nx_cm = 1", "thing 1: y_cm is missing"),
        ("[[thing]]\nnoun = ''\nx_cm = 1\ny_cm = 1", "thing 1: noun: expected a word"),
        ("[[thing]]\nnoun = 'a'\nx_cm = 1\ny_cm = 1\nlow = 1", "low: expected true or false"),
        ("[[thing]]\nnoun = 'a'\nx_cm = 1\ny_cm = 1\nsize_cm = 0", "size_cm: expected more than 0"),
        ("[[thing]]\nnoun = 'a'\nx_cm = 1\ny_cm = 1\nsize_cm = [1]", "expected two numbers"),
        ("[[wall]]\nfrom_cm = [1, 1]\nto_cm = [1, 1]", "wall 1: from_cm and to_cm are the same"),
        ("[[wall]]\nfrom_cm = [1, 1]", "wall 1: to_cm: expected two numbers"),
    ],
)
def test_a_mistake_is_named_with_its_place(text: str, says: str) -> None:
    with pytest.raises(SceneError) as caught:
        scene.read(text)
    assert says in str(caught.value)


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        (usual("block"), usual("block"), True),
        (usual("block", "red"), usual("block"), True),
        (usual("block", "red"), usual("block", "blue"), False),
        (usual("block", name="Bert"), usual("block", "red"), True),
        (usual("block", name="Bert"), usual("block", name="Ernie"), False),
        (usual("block"), usual("cup"), False),
    ],
)
def test_which_words_may_mean_the_same_thing(one: Thing, other: Thing, same: bool) -> None:
    assert one.could_be(other) is same
    assert other.could_be(one) is same
