"""Things into nets: what a noun phrase means, and what is said of a thing. docs/net.md is the law here.

In a pattern (a trigger, a condition) things are described by terms of that pattern; elsewhere a thing is looked up,
and a FIND graphlet for it waits in `finds`. A thing mentioned twice in a sentence ("it", "the person") is the same
node.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.manners import how_many
from grammars.mentions import (
    ALIKE,
    ANY_KIND,
    EVERY,
    OWNING,
    PERSON_WORDS,
    PERSONAL,
    REFS,
    SELF,
    SELF_OWN,
    Thing,
    compounded,
    degree,
    is_definite,
    is_group,
    is_person,
    place_word,
    unlikely,
    with_apposed,
)
from grammars.relatives import relative
from grammars.sorts import (
    EITHER,
    SEVERAL,
    agrees,
    is_between_one,
    is_graded,
    is_nothing,
    is_superlative,
    kind,
)
from grammars.vocabulary import BORN
from kernel.memory.recall import PERSONS
from kernel.net.graphlet import Graphlet, Sketch, Term


def _called(np: AList) -> str:
    """Of what kind it is told to be: "room 7"."""
    return " ".join(filter(None, (kind(np), np.slot("numbered"))))


@dataclass
class Things:
    """The drawing of one sentence: its things.

    Attributes:
        sketch: all terms.
        board: names of the terms of the graphlet being drawn.
        pattern: things are described on the board instead of looked up.
        finds: look-ups not yet placed into a chain.
        things: what was mentioned, oldest first.
        telling: a fact is being told: "a hat" is a new thing and not looked up.
        negative: the clause being drawn had "nothing" or "nobody" in it.
        trigger: the pattern is what a deed is matched with: "somebody" may be anything there, as nobody need have
            said that Mary is a person before "greet Mary" greets somebody.
        claims: predicates of the conditions.
        naming: a deed is named to tell how it is done.
        grasping: what is spoken of is taken in the hand.
        topic: subject of the sentence's first condition, or object of the deed that triggers.
    """

    sketch: Sketch = field(default_factory=Sketch)
    board: list[str] = field(default_factory=list)
    pattern: bool = False
    finds: list[Graphlet] = field(default_factory=list)
    things: list[Thing] = field(default_factory=list)
    negative: bool = False
    telling: bool = False
    trigger: bool = False
    topic: str = ""
    naming: bool = False
    grasping: bool = False
    claims: set[str] = field(default_factory=set)

    @contextmanager
    def drawing(self, pattern: bool, trigger: bool = False) -> Iterator[list[str]]:
        """A fresh board."""
        before = self.board, self.pattern, self.trigger
        self.board, self.pattern, self.trigger = [], pattern, trigger
        yield self.board
        self.board, self.pattern, self.trigger = before

    def add(self, kind: str, *lex: str, **more: Any) -> str:
        """Add a term to the sketch and to the board."""
        return self.put(self.sketch.add(kind, *lex, **more))

    def put(self, name: str) -> str:
        """Put a term on the board."""
        if name not in self.board:
            self.board.append(name)
        return name

    def graphlet(self, main: str) -> Graphlet:
        """What is on the board; a thing of which nothing is said ("something") needs no term."""
        terms = self.sketch.terms
        said = [name for name in self.board if terms[name] != Term(name)]
        return self.sketch.graphlet(main, *said)

    def modifiers(self, act: str, action: AList, taken: str = "") -> None:
        """What is said of how somebody does something: the business of who draws actions."""
        raise NoMeaningError(str(action))

    def thing(self, np: AList, person: bool = False) -> str:
        """Node of the thing a noun phrase means."""
        if np.value is not None and np.name == "np":
            raise NoMeaningError(str(np))
        if (apposed := np.find("apposed")) is not None:
            np = with_apposed(np, apposed)
        if np.has("name") and not self.telling:  # "my brother Tom" is Tom
            np = AList("np", tuple(part for part in np if part.name in ("name", "rel")))
        pron = np.slot("pron") or np.slot("pronoun")
        if pron in SELF:
            return self.oneself(SELF[pron])
        if pron:
            return self.pronoun(pron)
        return self.same(np) or self._described(np, np.slot("det"), _called(np), person)

    def aside(self, np: AList) -> str:
        """Node of a thing that tells where something is, or where to."""
        before = len(self.things)
        name = self.thing(np)
        for thing in self.things[before:]:
            thing.aside = True
        return name

    def oneself(self, who: str) -> str:
        """Node of the robot ("you") or the speaker ("me")."""
        for name, term in self.sketch.terms.items():
            if term.lex == {who} and term.kind == "obj":
                return self.put(name)
        return self.add("obj", who)

    def pronoun(self, word: str) -> str:
        """What the sentence is about if that fits, else the newest thing mentioned that does and is more than a
        landmark; else one to be looked up."""
        personal = word in PERSONAL
        newest = self.things[::-1]
        fitting = [thing for thing in newest if thing.may_be(word) and word != "we"]
        if not fitting and not personal and word != "we":  # "if a baby is crying, rock it"
            fitting = [thing for thing in newest if not thing.called]
        for thing in sorted(fitting, key=lambda one: unlikely(one, self.topic, self.grasping)):
            thing.person = thing.person or personal
            return thing.name
        ref = ALIKE.get(word, word)
        with self._own_board():
            name = self.add("obj", ref=ref)
            self._mention(Thing(name, person=personal))
        return name

    def same(self, np: AList) -> str | None:
        """Earlier thing of this sentence that "the block" takes up again."""
        if called := np.slot("name"):
            return next((t.name for t in self.things if t.called == called), None)
        again = _called(np) if np.slot("det") in ("the", "that", "this") else ""
        if not again or any(np.has(part) for part in ("qual", "rel", "own", "owner", "sub")):
            return None
        return next((t.name for t in reversed(self.things) if t.kind == again), None)

    @contextmanager
    def _own_board(self, here: bool = False) -> Iterator[None]:
        """A board of its own for a thing that is looked up; none where a pattern is drawn or the thing is new."""
        if self.pattern or here:
            yield
            return
        before, self.board = self.board, []
        yield
        main, *more = self.board
        self.finds.append(self.sketch.graphlet(main, *more))
        self.board = before

    def _mention(self, thing: Thing) -> None:
        self.things.append(thing)

    def _described(self, np: AList, det: str, kind: str, person: bool) -> str:
        if not agrees(np) or (self.telling and det in EITHER):
            raise NoMeaningError(str(np))
        vague, called = np.slot("vague"), np.slot("name")
        if is_nothing(np):
            self.negative = True
        anybody = vague in PERSON_WORDS and self.trigger
        of_owner = any(rel.find("owner_of", "of_owner") is not None for rel in np.all("rel"))
        ref = "somebody" if anybody else "one" if np.has("one") else REFS.get(det, "")
        if kind == "one" and (np.has("qual") or np.has("rel")):  # "the red one" is no kind of thing
            kind = ""
        if not det and (
            np.has("numbered") or is_superlative(np)
        ):  # "box two", "grab biggest block"
            ref = "the"
        if (self.telling or not self.pattern) and is_group(np):
            ref = det if det in SEVERAL else "they"
        ref = "every" if vague in EVERY else ref
        ref = "" if ref == "the" and of_owner else ref  # "the cup of Mary's brother" is his cup
        place = "PLACE" in BORN.readings(called)
        person = (bool(called) and not place) or person or kind in PERSONS or vague in PERSON_WORDS
        owned = np.has("own") or np.has("owner") or of_owner
        new = self.telling and not called and not ref and not owned
        with self._own_board(here=new):
            name = self.add("obj", *([called] if called else []), ref=ref)
            if kind and (kind not in ANY_KIND or ref):
                self.kind(name, kind, compounded(np))
            if vague in PERSON_WORDS and not anybody:
                self.kind(name, "person")
            for qual in np.all("qual"):
                self.quality(name, qual)
            self.possessed(name, np)
            for rel in np.all("rel"):
                relative(self, name, np, rel)
            if np.has("num"):
                self.add("cnt", literal=how_many(self, np), cnt=name)
        self._mention(Thing(name, kind, person, called))
        return name

    def kind(self, name: str, kind: str, sub: str = "", negated: bool = False) -> str:
        """Say of what kind a thing is; the node of that."""
        ako = self.add("ako", kind, ako=name, negated=negated)
        if sub:
            self.add("sub", sub, sub=ako)
        return ako

    def not_all(self, name: str, np: AList) -> None:
        """What is denied is denied of some thing, and not of all there are: "if a block is not red"."""
        some = np.has("vague") or (np.has("det") and not is_definite(np))
        if some and not self.sketch.terms[name].ref:
            self.sketch.change(name, ref="some")

    def quality(self, name: str, qual: AList, negated: bool = False) -> str:
        """Say of what quality a thing is, in what degree; the node of that."""
        said = map(qual.slot, ("hq", "ako", "more", "most", "ord"))
        word = next(filter(None, said), qual.value or "")
        hq = self.add("hq", word, hq=name, negated=negated)
        degrees = [degree(part.value or "") for part in qual.all("deg")]
        if not is_graded(word, degrees):
            raise NoMeaningError(str(qual))
        for deg in degrees:
            self.add("deg", deg, deg=hq)
        if qual.has("more"):
            self.add("deg", "more", deg=hq)
        if qual.has("most") or qual.has("most_of"):
            self.add("deg", "most", deg=hq)
        return hq

    def whom(self, own: str) -> str:
        """Node of whom "my", "your", "her" tells of."""
        return self.oneself(SELF_OWN[own]) if own in SELF_OWN else self.pronoun(OWNING[own])

    def possessed(self, name: str, np: AList) -> str:
        """Say whose a thing is, if the phrase says so; the node of that, or ""."""
        own, owner = np.slot("own"), np.find("owner")
        if own:
            return self.add("own", own=name, of=self.whom(own))
        if owner is not None:
            return self.add("own", own=name, of=self.thing(owner, person=True))
        return ""

    def owned(self, name: str, owner: AList, negated: bool = False) -> str:
        """Say that a thing is somebody's, or a part of something: "the ball of Mary's brother", "the end of the hall".

        Returns the node of that.
        """
        if owner.has("own") and len(owner.parts) == 1:  # "that is ours", and not "my brother's"
            return self.add("own", own=name, of=self.whom(owner.slot("own")), negated=negated)
        whose = owner.find("np") or owner
        if owner.name == "of_owner" and not (is_person(whose) or is_definite(whose)):
            raise NoMeaningError(str(owner))
        return self.add("own", own=name, of=self.thing(whose, person=True), negated=negated)

    def place(self, role: str, name: str, loc: AList, negated: bool = False) -> str:
        """Say where something is or is done; the node of that."""
        if is_between_one(loc):
            raise NoMeaningError(str(loc))
        marks = [self.aside(np) for np in loc.all("np")]
        return self.add("loc", place_word(loc), negated=negated, loc=name, wrt=marks)
