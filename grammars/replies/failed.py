"""An act came to nothing: why, in one sentence."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from grammars.render import act_in_words, claim_in_words, definite, thing_in_words
from grammars.render.names import PRONOUNS, proper
from grammars.render.questions import indirect
from grammars.replies import Said, both, renders
from grammars.vocabulary import BORN
from kernel.memory.lesson import LEARN
from kernel.memory.meaning import Question
from kernel.memory.reply import Failed, Reason
from kernel.net.graphlet import Term


@renders(Failed)
def failed(reply: Failed) -> Said:
    """ "I don't know how to salute." """
    return both(failure(reply))


def failure(reply: Failed) -> str:
    """The reason as a clause, to be said by itself or behind "because"."""
    return _SENTENCES[reply.reason](reply)


def _act(reply: Failed, form: str = "base") -> str:
    if reply.act is None or not _is_act(reply):
        return "doing that" if form == "gerund" else "do that"
    if _verb(reply) == LEARN:
        return "learning that" if form == "gerund" else "learn that"
    return act_in_words(reply.act, reply.about, "gerund" if form == "gerund" else "base")


def _is_act(reply: Failed) -> bool:
    return reply.act is not None and reply.act.main.startswith("act")


def _verb(reply: Failed) -> str:
    """The bare verb."""
    if reply.act is None or not _is_act(reply):
        return "do"
    return min(reply.act.head.lex if reply.act.head is not None else (), default="do")


def _not_grounded(reply: Failed) -> str:
    word, verb = reply.detail, _verb(reply)
    if word in ("", verb):
        return f"I don't know how to {_act(reply)}"
    if word in _MISSING:
        return _MISSING[word].format(verb=verb)
    terms: list[Term] = [t for g in (reply.act, *reply.about) for t in g or ()]
    roles = {role for term in terms if word in term.lex for role, _ in term.links}
    kind = next((said for role, said in _WORD_KINDS.items() if role in roles), "word")
    return f"I don't know the {kind} {word}"


def _nothing_found(reply: Failed) -> str:
    wanted = _wanted(reply)
    if wanted in ("", *PRONOUNS):
        return f'I don\'t know what you mean by "{wanted or "that"}"'
    return f"I don't know where {wanted} is"


def _wanted(reply: Failed) -> str:
    """The thing that was looked for: what the act goes to or takes, the thing itself, or its bare name or kind."""
    name = reply.act.main if reply.act is not None else ""
    if reply.act is not None and _is_act(reply):
        links = dict(link for term in reply.act if term.name == name for link in term.links)
        name = links.get("dest") or links.get("obj", "")
    if name:
        return thing_in_words(name, tuple(g for g in (reply.act, *reply.about) if g))
    if reply.detail in ("", *PRONOUNS):
        return reply.detail
    readings = BORN.readings(reply.detail)
    named = "PROPER" in readings and "NOUN" not in readings
    return proper(reply.detail) if named else f"the {reply.detail}"


def _conflict(reply: Failed) -> str:
    return f"I can't do two things with my {reply.detail or 'body'} at the same time"


def _not_so(reply: Failed) -> str:
    """What was to be so is not: "the block is not red"."""
    if not reply.about:
        return "that is not so"
    return claim_in_words(reply.about[0].denied())


def _not_achieved(reply: Failed) -> str:
    if not reply.about:
        return "I don't know how to make that so"
    return f"I could not make sure that {claim_in_words(reply.about[0])}"


def _not_known(reply: Failed) -> str:
    return f"I could not find out {_wondered(reply)}"


def _wondered(reply: Failed) -> str:
    """ "Whether the block is red", "what color it is"."""
    if not reply.about:
        return "that"
    about = definite(reply.about[0])
    main = about.head or Term(about.main)
    if main.lex or main.kind not in ("hq", "ako", "loc"):
        return indirect(Question("yesno", about), "robot")
    ask = "where" if main.kind == "loc" else "what"
    return indirect(Question(ask, about, about.main), "robot")  # type: ignore[arg-type]


def _not_answered(reply: Failed) -> str:
    if not reply.about:
        return "I don't know which one you mean"
    which = thing_in_words(reply.about[0].main, reply.about).removeprefix("the ")
    return f"I don't know which {which} you mean"


# What a command left out, by the name that the grounding functions give it.
_MISSING: Final = {
    "direction": "you did not say which way to {verb}",
    "words": "you did not say what to {verb}",
    "way there": "I don't know the way there",
}
_WORD_KINDS: Final = {"dir": "direction", "amt": "unit", "mod": "word", "loc": "place"}

_SENTENCES: Final[dict[Reason, Callable[[Failed], str]]] = {
    "no_way": lambda r: f"I don't know how to {_act(r)}",
    "given_up": lambda r: f"I was taught to give up {_act(r, 'gerund')}",
    "not_grounded": _not_grounded,
    "prohibited": lambda r: f"I may not {_act(r)}",
    "nothing_found": _nothing_found,
    "no_sense": lambda r: "I have no way to see that",
    "nothing_gripped": lambda r: "I have nothing in my gripper",
    "too_much": lambda r: f"I can't {_verb(r)} more than {r.detail or 'that'} at once",
    "link_lost": lambda r: "I have lost the robot",
    "stuck": lambda r: "I am stuck",
    "stopped": lambda r: f"I stopped {_act(r, 'gerund')}",
    "resource_lost": lambda r: f"I gave up {_act(r, 'gerund')} as something else kept me busy",
    "recursion": lambda r: f"I can't {_act(r)} as that would never end",
    "too_deep": lambda r: f"I can't {_act(r)} as that has too many steps within steps",
    "runaway": lambda r: "I stopped repeating that as it took no time at all",
    "not_achieved": _not_achieved,
    "conflict": _conflict,
    "no_room": lambda r: "I have too much on my mind, please say that again later",
    "not_yours": lambda r: (
        f"only {proper(r.detail) + ' or ' if r.detail else ''}my owner may change that"
    ),
    "not_stored": lambda r: f"I could not keep that{': ' + r.detail if r.detail else ''}",
    "not_so": _not_so,
    "not_known": _not_known,
    "not_answered": _not_answered,
    "crashed": lambda r: f"something in me broke while {_act(r, 'gerund')}",
}
