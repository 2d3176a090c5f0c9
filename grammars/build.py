"""Actions and chains into nets, upon things. docs/net.md is the law here. Clauses are in `clauses.py`, what is said in
`speaking.py`, what is to be found out in `inquiries.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from grammars.alist import AList
from grammars.approaching import approached
from grammars.chains import (
    TURNING,
    bare_chain,
    degrees_so,
    is_odd,
    one_by_one,
    plays,
    that_too,
    turned,
    turns,
    with_gaps,
)
from grammars.errors import NoMeaningError
from grammars.how_done import is_odd_manner
from grammars.manners import SIZES, bounded, limited, manner, not_too, resulting, unit_of, within
from grammars.measures import summed
from grammars.mentions import (
    but,
    is_time,
    place_word,
)
from grammars.pacing import count, in_a_while, spaced, waited, whole
from grammars.reporting import reported
from grammars.several import gathered
from grammars.sorts import classes
from grammars.speaking import spoken
from grammars.things import Things
from grammars.usage import is_used, particles, put_nowhere
from grammars.vocabulary import BORN
from kernel.action.chain import Chain, Directive, Play
from kernel.memory.editing import OTHER_WAY
from kernel.net.graphlet import Graphlet

__all__ = ["Build", "NoMeaningError"]

TAKEN: Final = frozenset("bow look nap rest spin walk stroll ride peek swing stretch".split())
STEP: Final = "step"
LETTING_GO: Final = ("release", "drop")  # everything: all that it holds


@dataclass
class Build(Things):
    """The drawing of one sentence: its things, actions and chains."""

    def action(self, action: AList) -> str:
        """Node of an action; what it is done to stays to be looked up, or is on the board of a pattern."""
        speech = action.find("speech", "speaking")
        if speech is not None and not is_odd_manner(action, None):
            act = spoken(self, speech)
            self.modifiers(act, action)
            return act
        if action.has("side_turn"):
            action = turned(action)
        if action.value is not None:
            action = AList(action.name, (AList("act", value=action.value),))
        verb, way = self._verb(action)
        if verb == "let":  # "let me down"
            raise NoMeaningError(str(action))
        if put_nowhere(verb, action, action.find("np", "every")):
            raise NoMeaningError("a thing in a place that is put nowhere")
        if action.slot("dir") == "for" and self._particle != "for":
            raise NoMeaningError(str(action))
        if is_odd(action) or not is_used(action, verb, self.pattern, self.naming):
            raise NoMeaningError(str(action))
        particle, self._particle = self._particle, ""  # things may have verbs of their own
        links: dict[str, str] = {}
        if (every := action.find("every")) is not None and (every.parts or verb not in LETTING_GO):
            links["obj"] = self.every(every)
        if (obj := action.find("np")) is not None:
            self.grasping = action.slot("act") in classes()["grasping"]
            links["obj"] = self.thing(obj)
            self.grasping = False
            self.topic = links["obj"] if self.trigger else self.topic
        if (where := action.find("whereis")) is not None:
            links["obj"] = self.whereabouts(where)
        if (iobj := action.find("iobj")) is not None:
            if "GIVE" not in BORN.readings(action.slot("act")):
                raise NoMeaningError(str(action))
            links["dest"] = self.thing(iobj.first("np"), person=True)
        if (dest := action.find("dest")) is not None:
            every = dest.find("every")
            links["dest"] = self.aside(dest.first("np")) if every is None else self.every(every)
        act = self.add("act", verb, **links)
        if way:
            self.add("dir", way, dir=act)
        self._particle = particle
        self.modifiers(act, action, taken=way)
        return act

    def _verb(self, action: AList) -> tuple[str, str]:
        """Lexical item of the verb with its particle, and the direction that is part of it."""
        if action.has("letgo"):
            return "release", ""
        paces = action.find("paces")
        if paces is not None and paces.value in TAKEN:  # "take a bow"
            return paces.value or "", ""
        if paces is not None and STEP not in (paces.value, paces.slot("verb"), paces.slot("verbs")):
            raise NoMeaningError(str(action))  # "take a break"
        verb = action.slot("act", STEP)
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
        if (number := every.find("num")) is not None:
            self.times = whole(number.value or "")
        kind = (AList("ako", value="person"),) if every.has("each_person") else ()
        said = tuple(part for part in every if part.name not in ("num", "each_person"))
        if (left_out := every.find("excepting")) is not None:
            said = (*(part for part in said if part is not left_out), but(left_out))
        name = self.thing(AList("np", (AList("det", value="each"), *kind, *said)))
        self.sketch.change(name, ref="each")
        self.each = self.sketch.graphlet(name, *(term.name for term in self.finds.pop().terms))
        return name

    each: Graphlet | None = None
    times: int | None = None
    _particle: str = ""

    def modifiers(self, act: str, action: AList, taken: str = "") -> None:
        """Directions, manners, amounts, counts and places of an action."""
        particle, self._particle = self._particle, ""
        for part in action:
            if part.name == "dir" and part.value not in (particle, taken):
                self.add("dir", part.value or "", dir=act)
            elif part.name == "not_too":
                not_too(self, act, part)
            elif part.name == "manner":
                manner(self, act, part)
            elif part.name == "amt":
                part = summed(part)
                amt = self.add("amt", unit_of(part), literal=part.slot("num", "1"), amt=act)
                bounded(self, amt, part)
            elif part.name == "cnt":
                self.add("cnt", literal=limited(self, part, count(part)), cnt=act)
            elif part.name == "counting_up" and "count" in self.sketch.terms[act].lex:
                self.add("amt", literal=part.slot("num"), amt=act)
            elif part.name == "degrees_so" and not action.has("dest"):
                degrees_so(self, act, part)
            elif part.name == "up_close" and self.pattern:
                within(self, act, part.first("nearer"))
            elif part.name in ("counting_up", "in_a_while", "degrees_so", "up_close"):
                raise NoMeaningError(str(action))  # together with something else, or as a trigger
            elif part.name == "the_other_way":
                self.add("dir", OTHER_WAY, dir=act)
            elif part.name == "turns" and self.sketch.terms[act].lex.isdisjoint(TURNING):
                self.add("cnt", literal=f"{whole(part.slot('num'))}", cnt=act)  # "do two jumps"
            elif part.name == "turns":
                self.add("amt", "degree", literal=f"{turns(part) * 360:g}", amt=act)
            elif part.name == "paces" and part.value not in TAKEN:
                self.add("cnt", literal=part.slot("num", "1"), cnt=act)
            elif part.name == "size" and part.value is None:  # "as far as it will go"
                self.add("deg", "fully", deg=act)
            elif part.name == "size":
                self.add("deg", SIZES.get(part.value or "", "little"), deg=act)
            elif part.name == "resulting":
                resulting(self, act, part)
            elif part.name == "place":
                self._placed(act, part.first("loc"))

    def _placed(self, act: str, loc: AList) -> None:
        """Where it is done; "look at each block" is done in a loop. When it is to be done the robot does not know."""
        if not self.pattern and is_time(loc):
            raise NoMeaningError(str(loc))
        if (every := loc.find("every")) is None:
            self.place("loc", act, loc)
        else:
            self.add("loc", place_word(loc), loc=act, wrt=self.every(every))

    def whereabouts(self, where: AList) -> str:
        """Node of where a thing is."""
        np = where.find("np")
        if np is None:
            raise NoMeaningError(str(where))
        return self.add("loc", loc=self.thing(np))

    def act_or_any(self, action: AList | None) -> str:
        """Node of an action; of any act at all where none is named."""
        return self.add("act") if action is None else self.action(action)

    def chain(self, chain: AList) -> Chain:
        """Plays one after another; look-ups come before the play that needs them."""
        made: list[Play] = []
        if len(chain.parts) > 1 and any(part.has("over_all") for part in chain):
            raise NoMeaningError(str(chain))
        for part in chain:
            if (several := part.find("several")) is not None:
                made += self.chain(one_by_one(several)).plays
            elif (gapped := part.find("gapped")) is not None:
                made += self.chain(with_gaps(gapped)).plays
            elif (again := part.find("spaced")) is not None:
                made += self.chain(spaced(again)).plays
            elif (delayed := in_a_while(part)) is not None:
                made += self.chain(waited(delayed)).plays
            elif part.name == "so_told":
                made += self.chain(reported(made)).plays
            elif part.name == "play":
                made += plays(self, approached(part))
            elif part.name == "chain":
                made += self.chain(part).plays
            elif part.name == "elliptic" and part.has("barely"):  # "turn left then right"
                made += self.chain(bare_chain(part)).plays
            elif part.name == "elliptic":  # "look on the bed, then under it"
                made += self.chain(that_too(chain, part)).plays
        return Chain(tuple(gathered(made)))

    def looked_up(self) -> list[Play]:
        """The look-ups that wait, as plays of their own; none waits any more."""
        found, self.finds[:] = list(self.finds), []
        return [Play((Directive("FIND", find),)) for find in found]
