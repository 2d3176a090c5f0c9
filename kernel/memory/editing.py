"""Corrections of what was taught or commanded, as changes of chains. Pure; ours, the paper has no revision."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Final

from kernel.action.chain import Chain, Directive, Loop, Part, Play
from kernel.memory.lesson import Operator, graphlets
from kernel.memory.likeness import OPPOSITES, covers
from kernel.memory.meaning import Beside
from kernel.memory.notation import mapped
from kernel.net.graphlet import Graphlet, Term

OTHER_WAY = "other way"  # "no, the other way": the opposite direction of the one the step had
ORDER: Final = {
    word: at
    for at, word in enumerate(
        "first second third fourth fifth sixth seventh eighth ninth tenth".split()
    )
} | {"last": -1}
ONE = frozenset(("one",))  # "the blue one": of whatever kind the other one is


def with_other_step(
    operator: Operator, old: Graphlet, new: Chain, beside: Beside = ""
) -> Operator | None:
    """The operator with `new` in the place of every step that the description `old` fits, or beside it; None if none
    does. A new step of no verb says how the old one is to be otherwise."""
    is_old = meant(old, operator.chain, tuple(graphlets(operator)))
    if alteration(new) is not None:
        chain = altered(operator.chain, new, is_old)
        return None if chain is None else replace(operator, chain=chain)
    return _with(operator, is_old, new, beside)


def meant(old: Graphlet, chain: Chain, drawn: Iterable[Graphlet]) -> Callable[[Graphlet], bool]:
    """Whether a step is meant by the description: "turning left", "the last step", "the second turn"."""
    head, drawn = old.head, tuple(drawn)
    order = next(
        (t for t in old if not t.lex.isdisjoint(ORDER) and ("hq", old.main) in t.links), None
    )
    if head is None or order is None:
        return lambda step: covers(old, drawn, step)
    bare = Graphlet(tuple(term for term in old if term is not order), old.main)
    steps = [step for step in chain.tagged("DO") if not head.lex or covers(bare, drawn, step)]
    at = ORDER[min(order.lex)]
    chosen = steps[at] if -len(steps) <= at < len(steps) else None
    return lambda step: step is chosen


def with_other_end(operator: Operator, new: Chain) -> Operator | None:
    """The operator with `new` in the place of its last step; None if it has no step."""
    steps = [d for d in operator.chain.directives() if d.tag == "DO"]
    if not steps:
        return None
    return _with(operator, lambda step: step is steps[-1].graphlet, new)


def with_more(operator: Operator, more: Chain, *, last: bool = False) -> Operator:
    """The operator with further steps at its beginning, or at its end."""
    more = _fresh(more, graphlets(operator))
    plays = (*operator.chain.plays, *more.plays) if last else (*more.plays, *operator.chain.plays)
    return replace(operator, chain=Chain(plays))


def without_step(operator: Operator, old: Graphlet) -> Operator | None:
    """The operator without the steps that the description fits; None if none does, or nothing would be left."""
    changed = with_other_step(operator, old, Chain(()))
    return changed if changed is not None and changed.chain.tagged("DO") else None


def alteration(new: Chain) -> Graphlet | None:
    """What says only how the last step is to be otherwise: a step of no verb."""
    steps = new.tagged("DO")
    head = steps[0].head if len(steps) == 1 else None
    if (
        head is None
        or head.lex
        or head.links
        or any(("hq", head.name) in t.links for t in steps[0])
    ):
        return None
    return steps[0]


def altered(
    chain: Chain, new: Chain, which: Callable[[Graphlet], bool] | None = None
) -> Chain | None:
    """The chain with the modifiers of that step of no verb in its last step, or in those that are meant, in the place
    of their own of the same sort; None if none fits. What they need is looked up first."""
    before: tuple[Play, ...] = ()
    steps = chain.tagged("DO")
    steps = steps[-1:] if which is None else [step for step in steps if which(step)]
    for step in steps:
        fresh = _fresh(new, chain.graphlets())
        change = alteration(fresh)
        other = None if change is None else _altered_step(step, change)
        if other is None:
            return None
        before = tuple(Play((d,)) for d in fresh.directives() if d.tag == "FIND")
        chain = _mapped(chain, _exchanged(step, other))
    return Chain((*before, *chain.plays)) if steps else None


def _exchanged(old: Graphlet, new: Graphlet) -> Callable[[Directive], tuple[Part, ...] | None]:
    return lambda directive: (Directive("DO", new),) if directive.graphlet is old else None


def _altered_step(last: Graphlet, change: Graphlet) -> Graphlet | None:
    if last.head is None:
        return None
    change = change.renamed({change.main: last.main})
    roles = {role for t in change for role, other in t.links if other == last.main}
    had = {t.name: t for t in last if any(r in roles and to == last.main for r, to in t.links)}
    terms = [_like(t, had.values()) for t in change if t.name != last.main]
    if None in terms:
        return None
    gone = {t.name for t in last if t.name in had or any(to in had for _, to in t.links)}
    kept = [t for t in last if t.name not in gone]
    return Graphlet((*kept, *(t for t in terms if t is not None)), last.main)


def _like(new: Term, had: Iterable[Term]) -> Term | None:
    """The modifier, with what it takes from the one before: "five" its unit, "the other way" its opposite."""
    before = next((t for t in had if {r for r, _ in t.links} == {r for r, _ in new.links}), None)
    if new.kind == "amt" and not new.lex:
        return None if before is None else replace(new, lex=before.lex)
    if new.lex == frozenset((OTHER_WAY,)):
        pair = next((p for p in OPPOSITES if before is not None and before.lex <= p), None)
        return None if pair is None or before is None else replace(new, lex=pair - before.lex)
    return new


def keeping(chain: Chain, kept: Chain) -> Chain:
    """The chain with what is to be kept so during its last play, looked up before."""
    kept = _fresh(kept, chain.graphlets())
    keeps = tuple(Directive("KEEP", graphlet) for graphlet in kept.tagged("KEEP"))
    finds = (Play((Directive("FIND", graphlet),)) for graphlet in kept.tagged("FIND"))
    *before, last = chain.plays
    return Chain((*before, *finds, replace(last, auxiliary=(*last.auxiliary, *keeps))))


def has_step(chain: Chain, old: Graphlet) -> bool:
    """Whether the description fits one of its steps."""
    drawn = [d.graphlet for d in chain.directives() if d.graphlet]
    return any(map(meant(old, chain, drawn), chain.tagged("DO")))


def with_other_thing(chain: Chain, old: Graphlet | None, new: Graphlet) -> Chain | None:
    """The chain with another thing looked up in the place of the one that `old` describes, or of the last one."""
    finds = chain.tagged("FIND")
    if old is not None:
        wanted = _kindless(old)
        finds = [g for g in finds if covers(wanted, (g,), g)]
    if not finds:
        return None
    before = finds[-1]
    renamed = _fresh_graphlet(new, chain.graphlets())
    renamed = renamed.renamed({renamed.main: before.main})
    kinds = [t for t in before if any(role == "ako" for role, _ in t.links)]
    terms = [t for t in renamed if t.lex != ONE]
    if len(terms) < len(renamed.terms):
        terms += kinds
    find = Directive("FIND", Graphlet(tuple(terms), before.main))
    return _mapped(chain, lambda d: (find,) if d.graphlet is before else None)


def _kindless(described: Graphlet) -> Graphlet:
    return Graphlet(tuple(t for t in described if t.lex != ONE), described.main)


def _with(
    operator: Operator, is_old: Callable[[Graphlet], bool], new: Chain, beside: Beside = ""
) -> Operator | None:
    new = _fresh(new, graphlets(operator))
    gone: list[Graphlet] = []
    found = False

    def swap(directive: Directive) -> tuple[Part, ...] | None:
        step = directive.graphlet
        nonlocal found
        if directive.tag != "DO" or step is None or not is_old(step):
            return None
        found = True
        if beside:
            more = tuple(_parts(new))
            return (*more, directive) if beside == "before" else (directive, *more)
        gone.append(step)
        return tuple(_parts(_heir(new, step)))

    chain = _mapped(operator.chain, swap)
    return replace(operator, chain=_pruned(chain, gone)) if found else None


def _parts(chain: Chain) -> Iterable[Part]:
    """A chain as what may stand in the place of one step."""
    for play in chain.plays:
        yield play.only or Chain((play,))


def _mapped(chain: Chain, swap: Callable[[Directive], tuple[Part, ...] | None]) -> Chain:
    """The chain with directives replaced: in a play of their own by plays, beside others by a chain of their own."""
    plays: list[Play] = []
    for play in chain.plays:
        swapped = swap(play.only) if isinstance(play.only, Directive) else None
        if swapped is not None:
            plays += [Play((part,)) for part in swapped]
            continue
        plays.append(Play(_beside(play.required, swap), _beside(play.auxiliary, swap)))
    return Chain(tuple(plays))


def _beside(
    parts: tuple[Part, ...], swap: Callable[[Directive], tuple[Part, ...] | None]
) -> tuple[Part, ...]:
    done: list[Part] = []
    for part in parts:
        if isinstance(part, Chain):
            done.append(_mapped(part, swap))
        elif isinstance(part, Loop):
            done.append(replace(part, body=_mapped(part.body, swap)))
        elif (swapped := swap(part)) is None:
            done.append(part)
        else:
            done.append(
                swapped[0] if len(swapped) == 1 else Chain(tuple(Play((p,)) for p in swapped))
            )
    return tuple(done)


def _heir(new: Chain, old: Graphlet) -> Chain:
    """A single new step of the same verb keeps what it does not mention: whom the words are said to."""
    steps = new.tagged("DO")
    before = old.head
    if len(steps) != 1 or before is None:
        return new
    (step,) = steps
    act = step.term(step.main)
    if act.lex != before.lex:
        return new
    missing = tuple(link for link in before.links if link[0] not in dict(act.links))
    heir = replace(act, links=tuple(sorted((*act.links, *missing))))
    whole = Graphlet(tuple(heir if t is act else t for t in step), step.main)
    return _mapped(new, lambda d: (Directive("DO", whole),) if d.graphlet is step else None)


def _pruned(chain: Chain, gone: list[Graphlet]) -> Chain:
    """Without the look-ups that only the steps that are gone needed."""
    was = {name for graphlet in gone for name in graphlet.mentioned}
    finds = chain.tagged("FIND")
    needed = {name for g in chain.graphlets() if g not in finds for name in g.mentioned}
    idle = {g.main for g in finds if g.main in was - needed}
    return _mapped(
        chain,
        lambda d: () if d.tag == "FIND" and d.graphlet and d.graphlet.main in idle else None,
    )


def _fresh(chain: Chain, taken: Iterable[Graphlet]) -> Chain:
    """The chain with names that nothing else in the operator uses."""
    taken = list(taken)
    fresh: Chain = mapped(chain, lambda graphlet: _fresh_graphlet(graphlet, taken))
    return fresh


def _fresh_graphlet(graphlet: Graphlet, taken: Iterable[Graphlet]) -> Graphlet:
    highest = max((_number(name) for other in taken for name in other.mentioned), default=0)
    names = {n: f"{Term(n).kind}-{_number(n) + highest}" for n in graphlet.mentioned}
    return graphlet.renamed(names)


def _number(name: str) -> int:
    return int(name.rpartition("-")[2])
