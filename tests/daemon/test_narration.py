"""What a watcher is told."""

from daemon import events as ev
from daemon.expectation import expectation
from daemon.judgement import Turn, judge
from daemon.narration import entered, judged, told

TURN = Turn((ev.SayStarted(t=0.1, text="hi"), ev.SayEnded(t=0.4, text="hi")), (), 0.0, 1.0)


def test_an_event_is_told_with_its_time() -> None:
    text = told(ev.SayStarted(t=12.345, text="hi"))
    assert text is not None
    assert text.plain.split() == ["12.35", "s", "said", "hi"]


def test_what_only_programs_need_is_not_told() -> None:
    assert told(ev.Noted(t=0, what="focus", text="x")) is None


def test_a_line_of_the_file_is_told_as_it_stands() -> None:
    assert entered("you: hi").plain.strip() == "you: hi"


def test_expectations_are_told_as_held_failed_with_a_diff_or_not_checked() -> None:
    lines = [expectation('says "hi"'), expectation('says "no"'), expectation("waves")]
    held, failed, comment = judge(lines, TURN)
    assert judged(held).plain.strip() == 'as expected: says "hi"'
    assert judged(failed).plain.split("\n") == [
        '  FAILED: says "no"',
        '    - expected: says "no"',
        '    + happened: says "hi"',
    ]
    assert judged(comment).plain.strip() == "not checked: waves"
