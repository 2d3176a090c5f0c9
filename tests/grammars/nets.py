"""Random meanings within the conventions of docs/net.md, for properties of reading back."""

from __future__ import annotations

from hypothesis import strategies as st
from hypothesis.strategies import DrawFn, SearchStrategy

from kernel.action.chain import Chain, Directive, Loop, Play
from kernel.memory.lesson import Operator, Rule
from kernel.memory.meaning import (
    Choice,
    Command,
    Control,
    Fact,
    Meaning,
    Question,
    Revision,
    Teach,
)
from kernel.net.graphlet import Graphlet, Sketch, Term

KINDS = ["block", "cup", "person", "ball", "cereal box", "umbrella", "cat"]
NAMES = ["mary", "rick", "janey"]
QUALITIES = ["red", "heavy", "close", "open", "fragile"]
DEGREES = ["very", "too"]
VERBS = ["grab", "release", "push", "touch"]
QUOTES = [
    *(
        "hello",
        "I'm not allowed to",
        "watch out and stop",
        "left turn",
        "if you can",
        "10 inches, then",
    ),
    *(
        "stop",
        "to dance turn left",
        "unless Mary is near",
        "never grab a cup",
        "Zork! É?",
        "5 of 7: ok",
    ),
]
PLACES = ["next to", "behind", "in front of", "under", "left of"]


