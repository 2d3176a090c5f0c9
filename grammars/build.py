"""Association lists into nets: things, actions and chains. docs/net.md is the law here; clauses are in `clauses.py`.

A `Build` holds the drawing of one sentence. In a pattern (a trigger, a condition) things are described by terms of
that pattern; elsewhere a thing is looked up, and a FIND graphlet for it waits in `finds`. A thing mentioned twice in a
sentence ("it", "the person") is the same node.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Final

from grammars.alist import AList
from grammars.vocabulary import lines
from kernel.action.chain import Chain, Directive, Play
from kernel.net.graphlet import Graphlet, Sketch, Term


class NoMeaningError(Exception):
    """A reading that the grammar allows and the net has no room for; the next reading is tried."""


SELF: Final = {"you": "you", "yourself": "you", "me": "me", "i": "me"}
SELF_OWN: Final = {"my": "me", "your": "you"}
OWNING: Final = {"his": "he", "her": "she", "its": "it", "their": "they", "our": "we"}
PERSONAL: Final = frozenset("him her he she".split())
PERSON_WORDS: Final = frozenset("someone somebody anyone anybody nobody".split()) | {
    "someone else",
    "no one",
}
NOBODY: Final = frozenset(("nothing", "nobody", "no one"))
PERSONS: Final = frozenset(
    "person man woman boy girl child kid baby human guest visitor stranger friend neighbor owner".split()
)
ANY_KIND: Final = frozenset(("thing", "object", "item", "stuff"))
REFS: Final = {"the": "the", "this": "this", "that": "that", "these": "this", "those": "that"}
SIZES: Final = {
    "all the way": "fully",
    "completely": "fully",
    "fully": "fully",
    "a lot": "much",
    "halfway": "half",
    "half way": "half",
    "further": "more",
    "some more": "more",
}
PLACES: Final = {
    "to the left of": "left of",
    "on the left of": "left of",
    "on the left side of": "left of",
    "to the right of": "right of",
    "on the right of": "right of",
    "on the right side of": "right of",
    "close to": "near",
    "near to": "near",
    "beside": "next to",
    "inside": "in",
    "inside of": "in",
    "in back of": "behind",
    "underneath": "under",
    "beneath": "under",
    "on top of": "on",
}


@cache
def particles() -> dict[str, tuple[str, str]]:
    """Verb, or verb and particle, to lexical item and direction ("" for none)."""
    table: dict[str, tuple[str, str]] = {}
    for line in lines("particles"):
        said, _, meant = line.partition("=")
        verb, _, way = meant.strip().partition(" ")
        table[said.strip()] = (verb, way) if meant else (said.strip(), "")
    return table


@dataclass
class Thing:
    """Something mentioned: its node and what it was called, for later "it" and "the block"."""

    name: str
    kind: str = ""
    person: bool = False


@dataclass
class Build:
    """The drawing of one sentence.

    Attributes:
        sketch: all terms.
        board: names of the terms of the graphlet being drawn.
        pattern: things are described on the board instead of looked up.
        finds: look-ups not yet placed into a chain.
        things: what was mentioned, oldest first.
        telling: a fact is being told: "a hat" is a new thing and not looked up.
        negative: the clause being drawn had "nothing" or "nobody" in it.
    """

    sketch: Sketch = field(default_factory=Sketch)
    board: list[str] = field(default_factory=list)
    pattern: bool = False
    finds: list[Graphlet] = field(default_factory=list)
    things: list[Thing] = field(default_factory=list)
    negative: bool = False
    telling: bool = False

    @contextmanager
    def drawing(self, pattern: bool) -> Iterator[list[str]]:
        """A fresh board."""
        before = self.board, self.pattern
        self.board, self.pattern = [], pattern
        yield self.board
        self.board, self.pattern = before

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

    # ---- things ----

    def thing(self, np: AList, person: bool = False) -> str:
        """Node of the thing a noun phrase means."""
        if np.value is not None and np.name == "np":
            raise NoMeaningError(str(np))
        pron = np.slot("pron")
        if pron in SELF:
            return self.oneself(SELF[pron])
        if pron:
            return self.pronoun(pron)
        det, kind = np.slot("det"), np.slot("ako") or np.slot("akos")
        if det in ("the", "that", "this") and (same := self._same(np, kind)):
            return same
        return self._described(np, det, kind, person)

    def oneself(self, who: str) -> str:
        """Node of the robot ("you") or the speaker ("me")."""
        for name, term in self.sketch.terms.items():
            if term.lex == {who} and term.kind == "obj":
                return self.put(name)
        return self.add("obj", who)

    def pronoun(self, word: str) -> str:
        """The newest thing mentioned that fits, else one to be looked up."""
        personal = word in PERSONAL
        for thing in reversed(self.things):
            if thing.person or not personal or not thing.kind:
                thing.person = thing.person or personal
                return thing.name
        ref = {"him": "he", "her": "she", "them": "they"}.get(word, word)
        with self._own_board():
            name = self.add("obj", ref=ref)
            self._mention(Thing(name, person=personal))
        return name

    def _same(self, np: AList, kind: str) -> str | None:
        """Earlier thing of this sentence that "the block" takes up again."""
        if not kind or any(np.has(part) for part in ("qual", "rel", "own", "owner", "sub")):
            return None
        return next((t.name for t in reversed(self.things) if t.kind == kind), None)

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
        vague, called = np.slot("vague"), np.slot("name")
        if vague in NOBODY or det == "no":
            self.negative = True
        ref = "one" if np.has("one") else REFS.get(det, "")
        person = bool(called) or person or kind in PERSONS or vague in PERSON_WORDS
        new = self.telling and not called and not ref and not (np.has("own") or np.has("owner"))
        with self._own_board(here=new):
            name = self.add("obj", *([called] if called else []), ref=ref)
            if kind and (kind not in ANY_KIND or ref):
                self.kind(name, kind, np.slot("sub"))
            if vague in PERSON_WORDS:
                self.kind(name, "person")
            for qual in np.all("qual"):
                self.quality(name, qual)
            self.possessed(name, np)
            for rel in np.all("rel"):
                self.relative(name, rel)
        self._mention(Thing(name, kind, person))
        return name

    def kind(self, name: str, kind: str, sub: str = "", negated: bool = False) -> str:
        """Say of what kind a thing is; the node of that."""
        ako = self.add("ako", kind, ako=name, negated=negated)
        if sub:
            self.add("sub", sub, sub=ako)
        return ako

    def quality(self, name: str, qual: AList, negated: bool = False) -> str:
        """Say of what quality a thing is, in what degree; the node of that."""
        word = qual.slot("hq") or qual.slot("most") or qual.slot("ord") or qual.value or ""
        hq = self.add("hq", word, hq=name, negated=negated)
        for deg in qual.all("deg"):
            self.add("deg", deg.value or "", deg=hq)
        if qual.has("most") or qual.has("most_of"):
            self.add("deg", "most", deg=hq)
        return hq

    def possessed(self, name: str, np: AList) -> str:
        """Say whose a thing is, if the phrase says so; the node of that, or ""."""
        own, owner = np.slot("own"), np.find("owner")
        if own in SELF_OWN:
            return self.add("own", own=name, of=self.oneself(SELF_OWN[own]))
        if own:
            return self.add("own", own=name, of=self.pronoun(OWNING[own]))
        if owner is not None:
            return self.add("own", own=name, of=self.thing(owner, person=True))
        return ""

    def relative(self, name: str, rel: AList) -> None:
        """Narrow a thing down: "that is not blue", "next to the wall", "on the left", "called Pookie"."""
        if rel.has("name"):
            self.sketch.change(name, lex=frozenset({rel.slot("name")}))
        elif (pred := rel.find("pred")) is not None:
            self.predicate(name, pred, rel.has("neg"))
        elif rel.has("loc") or rel.has("side"):
            self.predicate(name, rel, negated=False)
        elif rel.has("gerund"):
            self.add("act", rel.slot("gerund"), agt=self.oneself("you"), obj=name)
        else:
            raise NoMeaningError(str(rel))

    def predicate(self, name: str, pred: AList, negated: bool) -> str:
        """Say something of a thing; the node of the predicate."""
        if pred.has("qual"):
            main, *_ = [self.quality(name, part, negated) for part in pred.all("qual")]
            return main
        if (kindof := pred.find("kindof")) is not None:
            return self._kind_of(name, kindof, negated)
        if (loc := pred.find("loc")) is not None:
            return self.place("loc", name, loc, negated)
        if (side := pred.find("side")) is not None:
            return self.add("loc", side.slot("dir") or side.value or "", loc=name, negated=negated)
        if (compared := pred.find("compared")) is not None:
            word = compared.slot("adjer") or compared.slot("hq")
            other = self.thing(compared.first("np"))
            return self.add("hq", word, hq=name, than=other, negated=negated)
        if (called := pred.find("isname")) is not None:
            self.sketch.change(name, lex=frozenset((called.slot("name"),)))
            return self.put(name)
        if pred.has("here"):
            return self.add(
                "loc", "in front of", loc=name, wrt=self.oneself("you"), negated=negated
            )
        if (belongs := pred.find("belongs")) is not None:
            return self.add("own", own=name, of=self.thing(belongs, person=True), negated=negated)
        raise NoMeaningError(str(pred))

    def _kind_of(self, name: str, kindof: AList, negated: bool) -> str:
        kind = kindof.slot("ako") or kindof.slot("akos")
        for qual in kindof.all("qual"):
            self.quality(name, qual, negated and not kind)
        if not kind:
            raise NoMeaningError(str(kindof))
        node = self.kind(name, kind, kindof.slot("sub"), negated)
        if (of := kindof.find("np")) is not None:
            self.add("own", own=name, of=self.thing(of, person=True))
        self.possessed(name, kindof)
        return node

    def place(self, role: str, name: str, loc: AList, negated: bool = False) -> str:
        """Say where something is or is done; the node of that."""
        word = loc.slot("prep") or "between"
        marks = [self.thing(np) for np in loc.all("np")]
        return self.add("loc", PLACES.get(word, word), negated=negated, loc=name, wrt=marks)

    # ---- actions ----

    def action(self, action: AList) -> str:
        """Node of an action; what it is done to stays to be looked up, or is on the board of a pattern."""
        if (speech := action.find("speech", "speaking")) is not None:
            return self._speech(speech)
        if action.value is not None:
            action = AList(action.name, (AList("act", value=action.value),))
        verb, way = self._verb(action)
        links: dict[str, str] = {}
        if (iobj := action.find("iobj")) is not None:
            links["dest"] = self.thing(iobj.first("np"), person=True)
        if (obj := action.find("np")) is not None:
            links["obj"] = self.thing(obj)
        if (where := action.find("whereis")) is not None:
            links["obj"] = self._whereabouts(where)
        if (dest := action.find("dest")) is not None:
            links["dest"] = self.thing(dest.first("np"))
        act = self.add("act", verb, **links)
        if way:
            self.add("dir", way, dir=act)
        self.modifiers(act, action, taken=way)
        return act

    def _verb(self, action: AList) -> tuple[str, str]:
        """Lexical item of the verb with its particle, and the direction that is part of it."""
        if action.has("letgo"):
            return "release", ""
        verb = action.slot("act")
        for way in [*(d.value or "" for d in action.all("dir")), ""]:
            said = {"forward": "ahead", "backward": "back"}.get(way, way)
            for particle in dict.fromkeys((way, said)):
                if (known := particles().get(f"{verb} {particle}".strip())) is not None:
                    self._particle = way
                    return known
        self._particle = ""
        return verb, ""

    _particle: str = ""

    def modifiers(self, act: str, action: AList, taken: str = "") -> None:
        """Directions, manners, amounts, counts and places of an action."""
        particle, self._particle = self._particle, ""
        for part in action:
            if part.name == "dir" and part.value not in (particle, taken):
                self.add("dir", part.value or "", dir=act)
            elif part.name == "manner":
                self._manner(act, part)
            elif part.name == "amt":
                number = part.slot("num", "1")
                self.add("amt", part.slot("unit") or part.value or "", literal=number, amt=act)
            elif part.name == "cnt":
                self.add("cnt", literal=count(part), cnt=act)
            elif part.name == "size":
                self.add("deg", SIZES.get(part.value or "", "little"), deg=act)
            elif part.name == "place":
                self.place("loc", act, part.first("loc"))

    def _manner(self, act: str, manner: AList) -> None:
        mod = self.add("mod", manner.slot("adv") or manner.value or "", mod=act)
        for deg in manner.all("deg"):
            self.add("deg", deg.value or "", deg=mod)

    def _speech(self, speech: AList) -> str:
        verb = next(part.name for part in speech if part.name in ("say", "tell", "ask"))
        if (quote := speech.slot("quote")) == "":
            raise NoMeaningError(str(speech))
        txt = self.add("txt", literal=quote)
        links = {"obj": txt}
        if (hearer := speech.find("hearer", "listener")) is not None:
            links["dest"] = self.thing(hearer.find("np") or hearer, person=True)
        act = self.add("act", verb, **links)
        if (cnt := speech.find("cnt")) is not None:
            self.add("cnt", literal=count(cnt), cnt=act)
        return act

    def _whereabouts(self, where: AList) -> str:
        np = where.find("np")
        if np is None:
            raise NoMeaningError(str(where))
        return self.add("loc", loc=self.thing(np))

    def act_or_any(self, action: AList | None) -> str:
        """Node of an action; of any act at all where none is named."""
        return self.add("act") if action is None else self.action(action)

    # ---- chains ----

    def chain(self, chain: AList) -> Chain:
        """Plays one after another; look-ups come before the play that needs them."""
        plays: list[Play] = []
        for play in chain.all("play"):
            parts: list[Directive] = []
            for action in play.all("action", "acting"):
                with self.drawing(pattern=False):
                    act = self.action(action)
                    parts.append(Directive("DO", self.graphlet(act)))
            plays += [Play((Directive("FIND", find),)) for find in self.finds]
            self.finds.clear()
            plays.append(Play(tuple(parts)))
        for inner in chain.all("chain"):
            plays += self.chain(inner).plays
        return Chain(tuple(plays))


def count(cnt: AList) -> str:
    """How many times, in digits."""
    if cnt.has("twice"):
        return "2"
    return cnt.slot("num") or {"once": "1", "twice": "2"}.get(cnt.value or "", cnt.value or "1")
