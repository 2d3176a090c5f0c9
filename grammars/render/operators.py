"""Operators as the sentences that teach them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from grammars.hedges import PREFERENCE
from grammars.render.clauses import conditions
from grammars.render.deeds import deed
from grammars.render.names import literally, pronoun
from grammars.render.procedures import claimed, procedure, without
from grammars.render.telling import Telling, Voice, linked, word
from grammars.render.things import thing
from grammars.render.wondering import wonder, wonders
from grammars.usage import particles
from grammars.vocabulary import BORN
from kernel.memory.lesson import LEARN, Operator
from kernel.net.graphlet import Graphlet, Term

_STRENGTHS: Final = {value: words for words, value in reversed(PREFERENCE.items())} | {1.0: ""}


@dataclass(frozen=True, slots=True)
class Wording:
    """A lesson in words: "never | touch the stove | if it is hot | unless Mary is near"."""

    lead: str
    about: str
    given: str
    rest: str

    def __str__(self) -> str:
        given = f" if {self.given}" if self.given else ""
        return f"{self.lead} {self.about}{given}{self.rest}".strip()


def worded(content: Operator, voice: Voice) -> Wording:
    """The sentence that teaches an operator, in its parts."""
    graphlets = list(content.chain.graphlets())
    trigger = content.trigger.graphlet
    tellings = [
        g for g in content.unless if g.head and linked(g.head, "cmd") == _main(content) != ""
    ]
    described = (*((trigger,) if trigger else ()), *tellings, *graphlets)
    claims = [g for g in content.unless if g not in tellings]
    telling = Telling(described, (*content.enablement, *claims), voice)
    own = trigger.names if trigger else frozenset()
    telling.hold_back(term for term in claimed(content.chain) if term.name not in own)
    match content.trigger.tag:
        case "ANTE" if content.prohibits:
            return _prohibition(telling, content)
        case "ALLOW" if (cause := _teller(content)) is not None:
            may = _may_tell(telling, [cause], content)
            return Wording("", may, _enabled(telling, content), "")
        case "ALLOW" if _leads_there(telling, content):
            are = "I am" if voice == "robot" else "you are"
            near = thing(telling, linked(telling.term(_main(content)), "dest"))
            given = _enabled(telling, content)
            return Wording(f"{are} allowed near", near, given, _except(telling, content))
        case "ALLOW":
            may = deed(telling, _main(content))
            given = _enabled(telling, content)
            return Wording(f"{_self(telling)} may", may, given, _except(telling, content))
    lead, about = _occasion(telling, content)
    given = _enabled(telling, content)
    return Wording(lead, about, given, f", {_advice(telling, content)}{_except(telling, content)}")


def _occasion(telling: Telling, content: Operator) -> tuple[str, str]:
    """When something is to be done, or what is done so: "if | something is close", "to | dance"."""
    trigger = content.trigger.graphlet
    assert trigger is not None
    match content.trigger.tag:
        case "DO":
            return _goal(telling, content)
        case "NOTE":
            return "if" if telling.voice == "teacher" else "when", conditions(telling, trigger)
        case "ANTE" | "POST":
            return _around(telling, content)
        case "FIND" if wonders(telling, _main(content)):
            return "to find out", wonder(telling, _main(content))
        case "FIND":
            return "to find", thing(telling, _main(content))
        case "CHK":
            return "to check whether", conditions(telling, trigger)
        case "ACH":
            return "to make sure", conditions(telling, trigger)
    raise ValueError(f"no words for an operator on {content.trigger.tag}")


def shortened(content: Operator, act: str) -> list[str]:
    """What an operator is about in fewer words, the better ones first; act: the trigger's action in words."""
    verb, more = act.partition(" ")[0], " " in act
    match content.trigger.tag:
        case "DO":
            return [f"I know how to {act}", f"I know how to {'do that' if more else verb}"]
        case "ANTE" if content.prohibits:
            cause = _teller(content)
            if cause is not None and content.trigger.graphlet:
                telling = Telling((content.trigger.graphlet,), (), "robot")
                if telling.term(_main(content)).lex == {LEARN}:
                    return [f"I will not learn from {thing(telling, linked(cause, 'agt'))}"]
                return [f"I will not always obey {thing(telling, linked(cause, 'agt'))}"]
            return [f"I will not {act}", f"I will not always {verb}"]
        case "ALLOW" if (cause := _teller(content)) is not None and content.trigger.graphlet:
            telling = Telling((content.trigger.graphlet,), (), "robot")
            return [f"I may obey {thing(telling, linked(cause, 'agt'))}"]
        case "ALLOW":
            return [f"I may {act}", f"sometimes I may {verb}"]
        case "FIND" | "CHK" as tag:
            return ["I know how to find that" if tag == "FIND" else "I know how to check that"]
        case "NOTE":
            return _steps(content, "then")
        case "ANTE":
            return _steps(content, "first")
        case "POST":
            return _steps(content, "afterwards")
    return []


def _steps(content: Operator, when: str) -> list[str]:
    """ "I will drive backward then"; words to be said are not said here, they would be taken for the deed."""
    graphlets = [d.graphlet for d in content.chain.directives() if d.graphlet]
    steps = [g for g in graphlets if g.main.startswith("act")]
    trigger = content.trigger.graphlet
    telling = Telling((*((trigger,) if trigger else ()), *graphlets), (), "robot")
    if len(steps) != 1:
        return [f"I will do all that {when}"]
    quoting = any(term.literal is not None and not term.links for term in steps[0])
    done = "say that" if quoting else deed(telling, steps[0].main)
    return [f"I will {done} {when}", f"I will {done.partition(' ')[0]} {when}"]


