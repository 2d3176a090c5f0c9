"""What is loaded once is loaded before the first sentence comes."""

from __future__ import annotations

import gc

from daemon.understanding import warm_up
from grammars.nearest import english
from grammars.vocabulary import BORN


def test_what_refusing_needs_is_loaded_and_left_to_stay() -> None:
    english.cache_clear()
    try:
        warm_up(BORN)
        assert english.cache_info().currsize == 1
        assert gc.get_freeze_count() > 0
    finally:
        gc.unfreeze()
