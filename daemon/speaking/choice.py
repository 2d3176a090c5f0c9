"""Which voice the configuration asks for."""

from __future__ import annotations

from daemon.config import Speaking
from daemon.speaking.espeak import EspeakVoice, installed
from daemon.speaking.silent import SilentVoice
from daemon.speaking.voice import Voice


class NoVoiceError(Exception):
    """The voice asked for is not installed."""

    def __init__(self, program: str, remedy: str) -> None:
        super().__init__(f"{program} is not installed; {remedy}")


def choose(speaking: Speaking) -> Voice:
    """The voice: espeak where it is installed or asked for, else the silent one.

    Raises:
        NoVoiceError: espeak is asked for and not installed.
    """
    if speaking.voice == "silent" or (speaking.voice == "auto" and not installed()):
        return SilentVoice()
    if not installed():
        raise NoVoiceError("espeak-ng", "apt install espeak-ng, or set speaking.voice to silent")
    return EspeakVoice(speaking.words_per_minute)
