"""The control socket, with a real server and real clients: what is malformed gets an error and changes nothing."""

from __future__ import annotations

import asyncio
import json
import os
import socket
import stat
import tempfile
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from daemon import events
from daemon.control import messages
from daemon.control.client import Client, ControlError
from daemon.control.messages import Done, Happened, OutcomeWord, Told
from daemon.control.reach import ReachError, Running
from daemon.control.server import AT_ONCE, CONNECTIONS, ControlServer, SocketTakenError
from daemon.lessons import Row
from daemon.logbook import Entry

LESSONS = 2 * messages.LESSONS_AT_ONCE + 1


class RecordingDesk:
    """Takes notes of what it is asked to do."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, ...]] = []
        self.watchers: list[Callable[[events.Event], None]] = []
        self.hold: asyncio.Event | None = None

    def subscribe(self, see: Callable[[events.Event], None]) -> Callable[[], None]:
        self.watchers.append(see)
        return lambda: self.watchers.remove(see)

    @property
    def book(self) -> RecordingDesk:
        return self

    async def lessons(self, after: int, most: int) -> tuple[Row, ...]:
        return tuple(Row(ident=n, words="dance") for n in range(1, LESSONS + 1) if n > after)[:most]

    async def log(self, last: int) -> tuple[Entry, ...]:
        self.asked.append(("log", str(last)))
        return (Entry(at_s=1.5, what="said", text="dance"),)

    async def forget(self, numbers: tuple[int, ...], speaker: str, source: str) -> OutcomeWord:
        self.asked.append(("forget", str(numbers), speaker, source))
        if 9 in numbers:
            raise ValueError("there is no lesson 9")
        return "done"

    async def say(self, text: str, speaker: str, source: str, aloud: bool = True) -> OutcomeWord:
        self.asked.append(("say", text, speaker, source))
        for see in self.watchers:
            see(events.Heard(t=1.0, text=text))
        if self.hold is not None:
            await self.hold.wait()
        return "done"

    async def hear(self, path: Path, speaker: str, source: str) -> OutcomeWord:
        self.asked.append(("hear", str(path)))
        raise FileNotFoundError(2, "No such file", str(path))

    def stop(self, source: str) -> int:
        self.asked.append(("stop", source))
        return 3

    def status(self) -> dict[str, object]:
        return {"link": "up"}


@pytest.fixture
def path() -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="sayso-") as folder:
        yield Path(folder) / "run" / "control.sock"


@pytest.fixture
def desk() -> RecordingDesk:
    return RecordingDesk()


@pytest.fixture
async def served(path: Path, desk: RecordingDesk) -> AsyncIterator[Path]:
    server = ControlServer(path, desk)
    server.bind()
    task = asyncio.create_task(server.serve())
    yield path
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
    assert mode(path) is None


def mode(path: Path) -> int | None:
    """The socket's permissions, None where it is not there."""
    return stat.S_IMODE(path.stat().st_mode) if path.exists() else None


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(2):
        while not condition():  # noqa: ASYNC110 - nothing announces it
            await asyncio.sleep(0.001)


async def talk(path: Path, *lines: bytes) -> list[dict[str, object]]:
    """Send lines, close the sending side, read every answer."""
    reader, writer = await asyncio.open_unix_connection(str(path))
    for line in lines:
        writer.write(line)
    await writer.drain()
    answers = []
    with suppress(TimeoutError):
        async with asyncio.timeout(0.5):
            while line := await reader.readline():
                answers.append(json.loads(line))
                if len(answers) == len(lines):
                    break
    writer.close()
    return answers


def ask(path: Path, request: messages.Request) -> list[messages.AnyAnswer]:
    with Client(path, answer_s=5) as client:
        return list(client.ask(request))


async def test_a_request_is_answered_with_what_happens_and_what_came_of_it(
    served: Path, desk: RecordingDesk
) -> None:
    request = messages.Say(v=1, id=5, text="dance", speaker="Mary")
    answers = await asyncio.to_thread(ask, served, request)
    assert [type(answer) for answer in answers] == [Happened, Done]
    assert all(answer.id == 5 for answer in answers)
    assert desk.asked == [("say", "dance", "Mary", f"control uid={os.getuid()}")]
    assert not desk.watchers


async def test_status_and_stop(served: Path, desk: RecordingDesk) -> None:
    assert await asyncio.to_thread(ask, served, messages.Status(v=1)) == [
        Told(facts={"link": "up"})
    ]
    assert await asyncio.to_thread(ask, served, messages.Stop(v=1)) == [Told(facts={"epoch": 3})]
    assert desk.asked == [("stop", f"control uid={os.getuid()}")]


async def test_a_file_that_is_not_there_is_told(served: Path) -> None:
    with pytest.raises(ControlError, match="No such file"):
        await asyncio.to_thread(ask, served, messages.Hear(v=1, path="/nowhere.wav"))


