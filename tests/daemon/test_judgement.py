"""Every form, fulfilled and not, over events and poses made by hand."""

from dataclasses import replace

import pytest

from daemon import events as ev
from daemon.expectation import expectation
from daemon.judgement import Outcome, Turn, judge
from daemon.motion import Sample

SAID = (ev.SayStarted(t=1.0, text="Coming through!"), ev.SayEnded(t=1.7, text="Coming through!"))
CUT = (SAID[0], ev.SayEnded(t=1.2, text="Coming through!", cut=True))
VETO = ev.Prohibited(t=0.1, by="never turn right")
ASKED = ev.Question(t=0.1, text="which block?")
TAKEN = ev.Acknowledged(t=0.1, text="okay")
LEARNED = ev.Lesson(t=0.1, ident=1, kind="rule", words="w", readback="r")
FAILED = ev.Replied(t=0.1, kind="Failed", shown="I can't", spoken="I can't", ok=False)
ANSWERED = ev.Replied(t=0.1, kind="Answer", shown="no idea", spoken="no idea", ok=False)
STOPPED = ev.Stopped(t=1.0, source="typed", epoch=1)


def moving(
    *,
    cm: float = 0,
    deg: float = 0,
    lift: float = 0,
    grip: float = 0,
    held: str = "",
    at_s: float = 1.0,
) -> tuple[Sample, ...]:
    """A second of motion from at_s on, sampled every 50 ms for three seconds."""

    def sample(t: float) -> Sample:
        part = min(max(t - at_s, 0.0), 1.0)
        return Sample(t, cm * part, 0, deg * part, 300 + lift * part, 700 + grip * part, held)

    return tuple(sample(i * 0.05) for i in range(61))


def then(first: tuple[Sample, ...], second: tuple[Sample, ...]) -> tuple[Sample, ...]:
    """The second motion goes on from where the first ended."""
    end = first[-1]
    return first + tuple(
        replace(
            s,
            t_s=s.t_s + end.t_s,
            x_cm=s.x_cm + end.x_cm,
            heading_deg=s.heading_deg + end.heading_deg,
            lift_permille=s.lift_permille + end.lift_permille - 300,
        )
        for s in second[1:]
    )


def check(line: str, samples: tuple[Sample, ...] = (), *events: ev.Event) -> Outcome:
    ended_s = samples[-1].t_s if samples else 3.0
    (outcome,) = judge([expectation(line)], Turn(events, samples or moving(), 0.0, ended_s))
    return outcome


