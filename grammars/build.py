"""Actions and chains into nets, upon things. docs/net.md is the law here; clauses are in `clauses.py`."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final

from grammars.alist import AList
from grammars.chains import bare_chain, count, plays
from grammars.clauses import stated
from grammars.mentions import OWNING, SELF_OWN, Thing, degree, is_person, place_word
from grammars.things import NoMeaningError, Things
from grammars.vocabulary import BORN, lines
from kernel.action.chain import Chain, Directive, Play
from kernel.net.graphlet import Graphlet

__all__ = ["Build", "NoMeaningError", "particles"]

WONDERS: Final = {"what_like": "hq", "what_kind": "ako", "whereabout": "loc"}
CONJUNCTIONS: Final = ("or", "but", "because")  # "don't tell him that or he will cry"
SIZES: Final = {
    "all the way": "fully",
    "completely": "fully",
    "fully": "fully",
    "a lot": "much",
    "a whole lot": "much",
    "halfway": "half",
    "half way": "half",
    "further": "more",
    "some more": "more",
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
class Build(Things):
    """The drawing of one sentence: its things, actions and chains."""

    def action(self, action: AList) -> str:
        """Node of an action; what it is done to stays to be looked up, or is on the board of a pattern."""
        if (speech := action.find("speech", "speaking")) is not None:
            return self._speech(speech)
        if action.value is not None:
            action = AList(action.name, (AList("act", value=action.value),))
        verb, way = self._verb(action)
        if action.slot("dir") == "for" and self._particle != "for":
            raise NoMeaningError(str(action))
        links: dict[str, str] = {}
        if (every := action.find("every")) is not None:
            links["obj"] = self.every(every)
        if (obj := action.find("np")) is not None:
            links["obj"] = self.thing(obj)
            self.topic = links["obj"] if self.trigger else self.topic
        if (where := action.find("whereis")) is not None:
            links["obj"] = self._whereabouts(where)
        if (iobj := action.find("iobj")) is not None:
            links["dest"] = self.thing(iobj.first("np"), person=True)
        if (dest := action.find("dest")) is not None:
            every = dest.find("every")
            links["dest"] = self.aside(dest.first("np")) if every is None else self.every(every)
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

    def every(self, every: AList) -> str:
        """Node of each thing of a description: what is done to it is done in a loop (grammars.chains)."""
        if self.pattern or self.telling:
            raise NoMeaningError(str(every))
        name = self.thing(AList("np", every.parts))
        self.sketch.change(name, ref="each")
        self.each = self.sketch.graphlet(name, *self.finds.pop().names)
        return name

    each: Graphlet | None = None
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
                if part.has("more_half"):
                    number = f"{float(number) + 0.5:g}"
                self.add("amt", part.slot("unit") or part.value or "", literal=number, amt=act)
            elif part.name == "cnt":
                self.add("cnt", literal=count(part), cnt=act)
            elif part.name == "size":
                self.add("deg", SIZES.get(part.value or "", "little"), deg=act)
            elif part.name == "place":
                self._placed(act, part.first("loc"))

    def _placed(self, act: str, loc: AList) -> None:
        """Where it is done; "look at each block" is done in a loop."""
        if (every := loc.find("every")) is None:
            self.place("loc", act, loc)
        else:
            self.add("loc", place_word(loc), loc=act, wrt=self.every(every))

    def _manner(self, act: str, manner: AList) -> None:
        faster = manner.find("faster")
        word = manner.slot("adv") or manner.value or ""
        if faster is not None:
            word = faster.slot("adv") or faster.value or ""
            if "ADV" not in BORN.readings(word):  # "drive bigger"
                raise NoMeaningError(str(manner))
        mod = self.add("mod", word, mod=act)
        if faster is not None:
            self.add("deg", "more", deg=mod)
        for deg in manner.all("deg"):
            self.add("deg", degree(deg.value or ""), deg=mod)

    def _speech(self, speech: AList) -> str:
        verb = next(part.name for part in speech if part.name in ("say", "tell", "ask"))
        links: dict[str, str] = {}
        if (quote := speech.find("quote")) is not None:
            words = (quote.value or "").lower().removeprefix("that ").split()
            if not words or words[0] in CONJUNCTIONS:
                raise NoMeaningError(str(speech))
            links["obj"] = self.add("txt", literal=quote.value or "")
        elif not is_person(speech.first("listener")):
            raise NoMeaningError(str(speech))
        hearer = speech.find("hearer", "listener")
        if hearer is not None and hearer.parts:
            every = hearer.find("every")
            links["dest"] = (
                self.thing(hearer.find("np") or hearer, person=True)
                if every is None
                else self.every(every)
            )
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

    def inquired(self, inquiry: AList) -> Directive:
        """To find something out as a step: what is definite is looked up first, "something" is any thing."""
        before, self.telling = self.telling, True
        with self.drawing(pattern=False):
            directive = self.inquiry(inquiry)
        self.telling = before
        return directive

    def inquiry(self, inquiry: AList) -> Directive:
        """CHK for whether something is so; FIND for what something is like, of what kind it is or where."""
        if (whether := inquiry.find("whether")) is not None:
            return Directive("CHK", stated(self, whether.first("conds")))
        if inquiry.has("nearby"):
            return Directive("DO", self.graphlet(self.add("act", "look around")))
        if (done := inquiry.find("what_done")) is not None:
            wanted = self.add("obj")
            self.add("ako", done.slot("attribute"), ako=wanted)
            self.add("act", done.slot("does"), agt=self.aside(done.first("np")), obj=wanted)
            self.things.append(Thing(wanted, done.slot("attribute")))
            return Directive("FIND", self.graphlet(wanted))
        for name, kind in WONDERS.items():
            if (asked := inquiry.find(name)) is not None:
                thing = self._asked_of(asked)
                wanted = self.add(kind, **{kind: thing})
                if attribute := asked.slot("attribute"):
                    self.add("ako", attribute, ako=wanted)
                return Directive("FIND", self.graphlet(wanted))
        raise NoMeaningError(str(inquiry))

    def _asked_of(self, asked: AList) -> str:
        """Whose nature or whereabouts are asked: "what color it is", "its color", "the color of it"."""
        if own := asked.slot("own"):
            return self.oneself(SELF_OWN[own]) if own in SELF_OWN else self.pronoun(OWNING[own])
        return self.thing(asked.first("np", "owner"))

    def chain(self, chain: AList) -> Chain:
        """Plays one after another; look-ups come before the play that needs them."""
        made: list[Play] = []
        for part in chain:
            if part.name == "play":
                made += plays(self, part)
            elif part.name == "chain":
                made += self.chain(part).plays
            elif part.name == "elliptic":  # "turn left then right"
                made += self.chain(bare_chain(part)).plays
        return Chain(tuple(made))

    def looked_up(self) -> list[Play]:
        """The look-ups that wait, as plays of their own; none waits any more."""
        found, self.finds[:] = list(self.finds), []
        return [Play((Directive("FIND", find),)) for find in found]
