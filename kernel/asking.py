"""A question of a person's about the robot itself, with what its answer is found in: experience, policy, memory,
imagination. Each topic is answered by a file in kernel.answering; what is so in the world, by kernel.memory.recall."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from operator import attrgetter
from typing import Final

from kernel.action.chain import Chain, Directive, sequence
from kernel.commons import Commons
from kernel.imagining import Imagined, Thinker, imagine
from kernel.memory.attention import Focus
from kernel.memory.change import SESSION
from kernel.memory.experience import Deed
from kernel.memory.explanation import Asked, Lessons
from kernel.memory.lesson import Lesson, Operator, Rule
from kernel.memory.meaning import Question
from kernel.memory.meant import affirmed, description, grounded, is_like, synonyms, together, verb
from kernel.memory.reply import Reply
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding
from kernel.net.node import Node
from kernel.selecting import Chosen, Selection


@dataclass(frozen=True, slots=True)
class Asking:
    """One question being answered.

    Attributes:
        focus: the question's own.
        mind: for trying something out on a copy.
    """

    commons: Commons
    focus: Focus
    mind: Thinker
    question: Question

    @property
    def asked(self) -> Asked:
        """When it was asked."""
        return Asked(self.focus.at_s, self.commons.settings.utc_offset_s)

    @property
    def main(self) -> Term:
        """What is asked about."""
        about = self.question.about
        return about.head or Term(about.main)

    @property
    def about_act(self) -> bool:
        """An act of the robot's, be it only "that"."""
        return self.main.kind == "act" and (
            not any(role == "agt" for role, _ in self.main.links) or self._own_act
        )

    @property
    def _own_act(self) -> bool:
        agents = [other for role, other in self.main.links if role == "agt"]
        return any(t.name in agents and "you" in t.lex for t in self.question.about)

    @property
    def about_doing(self) -> bool:
        """Whether the robot does something now that it knows how to do: "are you turning"; not "are you holding a cup",
        which is no deed."""
        plain = self.question.topic == "" and self.question.ask == "yesno"
        act = self.act if plain and self._own_act else None
        return act is not None and bool(self.ways_to(act))

    @property
    def act(self) -> Graphlet | None:
        """The act asked about, affirmed, with whoever asks by name; None for "that"."""
        if not self.main.lex:
            return None
        names = self.commons.memory.speaker_names
        return Graphlet(
            tuple(
                replace(term, lex=names) if "me" in term.lex and names else term
                for term in affirmed(together(self.question.about))
            ),
            self.question.about.main,
        )

    @property
    def just_claimed(self) -> Graphlet | None:
        """What the robot has just said is so, or is not so, if it has done nothing since."""
        recent, newest = self.commons.recent, next(iter(self.commons.experience), None)
        since = newest is not None and newest.began_s > recent.claim_s
        return None if since else recent.claim

    def of(self, about: Graphlet) -> Asking:
        """The same question about something else."""
        return replace(self, question=replace(self.question, about=about))

    # -- lessons ---------------------------------------------------------------------------

    @property
    def lessons(self) -> list[Lesson]:
        """Lessons in force that were taught, oldest first: the one place that looks them up."""
        return sorted(filter(self.was_taught, self.commons.lessons.values()), key=_number)

    @staticmethod
    def was_taught(lesson: Lesson) -> bool:
        """It is neither born knowledge nor a fact of the session."""
        return 0 < lesson.ident < SESSION

    def call_to_mind(self, nodes: Iterable[Node]) -> None:
        """These are in mind as long as the question is."""
        self.focus.nodes |= dict.fromkeys(nodes)
        self.commons.memory.changed()
        self.commons.memory.refresh()

    @contextmanager
    def supposed(self, graphlet: Graphlet) -> Iterator[Binding]:
        """Have what the net describes in mind for a moment, about the things that are known.

        Yields the binding; nodes that had to be made are gone afterwards.
        """
        memory = self.commons.memory
        known = grounded(graphlet, memory)
        binding = memory.instantiate(graphlet, known)
        made = [node for name, node in binding.items() if name not in known]
        self.call_to_mind((*made, *known.values()))
        try:
            yield binding
        finally:
            for node in made:
                self.focus.nodes.pop(node, None)
            memory.forget(made)

    def applicable(self, tag: str, node: Node, facts: tuple[Node, ...] = ()) -> list[Chosen]:
        """Operators that would apply to a supposed act, or to supposed facts."""
        commons = self.commons
        selection = Selection(commons, self.focus, (), node, facts)
        return list(selection.applicable(tag))

    def ways_to(self, act: Graphlet) -> list[Lesson]:
        """DO operators that would be used for the act, taught ones newest first, then those it was born with."""
        with self.supposed(act) as binding:
            found = [choice.lesson for choice in self.applicable("DO", binding[act.main])]
        return sorted(found, key=lambda lesson: (lesson.ident <= 0, -lesson.ident))

    def about_acts(self, act: Graphlet, *tags: str) -> list[Lesson]:
        """Taught operators on such acts, newest first, whatever else they ask for."""
        found = []
        called = verb(act)
        for lesson in filter(self.was_taught, self.commons.shelves.triggered(synonyms(called))):
            operator = lesson.content
            if not isinstance(operator, Operator) or operator.trigger.tag not in tags:
                continue
            trigger = operator.trigger.graphlet
            if trigger is None or called.isdisjoint(verb(trigger)):
                continue
            if is_like(act, trigger) or is_like(trigger, act):
                found.append(lesson)
        return found

    def aliases_of(self, words: frozenset[str]) -> tuple[Lesson, ...]:
        """What says that one of the words means another, newest first."""
        return tuple(
            lesson
            for lesson in reversed(self.lessons)
            if isinstance(lesson.content, Rule)
            and lesson.content.is_alias
            and not words.isdisjoint(lesson.content.condition.words())
        )

    def with_step(self, act: Graphlet) -> list[Lesson]:
        """Taught operators in whose chain the act is a step, newest first."""
        return [
            lesson
            for lesson in reversed(self.lessons)
            if isinstance(lesson.content, Operator)
            and any(is_like(act, step) for step in lesson.content.chain.tagged("DO"))
        ]

    # -- deeds -----------------------------------------------------------------------------

    def deeds(self) -> Iterator[Deed]:
        """Deeds that the question may be about, newest first; whole ones only where it names none."""
        act, experience = self.act, self.commons.experience
        for deed in experience:
            if experience.is_whole(deed) if act is None else is_like(act, deed.understood):
                yield deed

    # -- trying out ------------------------------------------------------------------------

    def imagine(self, what: Chain | Graphlet, speaker: str = "") -> Imagined:
        """A dry run from here; speaker: who commands, "" for whoever asks."""
        tick = self.commons.tick
        body = replace(tick.body, at_s=tick.now_s)
        return imagine(self.mind, what, body, speaker)

    def command(self, act: Graphlet) -> Chain:
        """The chain that doing the act would be: look-ups of what it names, then the act."""
        main = act.term(act.main)
        names = [other for role, other in main.links if role in ("obj", "dest")]
        things = [n for n in names if n in act.mentioned and not _is_person(act, n)]
        finds = [description(act, name) for name in things]
        looked_up = {term.name for find in finds for term in find}
        own = Graphlet(tuple(t for t in act if t.name not in looked_up), act.main)
        looked = [Directive("FIND", find) for find in finds if find.terms]
        return sequence(*looked, Directive("DO", own))


_number = attrgetter("ident")


def _is_person(act: Graphlet, name: str) -> bool:
    """The robot, the speaker, or quoted text: never looked up."""
    term = next((t for t in act if t.name == name), None)
    return term is not None and (bool(term.lex & {"you", "me"}) or term.literal is not None)


Answering = Callable[[Asking], Reply]
ANSWERS: Final[dict[tuple[str, str], Answering]] = {}


def answers(topic: str, *asks: str) -> Callable[[Answering], Answering]:
    """Register what answers questions of the topic with these question words; without words, with any.

    Raises:
        ValueError: that is taken.
    """

    def register(code: Answering) -> Answering:
        for ask in asks or ("",):
            if (topic, ask) in ANSWERS:
                raise ValueError(f"questions {topic} {ask} are answered twice")
            ANSWERS[topic, ask] = code
        return code

    return register


def answer(asking: Asking) -> Reply:
    """The answer to a question about the robot itself."""
    question = asking.question
    code = ANSWERS.get((question.topic, question.ask)) or ANSWERS.get((question.topic, ""))
    if code is None:
        return Lessons(question)
    return code(asking)
