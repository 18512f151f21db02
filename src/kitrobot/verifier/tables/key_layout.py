"""The layout of a state's fields in its key. Fields widen on demand: keys are rewritten when a number does not fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.verifier.tables.columns import WORD_BITS
from kitrobot.verifier.tables.events import ModelTooLargeError


@dataclass(frozen=True)
class Layout:
    """Of each field the word it is in, how far up, and its bits. Field 0 is in the first word.

    Attributes:
        word, shift, mask: by field.
        words: how many words there are, 1 or 2.
    """

    word: tuple[int, ...]
    shift: tuple[int, ...]
    mask: tuple[int, ...]
    words: int

    def key(self, state: Sequence[int]) -> tuple[int, int]:
        """The two words of a state; the second is 0 where there is one."""
        words = [0, 0]
        for word, shift, value in zip(self.word, self.shift, state, strict=True):
            words[word] |= value << shift
        return words[0], words[1]

    def state(self, x: int, y: int) -> tuple[int, ...]:
        """The fields of a key."""
        rows = zip(self.word, self.shift, self.mask, strict=True)
        return tuple(int(y if word else x) >> shift & mask for word, shift, mask in rows)

    def rows(self) -> list[int]:
        """Word, shift and mask of each field, one after another."""
        return [one for row in zip(self.word, self.shift, self.mask, strict=True) for one in row]


class Widths:
    """The bits of each field.

    Args:
        fields: how many there are.
        due: the field that has a bit for each agent; -1 for none.
        agents: how many agents there are.
    """

    def __init__(self, fields: int, due: int, agents: int) -> None:
        self._bits = [agents if field == due else 0 for field in range(fields)]

    def widen(self, field: int, number: int) -> Layout:
        """The layout in which a field holds a number.

        Raises:
            TooManyError: two words are too small for all fields.
        """
        self._bits[field] = max(self._bits[field], number.bit_length())
        return self.layout()

    def layout(self) -> Layout:
        """Where the fields are."""
        word, shift, used = [], [], [0, 0]
        for bits in self._bits:
            at = 0 if used[0] + bits <= WORD_BITS else 1
            if used[at] + bits > WORD_BITS:
                raise ModelTooLargeError
            word.append(at)
            shift.append(used[at])
            used[at] += bits
        masks = tuple((1 << bits) - 1 for bits in self._bits)
        return Layout(tuple(word), tuple(shift), masks, 2 if used[1] else 1)