class Draft:
    """A sketch and what of it the graphlet being made contains."""

    def __init__(self, draw: DrawFn) -> None:
        self.draw, self.sketch = draw, Sketch()
        self.board: list[str] = []
        self.finds: list[Graphlet] = []
        self.kinds = list(
            KINDS
        )  # "the cup" twice in a sentence is the same cup, so each kind serves once
        self.names = list(NAMES)  # and so is Mary

    def one_of(self, *values: str) -> str:
        return self.draw(st.sampled_from(values))

    def maybe(self) -> bool:
        return self.draw(st.booleans())

    def add(self, kind: str, *lex: str, **more: object) -> str:
        name = self.sketch.add(kind, *lex, **more)  # type: ignore[arg-type]
        self.board.append(name)
        return name

    def oneself(self, who: str) -> str:
        """The robot or the speaker: one node in a sentence, described wherever it is mentioned."""
        for name, term in self.sketch.terms.items():
            if term.lex == {who}:
                self.board.append(name)
                return name
        return self.add("obj", who)

    def graphlet(self, main: str) -> Graphlet:
        """What was drawn since the last one."""
        board, self.board = self.board, []
        return self.sketch.graphlet(main, *board)

    def _owner(self, pattern: bool) -> str:
        """Somebody; a name is looked up by itself where things are."""
        who = self.one_of("me", "you", *self.names)
        if who not in NAMES:
            return self.oneself(who)
        self.names.remove(who)
        if pattern:
            return self.add("obj", who)
        before, self.board = self.board, []
        owner = self.add("obj", who)
        self.finds.append(self.graphlet(owner))
        self.board = before
        return owner

    def thing(self, articles: str = "both", deep: bool = True, pattern: bool = True) -> str:
        """Something described: a name, "something", "a red block", "my cup", "the cup next to the ball"."""
        sort = self.one_of("name", "something", "described", "described", "described")
        if self.names and (sort == "name" or not self.kinds):
            name = self.one_of(*self.names)
            self.names.remove(name)
            return self.add("obj", name)
        if (sort == "something" and articles != "the") or not self.kinds:
            return self.add("obj")
        ref = {"both": self.one_of("", "the"), "a": "", "the": "the"}[articles]
        thing = self.add("obj", ref=ref)
        described = self.one_of(*self.kinds)
        self.kinds.remove(described)
        compound, _, kind = described.rpartition(" ")
        ako = self.add("ako", kind, ako=thing)
        if compound:
            self.add("sub", compound, sub=ako)
        if self.maybe():
            quality = self.add("hq", self.one_of(*QUALITIES), hq=thing, negated=self.maybe())
            if self.maybe():
                self.add("deg", "very", deg=quality)
        if deep and self.maybe():
            self.add("loc", self.one_of(*PLACES), loc=thing, wrt=self.oneself("you"))
        if deep and not ref and self.maybe():
            self.add("own", own=thing, of=self._owner(pattern))
        return thing

    def looked_up(self, articles: str = "both") -> str:
        """A thing with its FIND."""
        before, self.board = self.board, []
        thing = self.thing(articles, pattern=False)
        self.finds.append(self.graphlet(thing))
        self.board = before
        return thing

    def action(self, pattern: bool) -> str:
        """An action with what may modify it."""
        sort = self.one_of("drive", "turn", "do", "say", "bare")
        if sort == "say":
            act = self.add("act", "say", obj=self.add("txt", literal=self.one_of(*QUOTES)))
        elif sort == "bare":
            act = self.add("act", self.one_of("dance", "cha-cha", "pick up"))
        elif sort == "do":
            obj = self.thing() if pattern else self.looked_up()
            act = self.add("act", self.one_of(*VERBS), obj=obj)
        else:
            ways = ["forward", "backward"] if sort == "drive" else ["left", "around", "clockwise"]
            act = self.add("act", sort)
            self.add("dir", self.one_of(*ways), dir=act)
            if self.maybe():
                self._modified(act, ["inch", "second"] if sort == "drive" else ["degree"])
        return act

    def _modified(self, act: str, units: list[str]) -> None:
        how = self.one_of("amount", "manner", "count", "size")
        if how == "amount":
            number = self.one_of("1", "2", "10", "0.5", "180")
            self.add("amt", self.one_of(*units), literal=number, amt=act)
        elif how == "manner":
            manner = self.add("mod", self.one_of("slowly", "carefully"), mod=act)
            if self.maybe():
                self.add("deg", "very", deg=manner)
        elif how == "count":
            self.add("cnt", literal=self.one_of("2", "3", "12"), cnt=act)
        else:
            self.add("deg", self.one_of("little", "fully"), deg=act)

    def chain(self, *last: Directive) -> Chain:
        """One to three plays of one or two actions, look-ups before them, and what ends it."""
        plays: list[Play] = []
        for _ in range(self.draw(st.integers(1, 3))):
            parts = []
            for _ in range(self.draw(st.integers(1, 2))):
                act = self.action(pattern=False)
                parts.append(Directive("DO", self.graphlet(act)))
            plays += [Play((Directive("FIND", find),)) for find in self.finds]
            self.finds = []
            plays.append(Play(tuple(parts)))
        return Chain((*plays, *(Play((directive,)) for directive in last)))

    def inquiry(self, pattern: bool) -> Directive:
        """To find out whether something is so, or what or where something is."""
        sort = self.one_of("whether", "color", "kind", "place")
        if pattern:
            thing = self.thing("a", deep=False)
        else:
            anything = sort == "whether" and self.maybe()
            thing = self.add("obj") if anything else self.looked_up("the")
        if sort == "whether":
            return Directive("CHK", self.graphlet(self.statement(thing)))
        role = {"color": "hq", "kind": "ako", "place": "loc"}[sort]
        wanted = self.add(role, **{role: thing})
        if sort == "color":
            self.add("ako", "color", ako=wanted)
        return Directive("FIND", self.graphlet(wanted))

    def condition(self) -> Graphlet:
        """What a loop or a wait looks out for; of no person, as "nobody" is not taken up again by "they" everywhere."""
        self.kinds = [kind for kind in self.kinds if kind != "person"]
        board, self.board = self.board, []
        main = self.statement(self.thing("a", deep=False))
        condition = self.graphlet(main)
        self.board = board
        return condition

    def loop(self) -> list[Play]:
        """A loop; where it has a number or is for each thing it ends the chain, as more would be read into it."""
        sort = self.one_of("times", "until", "while", "ever", "each")
        if sort == "each":
            each = self.add("obj", ref="each")
            self.add("ako", self.kinds.pop(), ako=each)
            described = self.graphlet(each)
            act = self.add("act", self.one_of(*VERBS), obj=each)
            acts = [Play((Directive("DO", self.graphlet(act)),))]
            if self.maybe():
                acts.append(self.turning())
            return [Play((Loop(Chain(tuple(acts)), each=described),))]
        plays = [self.turning() for _ in range(self.draw(st.integers(1, 2)))]
        condition = self.condition() if sort in ("until", "while") else None
        loop = Loop(
            Chain(tuple(plays)),
            self.draw(st.integers(1, 12)) if sort == "times" else None,
            until=condition if sort == "until" else None,
            whilst=condition if sort == "while" else None,
        )
        return [Play((loop,))]

    def turning(self) -> Play:
        """A turn, with nothing that could be taken for the loop's own."""
        act = self.add("act", "turn")
        self.add("dir", self.one_of("left", "around"), dir=act)
        return Play((Directive("DO", self.graphlet(act)),))

    def watching(self) -> list[Play]:
        """Something made sure of, kept so, waited for, or stopped."""
        tag = self.one_of("ACH", "KEEP", "beside", "WAIT", "STOP")
        if tag == "WAIT":
            return [Play((Directive("WAIT", self.condition()),))]
        if tag == "STOP":
            act = self.add("act", self.one_of("turn", "dance"))
            return [Play((Directive("STOP", self.graphlet(act)),))]
        thing = self.looked_up("the")
        quality = self.add("hq", self.one_of("red", "open"), hq=thing)
        claim = self.graphlet(quality)
        finds = [Play((Directive("FIND", find),)) for find in self.finds]
        self.finds = []
        if tag == "beside":
            beside = (Directive("KEEP", claim),)
            return [*finds, Play(self.turning().required, beside)]
        return [*finds, Play((Directive(tag, claim),))]

    def going_on(self, alone: bool = False) -> Chain:
        """A chain with a loop, or with something that is watched, in it; alone: "stop turning" by itself is control."""
        first = [self.turning()] if alone or self.maybe() else []
        middle = self.loop() if self.maybe() else self.watching()
        return Chain((*first, *middle))

    def statement(self, thing: str) -> str:
        """Something said of a thing; the predicate."""
        sort = self.one_of("quality", "degree", "place", "kind")
        negated = self.maybe() and self.maybe()
        if sort == "place":
            mark = self.oneself("you")
            place = self.one_of(*PLACES)
            return self.add("loc", place, loc=thing, wrt=mark, negated=negated)
        if sort == "kind":
            return self.add("ako", self.one_of("toy", "girl", "robot"), ako=thing, negated=negated)
        quality = self.add("hq", self.one_of(*QUALITIES), hq=thing, negated=negated)
        if sort == "degree":
            self.add("deg", self.one_of(*DEGREES), deg=quality)
        return quality


