"""The journal: what happened, for whoever runs the daemon."""

from __future__ import annotations

import logging

from daemon import events

log = logging.getLogger("sayso")


def journal(event: events.Event) -> None:
    """Log an event; where the robot is would fill the journal and is left out."""
    match event:
        case events.Pose():
            return
        case events.Error():
            level = logging.ERROR
        case events.Link(up=False):
            level = logging.WARNING
        case events.Noted():
            level = logging.DEBUG
        case _:
            level = logging.INFO
    if log.isEnabledFor(level):
        fields = {k: v for k, v in events.as_dict(event).items() if k not in ("t", "event")}
        log.log(level, "%s %s", events.name(event), fields)
