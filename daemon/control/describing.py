"""What a sentence means, for `sayso parse`: one dictionary with the fields of service.md."""

from __future__ import annotations

import json
import time
from typing import Any, Final

from grammars.describe import describe
from grammars.earley import grammar
from grammars.errors import NotUnderstoodError
from grammars.explain import explain
from grammars.parse import parse
from grammars.render import render
from grammars.replies import say
from grammars.vocabulary import BORN, Vocabulary
from kernel.memory.notation import write_meaning

NOTHING: Final[dict[str, Any]] = {
    "kind": "not_understood",
    "readback": "",
    "notation": [],
    "words": [],
    "steps": None,
    "parallel": False,
    "negated": False,
    "preference": None,
    "belief": None,
    "trigger": [],
    "ask": None,
    "unknown_words": [],
    "alternatives": 0,
}


def described(text: str, vocabulary: Vocabulary = BORN) -> dict[str, Any]:
    """The answer for one sentence; whatever the text is, there is one."""
    grammar()  # compiled before the first one is timed
    began_s = time.perf_counter()
    answer = _described(text, vocabulary)
    answer["ms"] = round((time.perf_counter() - began_s) * 1000, 2)
    return answer


def _described(text: str, vocabulary: Vocabulary) -> dict[str, Any]:
    try:
        parsed = parse(text, vocabulary)
        return {
            **describe(parsed),
            "readback": render(parsed.meaning, "teacher"),
            "notation": list(write_meaning(parsed.meaning)),
        }
    except NotUnderstoodError as error:
        unknown = list(error.unknown_words)
        return {"text": text, **NOTHING, "unknown_words": unknown, "reason": say(error).shown}
    except Exception as error:  # a list of sentences goes on after one that breaks the parser
        reason = f"internal error ({type(error).__name__}: {error})"
        return {"text": text, **NOTHING, "reason": reason}


def explained(text: str, vocabulary: Vocabulary = BORN) -> list[str]:
    """Lines on the readings of a sentence and their ranks; none where it has no reading."""
    try:
        return list(explain(parse(text, vocabulary)))
    except NotUnderstoodError:
        return []


def as_json_line(answer: dict[str, Any]) -> str:
    """One line."""
    return json.dumps(answer, ensure_ascii=False)


def as_text(answer: dict[str, Any]) -> str:
    """For a person."""
    if answer["kind"] == "not_understood":
        return f"not understood: {answer['reason']}"
    lines = [f"{answer['kind']}: {answer['readback']}", *answer["notation"]]
    if answer["unknown_words"]:
        lines.append(f"new words: {', '.join(answer['unknown_words'])}")
    return "\n".join(lines)