STILL = moving()
TABLE: list[tuple[str, tuple[Sample, ...], tuple[ev.Event, ...], bool]] = [
    ('says "coming through"', STILL, SAID, True),
    ('says "COMING, through?"', STILL, SAID, True),
    ('says "coming"', STILL, SAID, False),
    ('says "hi" or "coming through"', STILL, SAID, True),
    ('says "coming through"', STILL, CUT, False),
    ('says "coming through"', STILL, SAID[:1], True),
    ('says "coming through"', STILL, SAID[1:], True),
    ('says "coming through"', STILL, (), False),
    ('says "no"', STILL, (ev.SayStarted(t=1, text="Sorry. No."), ev.SayEnded(t=2, text="Sorry. No.")), True),
    ('does not say "through"', STILL, SAID, False),
    ('does not say "coming by"', STILL, SAID, True),
    ("asks", STILL, (ASKED,), True),
    ("asks", STILL, (TAKEN,), False),
    ("acknowledges", STILL, (TAKEN,), True),
    ("acknowledges", STILL, (LEARNED,), True),
    ("acknowledges", STILL, (VETO,), False),
    ("refuses", STILL, (VETO,), True),
    ("refuses", STILL, (FAILED,), True),
    ("refuses", STILL, (ANSWERED,), False),
    ("refuses", STILL, (TAKEN,), False),
    ("does not move", STILL, (), True),
    ("does not move", moving(cm=20), (), False),
    ("does not move", moving(deg=-20), (), False),
    ("does not move", moving(lift=200), (), False),
    ("does not move", moving(grip=-200), (), False),
    ("does not move", moving(cm=5, at_s=0.2), (STOPPED,), True),
    ("does not move", moving(cm=20, at_s=1.0), (STOPPED,), False),
    ("moves forward 15..25 cm", moving(cm=20), (), True),
    ("moves forward 15..25 cm", moving(cm=26), (), False),
    ("moves forward 15..25 cm", moving(cm=-20), (), False),
    ("moves backward 15..25 cm", moving(cm=-20), (), True),
    ("moves backward 15..25 cm", then(moving(cm=-20), moving(cm=-20)), (), False),
    ("moves forward 0..5 cm", STILL, (), True),
    ("moves forward 1..5 cm", STILL, (), False),
    ("moves forward", STILL, (), False),
    ("turns left 80..100 degrees", moving(deg=90), (), True),
    ("turns left 80..100 degrees", moving(deg=-90), (), False),
    ("turns right 80..100 degrees", moving(deg=-90), (), True),
    ("turns right", moving(deg=-30), (), True),
    ("arcs left", moving(cm=20, deg=90), (), True),
    ("arcs right", moving(cm=20, deg=90), (), False),
    ("arcs left", then(moving(cm=20), moving(deg=90)), (), False),
    ("lifts", moving(lift=300), (), True),
    ("lifts", moving(lift=-300), (), False),
    ("lowers", moving(lift=-300), (), True),
    ("closes the gripper", moving(grip=-600), (), True),
    ("closes the gripper", moving(grip=300), (), False),
    ("opens the gripper", moving(grip=300), (), True),
    ("holds red block", moving(held="red block"), (), True),
    ("holds block", moving(held="red block"), (), True),
    ("holds blue block", moving(held="red block"), (), False),
    ("holds block", STILL, (), False),
    ("holds nothing", STILL, (), True),
    ("holds nothing", moving(held="cup"), (), False),
    ("moves forward, then turns left", then(moving(cm=20), moving(deg=90)), (), True),
    ("moves forward, then turns left", then(moving(deg=90), moving(cm=20)), (), False),
    ("moves forward, then turns left", moving(cm=20, deg=90), (), False),
    ("turns left 80..100 degrees, then turns left 80..100 degrees", moving(deg=180), (), True),
    ("turns left 80..100 degrees, then turns left 80..100 degrees", moving(deg=90), (), False),
    (
        "turns left 80..100 degrees, then lifts, then turns left 80..100 degrees",
        then(then(moving(deg=90), moving(lift=300)), moving(deg=90)), (), True,
    ),
    ('says "coming through", then lifts', moving(lift=300, at_s=1.7), SAID, True),
    ('says "coming through", then lifts', moving(lift=300, at_s=0), SAID, False),
    ('lifts, then says "coming through"', moving(lift=300, at_s=0), SAID, True),
    ('says "coming through" at the same time lifts', moving(lift=300), SAID, True),
    ('says "coming through" at the same time lifts', moving(lift=300, at_s=1.8), SAID, False),
    ("closes the gripper, then holds cup", moving(grip=-600, held="cup"), (), True),
    ("closes the gripper, then holds cup", moving(grip=-600), (), False),
    ("lifts; refuses", moving(lift=300), (VETO,), True),
    ("lifts; refuses", moving(lift=300), (), False),
    ("does a little dance", STILL, (), True),
]  # fmt: skip


@pytest.mark.parametrize(
    ("line", "samples", "events", "ok"), TABLE, ids=[f"{row[0]} {row[3]}" for row in TABLE]
)
def test_a_form_holds_or_not(
    line: str, samples: tuple[Sample, ...], events: tuple[ev.Event, ...], ok: bool
) -> None:
    assert check(line, samples, *events).ok is ok


def test_lines_of_one_turn_are_in_order() -> None:
    turn = Turn(SAID, moving(lift=300, at_s=2.0), 0.0, 3.0)
    says, lifts = expectation('says "coming through"'), expectation("lifts")
    assert [outcome.ok for outcome in judge([says, lifts], turn)] == [True, True]
    assert [outcome.ok for outcome in judge([lifts, says], turn)] == [True, False]


def test_the_diff_names_what_was_missing_and_what_happened_instead() -> None:
    outcome = check("turns left 80..100 degrees; acknowledges", moving(deg=-90), VETO)
    assert outcome.diff().splitlines() == [
        "- expected: turns left 80..100 degrees",
        "- expected: acknowledges",
        "+ happened: refuses (never turn right)",
        "+ happened: turns right 90 degrees",
    ]


def test_the_diff_says_nothing_where_nothing_happened() -> None:
    assert check("lifts").diff() == "- expected: lifts\n+ happened: nothing"
