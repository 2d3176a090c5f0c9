"""The road to the robot: a port opened by its address, a session over it, and a keeper that tries again."""

from daemon.link.service import Link, open_link

__all__ = ["Link", "open_link"]