def _with(build: object) -> SearchStrategy[Meaning]:
    @st.composite
    def made(draw: DrawFn) -> Meaning:
        meaning: Meaning = build(Draft(draw))  # type: ignore[operator]
        return meaning

    return made()


def _procedure(draft: Draft) -> Meaning:
    act = draft.action(pattern=True)
    trigger = draft.graphlet(act)
    strength = draft.draw(st.sampled_from([0.6, 0.8, 1.0, 1.1, 1.2]))
    chain = draft.chain()
    return Teach("procedure", Operator(Directive("DO", trigger), chain, preference=strength))


def _finding(draft: Draft) -> Meaning:
    if draft.maybe():
        trigger = draft.inquiry(pattern=True)
    else:
        trigger = Directive("FIND", draft.graphlet(draft.thing(deep=False)))
    strength = draft.draw(st.sampled_from([0.8, 1.0, 1.2]))
    return Teach("procedure", Operator(trigger, draft.chain(), preference=strength))


def _inquiring(draft: Draft) -> Meaning:
    step = draft.inquiry(pattern=False)
    plays = (*(Play((Directive("FIND", find),)) for find in draft.finds), Play((step,)))
    draft.finds = []
    more = draft.chain().plays if draft.maybe() else ()
    return Command(Chain((*plays, *more)))


def _failing(draft: Draft) -> Meaning:
    act = draft.add("act") if draft.maybe() else draft.action(pattern=True)
    main = draft.add("act", "fail", agt=draft.oneself("you"), obj=act)
    trigger = draft.graphlet(main)
    return Teach("reaction", Operator(Directive("NOTE", trigger), draft.chain()))


