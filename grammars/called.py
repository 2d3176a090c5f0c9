"""What somebody or something is called, where it is the name that is spoken of: "is her name Mary"."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build
from grammars.relatives import predicate
from grammars.sorts import kind


def called(build: Build, subject: AList, asks: AList) -> str:
    """ "Is her name Mary": whether she is Mary."""
    pred, owner = asks.find("pred"), subject.find("own", "owner") or _of_owner(subject)
    if kind(subject) != "name" or owner is None or pred is None or not pred.has("isname"):
        return ""
    who = _owned_by(build, owner)
    return predicate(build, who, pred, negated=False)


def _of_owner(np: AList) -> AList | None:
    """Of whom: "the name of the dog"."""
    return next((of for rel in np.all("rel") for of in rel.all("of_owner")), None)


def _owned_by(build: Build, owner: AList) -> str:
    """Node of whom "her" or "Mary's" tells of."""
    if owner.name != "own":
        return build.thing(owner.find("np") or owner, person=owner.has("name"))
    return build.whom(owner.value or "")
