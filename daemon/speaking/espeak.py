"""espeak-ng at arm's length: the program is started for each text, in a thread, so that nothing waits for it."""

from __future__ import annotations

import shutil
import subprocess
import threading
from collections.abc import Callable
from contextlib import suppress

PROGRAM = "espeak-ng"


def installed() -> bool:
    """The program is there."""
    return shutil.which(PROGRAM) is not None


class EspeakVoice:
    """Speaks through the default sound output.

    Args:
        words_per_minute: pace.
        program: what to start; the text is its last argument.
        ended: called from the speaking thread when speech has ended.
    """

    def __init__(
        self,
        words_per_minute: int = 160,
        program: tuple[str, ...] = (PROGRAM,),
        ended: Callable[[], None] = lambda: None,
    ) -> None:
        self._command = (*program, "-s", str(words_per_minute), "--")
        self._ended = ended
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._speaking: threading.Thread | None = None
        self._cut = False
        self._failure: OSError | None = None

    def start(self, text: str, now_s: float) -> None:
        """Begin to say it."""
        self._cut = False
        self._speaking = threading.Thread(target=self._speak, args=(text,), daemon=True)
        self._speaking.start()

    def busy(self, now_s: float) -> bool:
        """The program is running.

        Raises:
            OSError: it could not be started, or failed.
        """
        failure, self._failure = self._failure, None
        if failure is not None:
            raise failure
        return self._speaking is not None and self._speaking.is_alive()

    def interrupt(self) -> None:
        """End it at once."""
        with self._lock:
            self._cut = True
            if self._process is not None:
                with suppress(ProcessLookupError):
                    self._process.kill()

    def _speak(self, text: str) -> None:
        try:
            with self._lock:
                if self._cut:
                    return
                self._process = subprocess.Popen(
                    [*self._command, text],
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                )
            _, said = self._process.communicate()
            if self._process.returncode and not self._cut:
                why = said.decode(errors="replace").strip() or f"status {self._process.returncode}"
                self._failure = OSError(f"{self._command[0]}: {why}")
        except OSError as error:
            self._failure = error
        finally:
            self._process = None
            self._ended()
