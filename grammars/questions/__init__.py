"""Questions into nets: what is asked, the net it is about, and the node that is wanted.

`forms/question.py` names the function that makes each sort of question. `clause.py` draws the clause of a question as
it is asked and as it is told; what of it is wanted, the rest find out: a part of the clause (`wanted.py`), whether it
is so (`whether.py`), why and who says so (`reasons.py`), when (`occasions.py`). Questions about a thing need no clause
(`things.py`), nor do those about the robot's own doings and lessons in set words (`topics.py`).
"""
