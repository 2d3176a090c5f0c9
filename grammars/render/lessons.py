"""Operators, rules and facts as the sentences that teach them."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from grammars.build import particles
from grammars.hedges import BELIEF, PREFERENCE
from grammars.morphology import plural
from grammars.render.clauses import conditions, wonder, wonders
from grammars.render.deeds import deed
from grammars.render.procedures import claimed, procedure, without
from grammars.render.telling import SAYING, Telling, Voice, is_predicate, linked, word
from grammars.render.things import literally, pronoun, thing
from grammars.vocabulary import BORN
from kernel.memory.lesson import LEARN, Operator, Rule
from kernel.net.graphlet import Graphlet, Term

_STRENGTHS: Final = {value: words for words, value in reversed(PREFERENCE.items())} | {1.0: ""}
_HEDGES: Final = {value: words for words, value in reversed(BELIEF.items())} | {1.0: ""}


def hedge(belief: float) -> str:
    """The adverb for a belief; of an adapted one the nearest."""
    return _HEDGES[min(_HEDGES, key=lambda known: abs(known - belief))]


def operator(content: Operator, voice: Voice) -> str:
    """The sentence that teaches an operator."""
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
        case "DO":
            return _procedure(telling, content, _goal(telling, content))
        case "NOTE":
            assert trigger is not None
            lead = "if" if voice == "teacher" else "when"
            said = f"{lead} {conditions(telling, trigger)}{_enabled(telling, content)}"
            return f"{said}, {_advice(telling, content)}{_except(telling, content)}"
        case "ANTE" if content.prohibits:
            return _prohibition(telling, content)
        case "ANTE" | "POST":
            return _around(telling, content)
        case "ALLOW" if (cause := _teller(content)) is not None:
            return _may_tell(telling, cause, content)
        case "ALLOW":
            may = deed(telling, _main(content))
            return (
                f"{_self(telling)} may {may}{_enabled(telling, content)}{_except(telling, content)}"
            )
        case "FIND" if wonders(telling, _main(content)):
            return _procedure(telling, content, f"to find out {wonder(telling, _main(content))}")
        case "FIND":
            return _procedure(telling, content, f"to find {thing(telling, _main(content))}")
        case "CHK" | "ACH" as tag:
            assert trigger is not None
            wanted = "check whether" if tag == "CHK" else "make sure"
            return _procedure(telling, content, f"to {wanted} {conditions(telling, trigger)}")
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


def rule(content: Rule, voice: Voice) -> str:
    """The sentence that teaches a rule."""
    condition, conclusion = content.condition, content.conclusion
    if content.is_alias:
        return f"{word(condition.terms[0])} means {word(conclusion.terms[0])}"
    telling = Telling((condition,), (conclusion, *content.unless), voice)
    said = f"if {conditions(telling, condition)}, "
    said += conditions(telling, conclusion, hedge(content.belief))
    return said + "".join(f" unless {conditions(telling, g)}" for g in content.unless)


def generic(content: Rule) -> str:
    """A rule from one kind to a kind or quality in few words, "girls are usually female"; "" for others."""
    left, right = content.condition.terms, content.conclusion.terms
    if content.unless or len(left) != 1 or len(right) != 1:
        return ""
    of, said = left[0], right[0]
    roles = {role for role, _ in said.links}
    if (
        not linked(of, "ako")
        or of.negated
        or not roles <= {"ako", "hq"}
        or of.links[0][1] != said.links[0][1]
    ):
        return ""
    adverb = hedge(content.belief)
    denied = "not" if said.negated else ""
    what = plural(word(said)) if "ako" in roles else word(said)
    return " ".join(filter(None, (plural(word(of)), "are", denied, adverb, what)))


def fact(content: Graphlet, finds: tuple[Graphlet, ...], voice: Voice) -> str:
    """The sentence that tells a fact about the things looked up."""
    main = content.head
    if main and not finds and len(content.terms) > 1 and not is_predicate(main):
        content, finds = _named(content, main)
    subjects = [other for role, other in main.links if role in SAYING] if main else []
    if main and subjects and _is_new(content, finds, subjects[0]):
        told = content.denied() if main.negated else content
        said = thing(Telling((*finds, told), (), voice), subjects[0])
        return f"there is {f'no {_bare(said)}' if main.negated else said}"
    belief = main.belief if main else 1.0
    return conditions(Telling(finds, (content,), voice), content, hedge(belief))


def _bare(phrase: str) -> str:
    """The noun phrase without its article."""
    return phrase.removeprefix("an ").removeprefix("a ")


def _named(content: Graphlet, main: Term) -> tuple[Graphlet, tuple[Graphlet, ...]]:
    """A name, and what was given it, which are kept as one."""
    others = tuple(term for term in content.terms if term is not main)
    described = Graphlet((replace(main, lex=frozenset()), *others), main.name)
    return Graphlet((replace(main, ref=""),), main.name), (described,)


def _is_new(content: Graphlet, finds: tuple[Graphlet, ...], name: str) -> bool:
    """A thing of some kind that was not known before: "a red block"."""
    told = Telling((content,))
    found = any(find.main == name for find in finds)
    named = told.term(name).lex or told.term(name).ref or told.about(name, "own")
    return bool(told.about(name, "ako")) and not found and not named


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


def _goal(telling: Telling, content: Operator) -> str:
    """ "To dance"; where the verb is the teacher's own and no word for a deed, "when I say "make way""."""
    trigger = content.trigger.graphlet
    phrase = word(telling.term(_main(content)))
    known = BORN.knows(phrase) and "VERB" not in BORN.readings(phrase)
    own = known or " " in phrase
    if trigger and len(trigger.terms) == 1 and own and phrase not in particles():
        speaker = pronoun(telling, "me", "subject")
        return f"when {speaker} say {literally(phrase)}"
    return f"to {deed(telling, _main(content))}"


