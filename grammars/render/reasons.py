"""Why, in words: who taught what, what followed from it, what stood in the way."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from grammars.morphology import past
from grammars.render.deeds import VerbForm, deed
from grammars.render.english import act_in_words, claim_in_words, definite, render
from grammars.render.moments import moment
from grammars.render.names import proper
from grammars.render.questions import claim
from grammars.render.telling import Telling
from kernel.memory.experience import Source, Trouble
from kernel.memory.explanation import Asked
from kernel.memory.inference import Inference
from kernel.memory.lesson import Lesson
from kernel.net.graphlet import Graphlet

_BEEN = {"is": "was", "am": "was", "are": "were"}


def taught(lesson: Lesson, asked: Asked | None = None) -> str:
    """ "Freddy taught me: never grab a person"; asked: with when it was."""
    return f"{teacher(lesson, asked)}: {exact_words(lesson)}"


def said_by(name: str, verb: str = "told") -> str:
    """ "Mary told me", "I was taught"."""
    return f"{proper(name)} {verb} me" if name else f"I was {verb}"


def teacher(lesson: Lesson, asked: Asked | None = None) -> str:
    """ "Freddy taught me", "Mary told me today at 14:05"; who is not known, or nobody."""
    verb = "told" if lesson.kind == "fact" else "taught"
    if not lesson.words and lesson.ident > 0:
        said = "I found out by myself"
    elif lesson.ident < 0:
        said = "I was born knowing"
    else:
        said = said_by(lesson.teacher, verb)
    when = moment(lesson.at_s, asked.at_s, asked.utc_offset_s) if asked else ""
    return f"{said} {when}".rstrip()


def told(source: Source, asked: Asked | None = None) -> str:
    """ "Mary told me: the red block is heavy"."""
    when = moment(source.at_s, asked.at_s, asked.utc_offset_s) if asked else ""
    return f"{said_by(source.teacher)} {when}".rstrip() + f": {_bare(source.words)}"


def exact_words(lesson: Lesson) -> str:
    """The teacher's words as they were said, without the full stop; the net in words where there are none."""
    return _bare(lesson.words) or render(lesson.content, "teacher")


def _bare(words: str) -> str:
    return words.strip().rstrip(".!").strip()


def reasoning(steps: Sequence[Inference]) -> str:
    """ "Mary is a girl, and Janey taught me: a girl is a person"."""
    facts = [claim_in_words(fact) for step in steps for fact in step.told]
    return ", and ".join([*dict.fromkeys(facts), *(taught(step.lesson) for step in steps)])


def what_was(fact: Graphlet) -> str:
    """What was so then: "something was very close"."""
    main = fact.head
    if main is not None and main.kind == "input":  # somebody spoke: docs/net.md, NOTE[tell]
        speakers = [other for role, other in main.links if role == "agt"]
        names = [min(t.lex - {"me"}, default="") for t in fact if t.name in speakers]
        return f"{proper(next(filter(None, names), 'somebody'))} said something to me"
    said = claim(Telling((definite(fact),), (), "robot"), fact)
    if said.verb in _BEEN:
        return f"{said.subject} {_BEEN[said.verb]}{said.stated.removeprefix(said.verb)}"
    if said.stated.startswith(f"{said.verb} not"):
        return f"{said.subject} did {said.asked}"
    return f"{said.subject} {past(said.asked)}"


def lines(sentences: Iterable[str]) -> str:
    """Sentences one behind the other, each with a capital and a full stop."""
    return " ".join(f"{s[:1].upper()}{s[1:].rstrip('.')}." for s in sentences if s)


def asked_act(about: Graphlet, form: VerbForm = "base") -> str:
    """An act as it was asked about: "make a square", where `act_in_words` would know which square."""
    return deed(Telling((about,), (), "robot"), about.main, form)


def same_act(one: Graphlet | None, other: Graphlet | None) -> bool:
    """Both are told in the same words."""
    return None not in (one, other) and act_in_words(one) == act_in_words(other)  # type: ignore[arg-type]


def forbidden(trouble: Trouble) -> bool:
    """It was a prohibition, and which one is known."""
    return trouble.reason == "prohibited" and trouble.by is not None
