"""English to nets: sentences of ten and of twenty words, and sentences that mean nothing."""

from _timing import collect, report, timed

from grammars.errors import NotUnderstoodError
from grammars.parse import parse

TEN = [
    "if something is close then drive backwards and say help",
    "to cha-cha drive forward then drive backwards then turn around",
    "you should never grab a person but say no thanks",
    "before you grab a block open the gripper very slowly",
    "drive forward slowly for two seconds then turn left twice",
]
TWENTY = [
    "if something is close then drive backwards and say help then turn left very slowly and then drive forward slowly",
    "to dance drive forward then turn left then drive backwards then turn right then raise the lift and say hooray",
]
NONSENSE = [
    "red the forward if slowly never block a then",
    "interest rates fall when the market opens on monday",
    "the the the the",
]


def understood(sentence: str) -> bool:
    """Whether it means anything."""
    try:
        parse(sentence)
    except NotUnderstoodError:
        return False
    return True


def main() -> None:
    report("the first sentence after the start", [timed(lambda: understood(TEN[0]))])
    for name, sentences, target in [
        ("ten words", TEN, "target < 15 ms median"),
        ("twenty words", TWENTY, "target < 40 ms median"),
        ("nonsense, refused", NONSENSE, "target < 50 ms"),
    ]:
        wanted = name != "nonsense, refused"
        if strange := [sentence for sentence in sentences if understood(sentence) != wanted]:
            print(f"{name}: left out, {'not understood' if wanted else 'understood'}: {strange}")
        kept = [sentence for sentence in sentences if sentence not in strange]
        report(
            name,
            [t for sentence in kept for t in collect(lambda s=sentence: understood(s), 40)],
            target,
        )


if __name__ == "__main__":
    main()
