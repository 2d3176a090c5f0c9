"""Permissions: operators on ALLOW, which void the prohibitions they are at least as specific as."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import enablement, exception
from grammars.registry import sentence_form
from grammars.timing import by_time
from grammars.triggers import settled
from kernel.action.chain import Chain, Directive
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach

EXAMPLES = (
    "you can grab a person if she is hurt",
    "it is okay to lift the toy cat",
    "You may touch my sneakers.",
    "you are allowed to drive backwards now",
    "you may turn left again",
)


@sentence_form("permission", "permission", EXAMPLES)
def permission(alist: AList) -> Teach:
    """An exception to what is forbidden."""
    build = Build()
    if alist.has("is_fine") and any(part.has("speech") for part in alist.all("action")):
        raise NoMeaningError("a question to be asked")  # "ask Mary if she is okay"
    first = alist.parts[0].name == "conds"
    before = enablement(build, alist) if first else ()
    deed, times = by_time(build, _once_more(alist.first("action", "gerunding")))
    with build.drawing(pattern=True):
        trigger = build.graphlet(build.action(deed))
    if first:
        trigger, before = settled(build, trigger, before)
    operator = Operator(
        Directive("ALLOW", trigger),
        Chain(),
        enablement=(*times, *(before or enablement(build, alist))),
        unless=exception(build, alist),
    )
    return Teach("permission", operator)


def _once_more(action: AList) -> AList:
    """ "You may turn left again" permits turning left, not only doing so again."""
    return AList(
        action.name,
        tuple(part for part in action if not _is_again(part)),
        action.value,
    )


def _is_again(part: AList) -> bool:
    return part.name == "manner" and "again" in (part.value, part.slot("adv"))