def _main(content: Operator) -> str:
    return content.trigger.graphlet.main if content.trigger.graphlet else ""


def _self(telling: Telling) -> str:
    return "I" if telling.voice == "robot" else "you"


def _advice(telling: Telling, content: Operator) -> str:
    """The chain behind "you could" or "I will"."""
    said = procedure(telling, content.chain)
    strength = _STRENGTHS[min(_STRENGTHS, key=lambda known: abs(known - content.preference))]
    if telling.voice == "robot":
        return f"I {strength or 'will'} {said}"
    return f"you {strength} {said}" if strength else said


def _goal(telling: Telling, content: Operator) -> tuple[str, str]:
    """ "To dance"; where the verb is the teacher's own and no word for a deed, "when I say "make way""."""
    trigger = content.trigger.graphlet
    phrase = word(telling.term(_main(content)))
    known = BORN.knows(phrase) and "VERB" not in BORN.readings(phrase)
    own = (known or " " in phrase) and not phrase.startswith("be ")
    if trigger and len(trigger.terms) == 1 and own and phrase not in particles():
        return f"when {pronoun(telling, 'me', 'subject')} say", literally(phrase)
    return "to", deed(telling, _main(content))


def _around(telling: Telling, content: Operator) -> tuple[str, str]:
    when = "before" if content.trigger.tag == "ANTE" else "after"
    if (cause := _teller(content)) is not None:
        return when, _told(telling, cause)
    return f"{when} {_self(telling)}", deed(telling, _main(content))


def _teller(content: Operator) -> Term | None:
    """The speech act that the trigger's action came from, if the trigger asks for one."""
    trigger = content.trigger.graphlet or ()
    return next((term for term in trigger if linked(term, "cmd") == _main(content)), None)


def _told(telling: Telling, cause: Term) -> str:
    """ "Rick tells you to do something"."""
    speaker = thing(telling, linked(cause, "agt"), "subject")
    hearer = thing(telling, linked(cause, "dest"))
    verb = "asks" if word(cause) == "ask" else "tells"
    return f"{speaker} {verb} {hearer} to {deed(telling, linked(cause, 'cmd'))}"


def _prohibition(telling: Telling, content: Operator) -> Wording:
    robot = telling.voice == "robot"
    cause = _teller(content)
    tellers = [term for graphlet in content.unless for term in graphlet if _tells(term, content)]
    if cause is not None and telling.term(_main(content)).lex == {LEARN}:
        lead = f"{'I will' if robot else 'do'} not let"
        about, end = thing(telling, linked(cause, "agt")), f" teach {'me' if robot else 'you'}"
    elif cause is not None:
        lead, about, end = "if", _told(telling, cause), f", {'I will not' if robot else 'do not'}"
        about = " and ".join(filter(None, (about, _enabled(telling, content))))
        end += _except(telling, content)
        return Wording(lead, about, "", end + _instead(telling, content))
    elif tellers:
        return Wording("only", _may_tell(telling, tellers, content), "", "")
    else:
        lead, about = _kept_from(telling, content)
        given = _enabled(telling, content)
        end = _except(telling, content) + _instead(telling, content)
        return Wording(lead, about, given, end)
    return Wording(lead, about, "", end + _instead(telling, content))


def _instead(telling: Telling, content: Operator) -> str:
    """What is done in the place of what is forbidden."""
    instead = without(content.chain, "PUNT")
    if not instead.plays:
        return ""
    how = ", instead I will" if telling.voice == "robot" else " but instead"
    return f"{how} {procedure(telling, instead)}"


def _kept_from(telling: Telling, content: Operator) -> tuple[str, str]:
    """ "Never touch the stove"; "keep away from the stairs" where it is any deed that leads there."""
    robot = telling.voice == "robot"
    act = telling.term(_main(content))
    if _leads_there(telling, content):
        away = thing(telling, linked(act, "dest"))
        return f"{'I will ' if robot else ''}keep away from", away
    return "I will never" if robot else "never", deed(telling, act.name)


def _leads_there(telling: Telling, content: Operator) -> bool:
    """It is any deed that leads to something."""
    act = telling.term(_main(content))
    return not act.lex and [role for role, _ in act.links] == ["dest"]


def _tells(term: Term, content: Operator) -> bool:
    """That the act is what somebody tells the robot to do."""
    return linked(term, "cmd") == _main(content)


def _may_tell(telling: Telling, causes: list[Term], content: Operator) -> str:
    """ "Mary may tell you to drive backward"."""
    speakers = [thing(telling, linked(cause, "agt"), "subject") for cause in causes]
    hearer = thing(telling, linked(causes[0], "dest"))
    if telling.term(_main(content)).lex == {LEARN}:
        return f"{' or '.join(speakers)} may teach {hearer}"
    return f"{' or '.join(speakers)} may tell {hearer} to {deed(telling, _main(content))}"


def _enabled(telling: Telling, content: Operator) -> str:
    return " and ".join(conditions(telling, graphlet) for graphlet in content.enablement)


def _except(telling: Telling, content: Operator) -> str:
    return ways_out(telling, content.unless)


def ways_out(telling: Telling, unless: tuple[Graphlet, ...]) -> str:
    """When it does not hold."""
    said = " or ".join(conditions(telling, graphlet) for graphlet in unless)
    return f" unless {said}" if said else ""