MALFORMED = [
    b"\n",
    b"dance\n",
    b"[1, 2]\n",
    b"{}\n",
    b'{"v": 1}\n',
    b'{"v": 2, "do": "stop"}\n',
    b'{"do": "stop"}\n',
    b'{"v": 1, "do": "fly"}\n',
    b'{"v": 1, "do": "say"}\n',
    b'{"v": 1, "do": "say", "text": ""}\n',
    b'{"v": 1, "do": "say", "text": 7}\n',
    b'{"v": 1, "do": "say", "text": "dance", "loud": true}\n',
    b'{"v": 1, "do": "say", "text": "' + b"x" * 1001 + b'"}\n',
    b'{"v": 1, "do": "say", "text": "\xff\xfe"}\n',
    b"\x00\x01\x02\n",
    b'{"v": 1, "do": "stop"' + b"[" * 5000 + b"\n",
]


@pytest.mark.parametrize("line", MALFORMED, ids=range(len(MALFORMED)))
async def test_a_malformed_request_gets_an_error_and_changes_nothing(
    served: Path, desk: RecordingDesk, line: bytes
) -> None:
    good = b'{"v": 1, "do": "status"}\n'
    wrong, told = await talk(served, line, good)
    assert wrong["is"] == "wrong"
    assert wrong["error"]
    assert told["is"] == "told"  # the connection goes on
    assert desk.asked == []


async def test_a_request_without_end_is_refused_and_the_connection_closed(
    served: Path, desk: RecordingDesk
) -> None:
    (answer,) = await talk(served, b'{"v": 1, "do": "say", "text": "' + b"x" * 100_000)
    assert str(messages.LINE_BYTES) in str(answer["error"])
    assert desk.asked == []


async def test_requests_are_bounded_in_rate_but_stop_never_is(
    served: Path, desk: RecordingDesk
) -> None:
    asked = [b'{"v": 1, "do": "status"}\n'] * (messages.BURST + 20) + [b'{"v": 1, "do": "stop"}\n']
    answers = await talk(served, *asked)
    refused = [a for a in answers if a["is"] == "wrong"]
    assert 15 <= len(refused) <= 20
    assert "too many requests" in str(refused[0]["error"])
    assert [kind for kind, *_ in desk.asked] == ["stop"]


async def test_stop_on_the_same_connection_does_not_wait_for_an_utterance(
    served: Path, desk: RecordingDesk
) -> None:
    desk.hold = asyncio.Event()
    say = b'{"v": 1, "id": 1, "do": "say", "text": "dance"}\n'
    reader, writer = await asyncio.open_unix_connection(str(served))
    writer.write(say)
    await reader.readline()
    writer.write(b'{"v": 1, "id": 2, "do": "stop"}\n')
    async with asyncio.timeout(2):
        assert json.loads(await reader.readline()) == {"is": "told", "id": 2, "facts": {"epoch": 3}}
        desk.hold.set()
        assert json.loads(await reader.readline())["is"] == "done"
    writer.close()


async def test_so_many_requests_at_a_time_and_no_more(served: Path, desk: RecordingDesk) -> None:
    desk.hold = asyncio.Event()
    reader, writer = await asyncio.open_unix_connection(str(served))
    for number in range(AT_ONCE + 1):
        writer.write(b'{"v": 1, "id": %d, "do": "say", "text": "dance"}\n' % number)
    async with asyncio.timeout(2):
        while (answer := json.loads(await reader.readline()))["is"] == "happened":
            pass
    assert answer == {
        "is": "wrong",
        "id": AT_ONCE,
        "error": f"at most {AT_ONCE} requests at a time",
    }
    writer.close()


async def test_so_many_connections_and_no_more(served: Path) -> None:
    many = [await asyncio.open_unix_connection(str(served)) for _ in range(CONNECTIONS)]
    assert (await talk(served, b'{"v": 1, "do": "status"}\n'))[0]["error"] == "too many connections"
    for _, writer in many:
        writer.close()


async def test_a_client_that_goes_away_is_forgotten(served: Path, desk: RecordingDesk) -> None:
    desk.hold = asyncio.Event()
    await talk(served, b'{"v": 1, "do": "watch"}\n', b'{"v": 1, "do": "say", "text": "dance"}\n')
    await until(lambda: not desk.watchers)


async def test_the_socket_is_for_owner_and_group(served: Path) -> None:
    assert mode(served) == 0o660


async def test_a_second_daemon_is_told_that_the_socket_is_taken(
    served: Path, desk: RecordingDesk
) -> None:
    await talk(served, b'{"v": 1, "do": "status"}\n')
    with pytest.raises(SocketTakenError, match="another sayso answers there"):
        ControlServer(served, desk).bind()
    assert mode(served) is not None


async def test_what_a_killed_daemon_left_behind_is_replaced(
    path: Path, desk: RecordingDesk
) -> None:
    left_behind(path)
    task = asyncio.create_task(ControlServer(path, desk).serve())
    await asyncio.sleep(0)
    assert (await talk(path, b'{"v": 1, "do": "status"}\n'))[0]["is"] == "told"
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task


def left_behind(path: Path) -> None:
    path.parent.mkdir()
    with socket.socket(socket.AF_UNIX) as dead:
        dead.bind(str(path))
    assert path.exists()


