"""Questions about what was so, or would be, on some occasion ("did you stop when I told you to", "what should you say
when somebody sneezes"), since when something is known, and about which of two things is so.
"""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.conditions import stated
from grammars.questions.clause import drawn
from kernel.action.chain import Directive, sequence
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet

PAST: Final = ("past_q", "has_q", "was_q", "pred", "gerunding")
_ME: Final = AList("np", (AList("pron", value="me"),))


def occasional(build: Build, body: AList) -> Question:
    """ "What should you say when somebody sneezes": what happens then; "do you dance when I sing": does that."""
    asks = body.first("asks")
    with build.drawing(pattern=True):
        so = drawn(build, asks)
        deed = build.graphlet(so.main)
    if so.past or not so.own:
        raise NoMeaningError(str(body))
    if (conds := body.find("conds")) is not None:
        main = stated(build, conds).main
    else:
        txt = build.add("txt", literal=body.slot("quote"))
        main = build.add("act", "say", agt=build.oneself("me"), obj=txt)
    if body.has("wh") or body.has("wh_adv"):
        return Question("what", build.graphlet(main), "", "happens")
    occasion = build.graphlet(main)
    named = [
        term.name for term in deed if occasion.mentioned & {term.name, *dict(term.links).values()}
    ]
    about = build.sketch.graphlet(main, *occasion.names, *(n for n in named if n != so.main))
    topic = "allowed" if so.topic == "allowed" and not asks.has("modal_q") else "happens"
    return Question("yesno", about, "", topic, sequence(Directive("DO", deed)))


def on_occasion(build: Build, about: Graphlet, body: AList, occasion: AList) -> Graphlet:
    """What is asked about, with what was so on that occasion: "where did you go when I told you to turn"."""
    asked = body.find("asks")
    around = occasion.find("action", "gerunding") is not None
    habitual = asked is not None and not any(asked.has(name) for name in PAST)
    if habitual and not around and body.name != "why":  # else it is what happens then
        raise NoMeaningError(str(occasion))
    if occasion.has("quote"):
        build.add("act", "say", obj=build.add("txt", literal=occasion.slot("quote")))
    elif (deed := occasion.find("action", "gerunding")) is not None:  # "before you turn"
        build.action(deed)
    elif (asks := occasion.find("asks")) is not None:
        drawn(build, asks)
    else:
        teller = build.thing(occasion.find("np") or _ME, person=True)
        build.add("act", "tell", agt=teller, dest=build.oneself("you"))
    return build.graphlet(about.main)


def since_told(build: Build, body: AList) -> Question:
    """ "When did you learn that Tim is tall", "how long have you known that": when somebody said so."""
    so = drawn(build, body.first("asks"))
    if so.own and so.inner:  # "when did you find out you broke it" is about no lesson
        raise NoMeaningError(str(body))
    return Question("when", build.graphlet(so.main), "", "taught")
