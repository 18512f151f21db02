"""Reports that an agent's process sends to the one that started it: sentences with their templates, one per line.

Both are this KitRobot, and nobody else writes into the pipe between them; a line that is no report is ignored.
"""

from __future__ import annotations

import binascii
import pickle
from dataclasses import dataclass

from kitrobot.text.sentences import Sentence

MOST_LINE_BYTES = 64 * 1024


@dataclass(frozen=True)
class StatusReport:
    """A report of an agent about itself; `failed`: `sentence` is why it ended, and `help` a way out."""

    sentence: str
    help: str = ""
    failed: bool = False


def encode_report(report: StatusReport) -> bytes:
    """Returns the report as a line."""
    return binascii.b2a_base64(pickle.dumps((report.sentence, report.help, report.failed)))


def decode_report(line: bytes) -> StatusReport | None:
    """Returns the report in a line; None if the line contains none."""
    try:
        sentence, help, failed = pickle.loads(binascii.a2b_base64(line))
    except Exception:  # whatever a line that was cut off makes of it
        return None
    if not isinstance(sentence, Sentence | str):
        return None
    return StatusReport(sentence, help if isinstance(help, str) else "", bool(failed))
