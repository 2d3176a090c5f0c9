"""What is so of the world before anybody says anything: the robot has its parts, and who speaks is a person."""

from __future__ import annotations

from kernel.net.node import Net, Node


def part(net: Net, noun: str, me: Node) -> tuple[Node, Node, Node]:
    """A part of the robot's own body: the thing, its kind, whose it is."""
    thing = net.new("obj")
    return thing, net.new("ako", noun, ako=thing), net.new("own", own=thing, of=me)


def speaker(net: Net, name: str) -> tuple[Node, Node]:
    """Somebody who speaks, and that it is a person."""
    person = net.new("user", name)
    return person, net.new("ako", "person", ako=person)