def _around(draft: Draft) -> Meaning:
    kind, tag = draft.draw(st.sampled_from([("before", "ANTE"), ("after", "POST")]))
    act = draft.action(pattern=True)
    trigger = draft.graphlet(act)
    return Teach(kind, Operator(Directive(tag, trigger), draft.chain()))


def _reaction(draft: Draft) -> Meaning:
    thing = draft.thing()
    main = draft.statement(thing)
    if draft.maybe():
        draft.statement(draft.thing("the", deep=False))
    trigger = draft.graphlet(main)
    exceptions: tuple[Graphlet, ...] = ()
    if draft.maybe():
        exceptions = (draft.graphlet(draft.statement(draft.thing("the", deep=False))),)
    strength = draft.draw(st.sampled_from([0.8, 1.0, 1.2]))
    operator = Operator(Directive("NOTE", trigger), draft.chain(), (), exceptions, strength)
    return Teach("reaction", operator)


def _trust(draft: Draft) -> Meaning:
    act = draft.add("act") if draft.maybe() else draft.action(pattern=True)
    if draft.names and draft.maybe():
        name = draft.one_of(*draft.names)
        draft.names.remove(name)  # whoever is named again later is the same node
        boss = draft.add("obj", name)
    else:
        boss = draft.thing("a", deep=False)
    draft.add("act", "tell", agt=boss, dest=draft.oneself("you"), cmd=act)
    trigger = draft.graphlet(act)
    punt = Directive("PUNT")
    chain = draft.chain(punt) if draft.maybe() else Chain((Play((punt,)),))
    return Teach("permission", Operator(Directive("ANTE", trigger), chain))


def _only(draft: Draft) -> Meaning:
    """Who alone may order an act: the telling is the way out."""
    act = draft.action(pattern=True)
    done = draft.graphlet(act)
    boss = draft.add("obj", draft.names.pop() if draft.names else "tom")
    tell = draft.add("act", "tell", agt=boss, dest=draft.oneself("you"), cmd=act)
    telling = draft.graphlet(tell)
    chain = Chain((Play((Directive("PUNT"),)),))
    return Teach("permission", Operator(Directive("ANTE", done), chain, unless=(telling,)))


def _prohibition(draft: Draft) -> Meaning:
    act = draft.action(pattern=True)
    trigger = draft.graphlet(act)
    enablement: tuple[Graphlet, ...] = ()
    if draft.maybe():
        enablement = (draft.graphlet(draft.statement(draft.thing(articles="a"))),)
    punt = Directive("PUNT")
    chain = draft.chain(punt) if draft.maybe() else Chain((Play((punt,)),))
    return Teach("prohibition", Operator(Directive("ANTE", trigger), chain, enablement))


def _permission(draft: Draft) -> Meaning:
    act = draft.action(pattern=True)
    return Teach("permission", Operator(Directive("ALLOW", draft.graphlet(act)), Chain()))


def _rule(draft: Draft) -> Meaning:
    thing = draft.thing(articles="a", deep=False)
    main = draft.statement(thing)
    condition = draft.graphlet(main)
    conclusion = draft.graphlet(draft.statement(thing))
    known = condition.names & conclusion.names  # the robot itself, described once
    kept = tuple(term for term in conclusion if term.name not in known)
    conclusion = Graphlet(kept, conclusion.main)
    belief = draft.draw(st.sampled_from([0.2, 0.5, 0.7, 0.8, 1.0]))
    return Teach("rule", Rule(condition, conclusion, belief=belief))


def _fact(draft: Draft) -> Meaning:
    thing = draft.looked_up("the")
    return Fact(draft.graphlet(draft.statement(thing)), tuple(draft.finds))


commands = _with(lambda draft: Command(draft.chain()))
going_on = _with(lambda draft: Command(draft.going_on(alone=True)))
procedures, arounds, reactions = _with(_procedure), _with(_around), _with(_reaction)
prohibitions, permissions = _with(_prohibition), _with(_permission)
findings, inquiries, failings = _with(_finding), _with(_inquiring), _with(_failing)
rules, facts, trusts = _with(_rule), _with(_fact), _with(_trust)


def _reached(draft: Draft) -> Meaning:
    trigger = Directive("ACH", draft.condition())
    return Teach("procedure", Operator(trigger, draft.going_on()))


