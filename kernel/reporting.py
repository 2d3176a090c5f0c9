"""A command that ends in finding something out: the person wants to hear what came of it."""

from __future__ import annotations

from kernel.action.chain import Chain, Directive
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.memory.meaning import Question
from kernel.memory.reply import Answer
from kernel.memory.wondering import is_thing, spelled_out
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet
from kernel.running import Frame


def commanded(frame: Frame, chain: Chain) -> Run:
    """Run a command's chain; where its last step is to check or to find something out, report on that."""
    last = _inquiry(chain)
    if last is None:
        return (yield from frame.command(chain, frame.focus.words))
    verdict = yield from frame.command(Chain(chain.plays[:-1]), frame.focus.words)
    if not verdict.ok:
        return verdict
    assert last.graphlet is not None
    about = spelled_out(last.graphlet, frame.binding)
    verdict = yield from frame.chain(Chain(chain.plays[-1:]))
    # Whatever it is, it was found out, or it is said that it could not be: no complaint beside that.
    frame.focus.failure = None
    frame.commons.replies.append(_report(frame, last, about, verdict))
    return Verdict.SUCCEEDED


def _inquiry(chain: Chain) -> Directive | None:
    """The last step, if it is CHK, or FIND for what something is like."""
    part = chain.plays[-1].only if chain.plays else None
    if not isinstance(part, Directive) or part.graphlet is None:
        return None
    asks = part.tag == "CHK" or (part.tag == "FIND" and not is_thing(part.graphlet))
    return part if asks else None


def _report(frame: Frame, last: Directive, about: Graphlet, verdict: Verdict) -> Answer:
    main = about.main
    if last.tag == "CHK":
        told = {Verdict.SUCCEEDED: "yes", Verdict.FAILED: "no"}
        return Answer(Question("yesno", about), told.get(verdict, "unknown"))  # type: ignore[arg-type]
    ask = "where" if main.startswith("loc") else "what"
    question = Question(ask, about, main)  # type: ignore[arg-type]
    if not verdict.ok:
        return Answer(question, "unknown")
    return Answer(question, "found", (describe(frame.binding[main]),))
