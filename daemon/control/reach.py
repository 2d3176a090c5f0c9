"""The robot as the command line reaches it: through the running daemon, or in this process where none runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, closing, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

from daemon.closing import Closing
from daemon.control import messages
from daemon.control.client import Client
from daemon.control.messages import OutcomeWord
from daemon.lessons import Row, missing, rows_of
from daemon.logbook import Entry, entries

if TYPE_CHECKING:
    from daemon.config import Config
    from daemon.events import Event
    from daemon.inprocess import Here
    from daemon.store import Store

See = Callable[[Mapping[str, Any]], None]
"""Told of every event, as `events.as_dict` makes it."""


class ReachError(Exception):
    """It was not done; the message says why and what to do."""


class Reach(Closing):
    """What both ways can do. Use as a context.

    Attributes:
        live: a daemon runs, and what is said goes to its robot.
    """

    live: bool

    def say(self, text: str, speaker: str, see: See, *, aloud: bool = True) -> OutcomeWord:
        """Say it and wait for what it comes to. aloud: the voice acknowledges what is taught.

        Raises:
            ControlError, StoreError, OSError: it could not be said.
        """
        raise NotImplementedError

    def hear(self, path: Path, speaker: str, see: See) -> OutcomeWord:
        """Play a sound file to its ears and wait for what it comes to."""
        raise NotImplementedError

    def lessons(self) -> tuple[Row, ...]:
        """Every lesson, by number, those taken back and those that rest as well."""
        raise NotImplementedError

    def log(self, last: int) -> tuple[Entry, ...]:
        """The last entries of the log, oldest first."""
        raise NotImplementedError

    def forget(self, numbers: tuple[int, ...], speaker: str, see: See) -> OutcomeWord:
        """Take these lessons back.

        Raises:
            ReachError: one of them is not in force; nothing was changed.
        """
        if wrong := missing(numbers, self.lessons()):
            raise ReachError(
                f"{'; '.join(wrong)}; nothing was changed (`sayso lessons` lists them)"
            )
        return self._forget(numbers, speaker, see)

    def _forget(self, numbers: tuple[int, ...], speaker: str, see: See) -> OutcomeWord:
        raise NotImplementedError


class Running(Reach):
    """Through the control socket of a running daemon."""

    live = True

    def __init__(self, client: Client) -> None:
        self._client = client

    def say(self, text: str, speaker: str, see: See, *, aloud: bool = True) -> OutcomeWord:
        """As `Reach`."""
        return self._follow(messages.Say(v=1, text=text, speaker=speaker, aloud=aloud), see)

    def hear(self, path: Path, speaker: str, see: See) -> OutcomeWord:
        """As `Reach`."""
        return self._follow(messages.Hear(v=1, path=str(path.resolve()), speaker=speaker), see)

    def lessons(self) -> tuple[Row, ...]:
        """As `Reach`."""
        found: list[Row] = []
        more = True
        while more:
            facts = self._told(messages.Lessons(v=1, after=found[-1].ident if found else 0))
            found += msgspec.convert(facts["lessons"], list[Row])
            more = facts["more"]
        return tuple(found)

    def log(self, last: int) -> tuple[Entry, ...]:
        """As `Reach`."""
        facts = self._told(messages.Log(v=1, last=last))
        return tuple(msgspec.convert(facts["entries"], list[Entry]))

    def close(self) -> None:
        """Hang up."""
        self._client.close()

    def _forget(self, numbers: tuple[int, ...], speaker: str, see: See) -> OutcomeWord:
        return self._follow(messages.Forget(v=1, lessons=numbers, speaker=speaker), see)

    def _follow(self, request: messages.Request, see: See) -> OutcomeWord:
        outcome: OutcomeWord = "failed"
        for answer in self._client.ask(request):
            if isinstance(answer, messages.Happened):
                see(answer.event)
            elif isinstance(answer, messages.Done):
                outcome = answer.outcome
        return outcome

    def _told(self, request: messages.Request) -> dict[str, Any]:
        *_, answer = self._client.ask(request)
        assert isinstance(answer, messages.Told), "the last answer to such a request"
        return answer.facts


class Alone(Reach):
    """On the user's store, with a simulated robot in virtual time once something is said."""

    live = False

    def __init__(self, config: Config) -> None:
        self._config = config
        self._here: Here | None = None
        self._see: See = lambda _event: None

    def say(self, text: str, speaker: str, see: See, *, aloud: bool = True) -> OutcomeWord:
        """As `Reach`."""
        return self._robot(see).say(text, speaker, aloud=aloud)

    def hear(self, path: Path, speaker: str, see: See) -> OutcomeWord:
        """As `Reach`."""
        return self._robot(see).hear(path, speaker)

    def lessons(self) -> tuple[Row, ...]:
        """As `Reach`."""
        from daemon.parts import abilities

        with self._store() as store:
            return rows_of(store.load(abilities()))

    def log(self, last: int) -> tuple[Entry, ...]:
        """As `Reach`."""
        with self._store() as store:
            return entries(store.utterances(last), store.load().changes, last)

    def close(self) -> None:
        """Stop and close."""
        if self._here is not None:
            self._here.close()

    def _forget(self, numbers: tuple[int, ...], speaker: str, see: See) -> OutcomeWord:
        return self._robot(see).forget(numbers, speaker)

    def _robot(self, see: See) -> Here:
        self._see = see
        if self._here is None:
            from daemon.inprocess import Here

            self._here = Here(self._config, self._tell)
        return self._here

    def _tell(self, event: Event) -> None:
        from daemon.events import as_dict

        self._see(as_dict(event))

    def _store(self) -> AbstractContextManager[Store]:
        """The store, open: the robot's own, or one that is closed again."""
        from daemon.config import store_path
        from daemon.store import Store

        if self._here is not None:
            return nullcontext(self._here.store)
        return closing(Store.open(store_path(self._config)))


def reach(config: Config) -> Reach:
    """The running daemon if there is one.

    Raises:
        OSError: there is one, and it cannot be reached.
    """
    from daemon.config import socket_path

    try:
        return Running(Client(socket_path(config)))
    except (FileNotFoundError, ConnectionRefusedError):
        return Alone(config)