def _procedure(telling: Telling, content: Operator, goal: str) -> str:
    enabled = _enabled(telling, content)
    return f"{goal}{enabled}, {_advice(telling, content)}{_except(telling, content)}"


def _around(telling: Telling, content: Operator) -> str:
    when = "before" if content.trigger.tag == "ANTE" else "after"
    cause = _teller(content)
    act = (
        f"{_self(telling)} {deed(telling, _main(content))}"
        if cause is None
        else _told(telling, cause)
    )
    enabled = _enabled(telling, content)
    return f"{when} {act}{enabled}, {_advice(telling, content)}{_except(telling, content)}"


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


def _prohibition(telling: Telling, content: Operator) -> str:
    instead = without(content.chain, "PUNT")
    robot = telling.voice == "robot"
    cause = _teller(content)
    if cause is not None and telling.term(_main(content)).lex == {LEARN}:
        teacher = thing(telling, linked(cause, "agt"))
        said = f"{'I will' if robot else 'do'} not let {teacher} teach {'me' if robot else 'you'}"
    elif cause is not None:
        said = f"if {_told(telling, cause)}{_enabled(telling, content)}, {'I will not' if robot else 'do not'}"
        said += _except(telling, content)
    elif (only := _only_from(telling, content)) is not None:
        return only
    else:
        said = _kept_from(telling, content) + _enabled(telling, content)
        said += _except(telling, content)
    if not instead.plays:
        return said
    if robot:
        return f"{said}, instead I will {procedure(telling, instead)}"
    return f"{said} but instead {procedure(telling, instead)}"


def _kept_from(telling: Telling, content: Operator) -> str:
    """ "Never touch the stove"; "keep away from the stairs" where it is any deed that leads there."""
    robot = telling.voice == "robot"
    act = telling.term(_main(content))
    if not act.lex and [role for role, _ in act.links] == ["dest"]:
        return f"{'I will ' if robot else ''}keep away from {thing(telling, linked(act, 'dest'))}"
    return f"{'I will never' if robot else 'never'} {deed(telling, act.name)}"


def _only_from(telling: Telling, content: Operator) -> str | None:
    """ "Only Mary may tell you to drive backward", where the exception is who said it."""
    for exception in content.unless:
        for term in exception:
            if linked(term, "cmd") == _main(content):
                return f"only {_may_tell(telling, term, content)}"
    return None


def _may_tell(telling: Telling, cause: Term, content: Operator) -> str:
    """ "Mary may tell you to drive backward"."""
    speaker = thing(telling, linked(cause, "agt"), "subject")
    hearer = thing(telling, linked(cause, "dest"))
    return f"{speaker} may tell {hearer} to {deed(telling, _main(content))}"


def _enabled(telling: Telling, content: Operator) -> str:
    said = " and ".join(conditions(telling, graphlet) for graphlet in content.enablement)
    return f" if {said}" if said else ""


def _except(telling: Telling, content: Operator) -> str:
    said = " or ".join(conditions(telling, graphlet) for graphlet in content.unless)
    return f" unless {said}" if said else ""
