"""What the process of an agent tells the one that started it: its sentences with their templates, one a line.

Both are this KitRobot, and nobody else writes into the pipe between them; a line that is none of these is passed over.
"""

from __future__ import annotations

import binascii
import pickle
from dataclasses import dataclass

from kitrobot.text import Sentence

MOST_LINE_BYTES = 64 * 1024


@dataclass(frozen=True)
class Told:
    """What an agent says of itself; `failed`: why it ended, with a way out in `help`."""

    sentence: str
    help: str = ""
    failed: bool = False


def told_line(told: Told) -> bytes:
    """As a line."""
    return binascii.b2a_base64(pickle.dumps((told.sentence, told.help, told.failed)))


def read_told(line: bytes) -> Told | None:
    """What a line says; None where it is none of ours."""
    try:
        sentence, help, failed = pickle.loads(binascii.a2b_base64(line))
    except Exception:  # whatever a line that was cut off makes of it
        return None
    if not isinstance(sentence, Sentence | str):
        return None
    return Told(sentence, help if isinstance(help, str) else "", bool(failed))