async def test_serving_can_be_started_again_after_it_failed(
    path: Path, desk: RecordingDesk
) -> None:
    server = ControlServer(path, desk)
    for _ in range(2):
        task = asyncio.create_task(server.serve())
        await until(lambda: mode(path) is not None)
        assert (await talk(path, b'{"v": 1, "do": "status"}\n'))[0]["is"] == "told"
        task.cancel()
        with suppress(asyncio.CancelledError):
            await task


async def test_lessons_come_in_pages(served: Path) -> None:
    request = messages.Lessons(v=1, id=3, after=1, most=2)
    (answer,) = await asyncio.to_thread(ask, served, request)
    assert isinstance(answer, Told)
    assert answer.id == 3
    assert [row["ident"] for row in answer.facts["lessons"]] == [2, 3]
    assert answer.facts["more"] is True
    end = messages.Lessons(v=1, after=LESSONS - 2, most=2)
    (last,) = await asyncio.to_thread(ask, served, end)
    assert isinstance(last, Told)
    assert last.facts["more"] is False


async def test_a_client_reads_all_pages_and_the_log(served: Path, desk: RecordingDesk) -> None:
    def read() -> tuple[list[int], tuple[Entry, ...]]:
        with Running(Client(served, answer_s=5)) as robot:
            return [row.ident for row in robot.lessons()], robot.log(7)

    numbers, log = await asyncio.to_thread(read)
    assert numbers == list(range(1, LESSONS + 1))
    assert log == (Entry(at_s=1.5, what="said", text="dance"),)
    assert desk.asked == [("log", "7")]


async def test_events_do_not_come_between_what_was_asked_for(
    served: Path, desk: RecordingDesk
) -> None:
    reader, writer = await asyncio.open_unix_connection(str(served))
    desk.hold = asyncio.Event()
    writer.write(messages.line(messages.Log(v=1, id=1)))
    writer.write(messages.line(messages.Say(v=1, id=2, text="dance")))
    answers = [json.loads(await reader.readline()) for _ in range(2)]
    assert {(a["is"], a["id"]) for a in answers} == {("told", 1), ("happened", 2)}
    desk.hold.set()
    writer.close()


async def test_forgetting_is_told_to_the_daemon_or_says_what_is_wrong(
    served: Path, desk: RecordingDesk
) -> None:
    def forget(*numbers: int) -> str:
        with Running(Client(served, answer_s=5)) as robot:
            return robot.forget(numbers, "Mary", lambda _event: None)

    assert await asyncio.to_thread(forget, 2, 4) == "done"
    assert desk.asked == [("forget", "(2, 4)", "Mary", f"control uid={os.getuid()}")]
    with pytest.raises(ReachError, match="there is no lesson 7000"):
        await asyncio.to_thread(forget, 2, 7000)
    assert len(desk.asked) == 1, "nothing was asked for"
    with pytest.raises(ControlError, match="there is no lesson 9"):
        await asyncio.to_thread(ask, served, messages.Forget(v=1, lessons=(9,)))


@pytest.mark.parametrize(
    "request_line",
    [
        b'{"do":"lessons","v":1,"most":501}',
        b'{"do":"lessons","v":1,"most":0}',
        b'{"do":"lessons","v":1,"after":-1}',
        b'{"do":"forget","v":1,"lessons":[]}',
        b'{"do":"forget","v":1,"lessons":["one"]}',
        b'{"do":"forget","v":1,"lessons":[99999999999999999999]}',
        b'{"do":"forget","v":1,"lessons":[' + b",".join([b"1"] * 101) + b"]}",
        b'{"do":"log","v":1,"last":1001}',
        b'{"do":"log","v":2}',
    ],
)
async def test_requests_about_lessons_are_bounded(
    served: Path, desk: RecordingDesk, request_line: bytes
) -> None:
    (answer,) = await talk(served, request_line + b"\n")
    assert answer["is"] == "wrong"
    assert desk.asked == []


def test_a_client_asks_no_faster_than_it_is_answered(monkeypatch: pytest.MonkeyPatch) -> None:
    """A file of many lessons is taught to the end."""
    now_s, asked = 100.0, messages.BURST + 5

    def sleep(seconds: float) -> None:
        nonlocal now_s
        now_s += seconds

    monkeypatch.setattr("daemon.control.client.time.monotonic", lambda: now_s)
    monkeypatch.setattr("daemon.control.client.time.sleep", sleep)

    class Sent:
        count = 0

        def settimeout(self, _: object) -> None: ...
        def connect(self, _: object) -> None: ...
        def makefile(self, _: object) -> list[bytes]:
            return [messages.line(Done(outcome="done"))] * asked

        def sendall(self, _: bytes) -> None:
            self.count += 1

    line = Sent()
    monkeypatch.setattr("daemon.control.client.socket.socket", lambda _: line)
    client = Client(Path("control.sock"))
    for _ in range(asked):
        assert list(client.ask(messages.Say(v=1, text="dance")))
    assert line.count == asked
    assert now_s - 100.0 >= (asked - messages.BURST) / messages.REQUESTS_A_SECOND
