"""`Refusals`: refused messages, reported without filling the log: once per sender and reason, then as a count.

A reason is the template of its sentence: the values in its holes make no other one. The count is reported when it has
another digit, so that a million messages are seven lines.
"""

from __future__ import annotations

from collections import Counter

from kitrobot.text.sentences import Sentence

MOST_KINDS = 512
"""Senders and reasons that are counted apart; the rest is counted together."""
NOBODY = -1
"""The sender of what has no seal."""


class Refusals:
    """What one process refused."""

    def __init__(self) -> None:
        self._counts: Counter[tuple[int, str]] = Counter()

    def count(self, sender: int, why: Sentence, times: int = 1) -> Sentence | None:
        """Counts refused messages; returns the sentence to report, mostly None."""
        key = sender, why.template
        if key not in self._counts and len(self._counts) >= MOST_KINDS:
            key = NOBODY, ""
        before = self._counts[key]
        count = self._counts[key] = before + times
        if count == 1:
            return Sentence("refused: {why}", why)
        if before == 0 or len(str(count)) > len(str(before)):
            return Sentence("refused {count} messages, the last one because: {why}", count, why)
        return None