reached = _with(_reached)


def _trusting(draft: Draft) -> Meaning:
    """Who may order what: an act, or anything at all."""
    act = draft.add("act") if draft.maybe() else draft.action(pattern=True)
    name = draft.one_of(*draft.names) if draft.names else "mary"
    boss = draft.add("obj", name)
    draft.add("act", "tell", agt=boss, dest=draft.oneself("you"), cmd=act)
    return Teach("permission", Operator(Directive("ALLOW", draft.graphlet(act)), Chain()))


def _alias(draft: Draft) -> Meaning:
    """A new word for a known one of each sort of node."""
    node, old = draft.draw(
        st.sampled_from([("act", "rotate"), ("dir", "left"), ("mod", "slowly"), ("hq", "red")])
    )
    new = draft.one_of("zork", "widder", "blimmish")
    said, meant = (Graphlet((Term(f"{node}-1", frozenset((w,))),), f"{node}-1") for w in (new, old))
    return Teach("alias", Rule(said, meant))


def _news(draft: Draft) -> Meaning:
    """Facts of other sorts: who has what, whose it is, what is more than what."""
    sort = draft.one_of("has", "whose", "more", "name")
    thing = draft.looked_up("the")
    if sort == "whose":
        owner = draft.oneself(draft.one_of("me", "you"))
        main = draft.add("own", own=thing, of=owner)
    elif sort == "has":
        had = draft.add("obj")
        draft.add("ako", draft.one_of("hat", "handle"), ako=had)
        main = draft.add("act", "have", agt=thing, obj=had)
    elif sort == "more":
        other = draft.looked_up("the")
        main = draft.add("hq", draft.one_of("tall", "heavy"), hq=thing, than=other)
    else:
        main = draft.add("loc", draft.one_of(*PLACES), loc=thing, wrt=draft.looked_up("the"))
    return Fact(draft.graphlet(main), tuple(draft.finds))


trustings, aliases, news = _with(_trusting), _with(_alias), _with(_news)


def _revision(draft: Draft) -> Meaning:
    """Other steps: instead of a deed, of the last ones, or more of them within a deed, or beside a step."""
    sort = draft.one_of("instead of", "instead", "first", "last", "at the end", "before", "after")
    steps = Chain((draft.turning(),))
    if sort in ("instead", "at the end"):
        return Revision(steps, last=sort == "at the end")
    if sort in ("before", "after"):
        step = draft.add("act")
        draft.add("hq", draft.one_of("first", "second", "last"), hq=step)
        return Revision(
            steps, draft.graphlet(step), beside="before" if sort == "before" else "after"
        )
    old = draft.graphlet(draft.add("act", draft.one_of("dance", "cha-cha")))
    if sort == "instead of":
        return Revision(steps, old)
    return Revision(steps, of=old, last=sort == "last")


def _control(draft: Draft) -> Meaning:
    """Something stopped or forgotten; who taught what."""
    sort = draft.one_of("stop", "how", "about", "learned")
    if sort in ("stop", "how"):
        act = draft.add("act", draft.one_of("turn", "dance", "cha-cha"))
        return Control("stop" if sort == "stop" else "forget", draft.graphlet(act))
    who = draft.add("obj", draft.one_of(*NAMES))
    return Control("learned" if sort == "learned" else "forget", draft.graphlet(who))


def _question(draft: Draft) -> Meaning:
    """Whether something is so."""
    thing = draft.looked_up("the")
    draft.board += [name for find in draft.finds for name in find.names]
    draft.finds = []
    return Question("yesno", draft.graphlet(draft.statement(thing)))


def _choice(draft: Draft) -> Meaning:
    """The one that is red."""
    one = draft.add("obj", ref=draft.one_of("one", "the"))
    if draft.sketch.terms[one].ref == "the":
        draft.add("ako", draft.one_of("block", "cup"), ako=one)
    draft.add("hq", draft.one_of(*QUALITIES), hq=one)
    return Choice(draft.graphlet(one))


revisions, controls, onlies = _with(_revision), _with(_control), _with(_only)
questions, choices = _with(_question), _with(_choice)
