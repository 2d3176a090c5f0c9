"""How a focus begins: what was heard or noticed, as the chain that attends to it.

Every utterance posts NOTE[tell or ask, agt user, dest self] first, always, then its content: this is how "if Rick tells
you to do something don't" works (Connell 2019, section 4, Permissions).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from kernel import adapting, managing, revising
from kernel.action.chain import Directive
from kernel.action.step import DIRECTIVES, Run
from kernel.action.verdict import Verdict
from kernel.asking import Asking, answer
from kernel.commons import Commons
from kernel.imagining import Thinker
from kernel.memory.attention import Focus
from kernel.memory.lesson import LEARNING, Content, Lesson, LessonKind
from kernel.memory.meaning import (
    Choice,
    Command,
    Control,
    Fact,
    Feedback,
    Heard,
    Identity,
    Question,
    Revision,
    Social,
    Teach,
)
from kernel.memory.recent import Saying
from kernel.memory.reply import FactTaken, Greeted, Met, NothingToDo
from kernel.memory.teacher import in_own_name
from kernel.memory.wondering import is_thing
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import Node
from kernel.remembering import source
from kernel.running import Frame
from kernel.steering import Steered, drop_newest, go_on, stop_doing
from kernel.stepping import RunningStep


class Listener(Steered, Thinker, Protocol):
    """What a mind lets an utterance change of itself."""


def attend(mind: Listener, commons: Commons, focus: Focus) -> Run:
    """Note that somebody spoke, then see to what was said."""
    heard = focus.heard
    if heard is None:
        return Verdict.SUCCEEDED
    if heard.utterance.speaker or heard.utterance.candidates:
        mind.speaker = heard.utterance.speaker.lower()
    commons.experience.clock(heard.utterance.at_s, commons.tick.now_s)
    memory = commons.memory
    memory.person_speaking(mind.speaker)
    focus.by = mind.speaker
    words = ("ask",) if isinstance(heard.meaning, Question) else ("tell", "ask")
    focus.speech_act = memory.net.new("input", *words, agt=memory.user, dest=memory.me)
    focus.nodes[focus.speech_act] = None
    for name in heard.utterance.candidates:
        memory.net.link(focus.speech_act, "agt", memory.person(name.lower()))
    answered = managing.answered(commons, heard.meaning)
    open_before = commons.doubt is not None and commons.doubt.focus < focus.number
    closed = open_before and not answered
    if closed:
        commons.doubt = None  # whatever else is said after it closes the question
    if isinstance(heard.meaning, Command):
        _quote(commons, focus, heard.meaning)
    said = _spoken(commons, focus, heard.utterance.text)
    memory.changed()
    yield from noted(commons, focus, (focus.speech_act, said))
    if answered:
        return Verdict.SUCCEEDED
    if closed and isinstance(heard.meaning, Command | Question):
        yield from managing.settled(
            commons, focus
        )  # the lesson is kept: it counts for this already
    return (yield from _content(mind, commons, focus, heard))


def _spoken(commons: Commons, focus: Focus, text: str) -> Node:
    """That the speaker says these words, for "when John says hello" and "until I say now": so until somebody speaks."""
    net, memory = commons.memory.net, commons.memory
    for owner, old in commons.spoken:
        if owner.nodes.pop(old, old) is None:
            net.drop(old)
    words = net.new("txt")
    words.literal = " ".join(text.split()).strip(".,!? ").lower()
    said = net.new("input", "say", agt=memory.user, dest=memory.me, obj=words)
    commons.spoken = [(focus, words), (focus, said)]
    focus.nodes |= {words: None, said: None}
    return said


def _quote(commons: Commons, focus: Focus, command: Command) -> None:
    """What was said, as nodes of its own: so "if Rick tells you to grab a ball" can be noticed before any look-up.

    Their kind is "said": FIND never takes them for things.
    """
    memory = commons.memory
    binding: Binding = {}
    known: set[str] = set()
    for directive in command.chain.directives():
        graphlet = directive.graphlet
        if graphlet is None or directive.tag not in ("FIND", "DO"):
            continue  # what is to be checked is not so, and rules would see it
        if directive.tag == "FIND" and not is_thing(graphlet):
            continue
        quoted = graphlet.renamed({n: f"said-{n.rpartition('-')[2]}" for n in graphlet.mentioned})
        before = memory.persons(quoted, binding)
        known |= set(before) - set(binding)
        binding = memory.instantiate(quoted, before)
        if directive.tag == "DO" and focus.speech_act is not None:
            memory.net.link(focus.speech_act, "cmd", binding[quoted.main])
    for name, node in binding.items():
        if name not in known:
            focus.nodes[node] = None


def notice(
    mind: Listener, commons: Commons, focus: Focus, nodes: tuple[Node, ...], fact: Graphlet | None
) -> Run:
    """React to what the senses report: facts that are held already, or a passing event."""
    if fact is not None:
        known = commons.memory.persons(fact, {})
        bound = commons.memory.instantiate(fact, known)
        nodes = tuple(node for name, node in bound.items() if name not in known)
    for node in nodes:
        focus.nodes[node] = None
    return (yield from noted(commons, focus, nodes))


def noted(commons: Commons, focus: Focus, nodes: tuple[Node, ...]) -> Run:
    """A NOTE about nodes that are in memory already."""
    step = RunningStep(Frame(commons, focus, {}), Directive("NOTE"))
    step.selection.facts = nodes
    return (yield from DIRECTIVES["NOTE"](step))


def _content(mind: Listener, commons: Commons, focus: Focus, heard: Heard) -> Run:
    frame = Frame(commons, focus, {})
    match heard.meaning:
        case Command() as command:
            return (yield from revising.obey(commons, focus, command))
        case Fact(fact, finds):
            return (yield from _fact(commons, focus, fact, finds))
        case Teach() as taught:
            kinds = map(taught.kind_of, taught.contents)
            lessons = zip(kinds, taught.contents, strict=True)
            focus.lesson, *beside = (_lesson(focus, kind, each) for kind, each in lessons)
            focus.beside = tuple(beside)
            return (yield from frame.directive(Directive("ADD", LEARNING)))
        case Question() as question:
            asking = Asking(commons, focus, mind, question)
            if asking.about_doing:
                asking = replace(asking, question=replace(question, topic="doing"))
            if asking.question.topic not in ("", "identity"):
                commons.replies.append(answer(asking))
                return Verdict.SUCCEEDED
            return (yield from frame.directive(Directive("ASK")))
        case Choice(described):
            _choose(commons, focus, described)
        case Identity(name, robot=True):
            _call_itself(commons.memory, name)
            commons.replies.append(Met(name, robot=True))
        case Identity(name):
            mind.speaker = name
            commons.memory.person_speaking(name)
            commons.record("identity", focus, name=name)
            commons.replies.append(Met(name))
        case Social() as social:
            commons.replies.append(Greeted(social, mind.speaker))
        case Feedback(good, stop):
            return (yield from adapting.feedback(commons, focus, good=good, answered=stop))
        case Control() as control:
            return (yield from _control(mind, commons, focus, control))
        case Revision() as revision:
            return (yield from revising.revise(commons, focus, revision))
    return Verdict.SUCCEEDED


def _control(mind: Listener, commons: Commons, focus: Focus, control: Control) -> Run:
    match control.act:
        case "undo":
            return (yield from managing.undo(commons, focus))
        case "undo_today":
            return (yield from managing.undo_today(commons, focus))
        case "forget":
            return (yield from managing.forget(commons, focus, control))
        case "repeat":
            return (yield from revising.repeat(commons, focus))
        case "keep" | "replace":
            commons.replies.append(NothingToDo("answer"))
        case "learned":
            day = Question("what", control.about or Graphlet((), "act-1"), topic="learned")
            commons.replies.append(answer(Asking(commons, focus, mind, day)))
        case "cancel":
            drop_newest(mind, commons, focus)
        case "resume":
            return (yield from go_on(commons, focus))
        case "stop":
            if control.about is not None:
                stop_doing(commons, focus, control.about)
    return Verdict.SUCCEEDED


def _call_itself(memory: WorkingMemory, name: str) -> None:
    """What the robot is called from now on."""
    for former in memory.me.lex - {"you"}:
        memory.net.unname(memory.me, former)
    memory.net.name(memory.me, name)
    memory.changed()


def _choose(commons: Commons, focus: Focus, described: Graphlet) -> None:
    """The person said which one is meant; where that is still not clear, the question is put again."""
    which = commons.which
    if which is None:
        return
    if (chosen := which.take(described, commons.memory.net)) is not None:
        commons.memory.net.touch(chosen)
        focus.nodes[chosen] = None
        commons.record("answered", focus, text=" ".join(sorted(described.words())))
    else:
        commons.replies.append(which.question)


def _fact(commons: Commons, focus: Focus, fact: Graphlet, finds: tuple[Graphlet, ...]) -> Run:
    """Look up or make what the fact is about, take it for true, keep it if it is to last, react to it."""
    memory = commons.memory
    frame = Frame(commons, focus, {})
    for find in finds:
        frame.binding = frame.recalled(find) or frame.instantiate(find)
        memory.remember_description(
            [frame.binding[t.name] for t in find.terms if t.name in frame.binding]
        )
    told = Fact(fact, finds)
    focus.lesson = _lesson(focus, "fact", managing.whole(told))
    focus.saying = Saying(told, frame.binding)
    learned = yield from Frame(commons, focus, {}).directive(Directive("ADD", LEARNING))
    if not learned.ok:
        return learned
    focus.nodes |= dict.fromkeys((*frame.binding.values(), *focus.told))
    if (said := source(focus)) is not None:
        commons.experience.told(focus.told[0], said)
    commons.replies.append(FactTaken(fact, finds))
    return (yield from noted(commons, focus, focus.told))


def _lesson(focus: Focus, kind: LessonKind, content: Content) -> Lesson:
    """The lesson of an utterance, not stored yet."""
    change = focus.changing()
    named = in_own_name(content, change.by)
    return Lesson(0, kind, named, change.words, change.by, change.at_s)
