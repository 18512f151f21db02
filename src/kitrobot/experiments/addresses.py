"""Addresses: each number and word of a mission that an experiment can vary, by a name such as `carry.v3.speed`.

An address has a range, what stands there now, and a way of putting another value there. The names are whole: nothing is
parsed, so dots in names of programs and robots do no harm; of two things with one name the first has the address.

Left to others: which addresses a mission has (`mission_addresses`, `world_addresses`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.variant import Value, Variant
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import did_you_mean

Put = Callable[[Variant, Value], None]


PROGRAM: Final = "program."
"""How addresses of whole programs begin; their values are names of LLL files."""


class ExperimentError(KitRobotError):
    """An experiment that makes no sense, or cannot be read from its folder or written there."""


@dataclass(frozen=True)
class Address:
    """A number or a word of a mission.

    Attributes:
        name: the address.
        current: what stands there; None: nothing.
        put: puts a value of the right kind into a variant.
        least: the smallest number, in `unit`.
        most: the largest number.
        whole: whether the numbers are whole.
        words: what can stand there instead of a number.
        any_word: whether any word can stand there, such as the name of a file.
        unit: of the numbers.
    """

    name: str
    current: Value | None
    put: Put
    least: float = -math.inf
    most: float = math.inf
    whole: bool = False
    words: tuple[str, ...] = ()
    any_word: bool = False
    unit: str = ""

    @property
    def takes_numbers(self) -> bool:
        """Whether numbers can stand there."""
        return self.least <= self.most

    @property
    def expected(self) -> str:
        """In words, what can stand there."""
        if self.any_word:
            return Sentence("the name of a file")
        if not self.takes_numbers:
            return one_of(self.words)
        bounds = f"{self.least:.15g}", f"{self.most:.15g}"
        if self.whole:
            return Sentence("a whole number from {least} to {most}", *bounds)
        unit = f" {self.unit}" if self.unit else ""
        return Sentence("a number from {least} to {most}{unit}", *bounds, unit)

    @property
    def example(self) -> str:
        """Values to begin with: all words, or about five numbers around what stands there."""
        if not self.takes_numbers:
            return ",".join(self.words)
        now = 0.0 if self.current is None or isinstance(self.current, str) else float(self.current)
        low = max(self.least, min(now / 2, now * 1.5))
        high = min(self.most, max(now / 2, now * 1.5))
        if high - low < (4 if self.whole else 1e-9):
            low, high = max(self.least, min(now, self.most - 4)), min(self.most, now + 4)
        if self.whole:
            low, high = math.floor(low), math.ceil(high)
            step: float = max(1, round((high - low) / 4))
        else:
            step = (high - low) / 4
        return f"{low:.6g}:{high:.6g}:{step:.6g}" if step > 0 else f"{low:.6g}"

    def read(self, text: str) -> Value:
        """A value from its text.

        Raises:
            ExperimentError: it cannot stand there.
        """
        word = text.strip()
        if self.any_word or word in self.words:
            return word
        try:
            number = float(word)
        except ValueError:
            raise self._refusal(word) from None
        return self.check(int(number) if number.is_integer() else number)

    def check(self, value: Value) -> Value:
        """The value as it is put there: a whole number where only such can stand.

        Raises:
            ExperimentError: it cannot stand there; NaN never can.
        """
        if isinstance(value, str):
            if self.any_word or value in self.words:
                return value
            raise self._refusal(value)
        if not self.takes_numbers or not math.isfinite(value) or not self.least <= value <= self.most:
            raise self._refusal(value)
        if float(value).is_integer():
            return int(value)
        if self.whole:
            raise self._refusal(value)
        return float(value)

    def _refusal(self, found: Value) -> ExperimentError:
        shown = found if isinstance(found, str) else f"{found:.15g}"
        message = Sentence("`{address}`: expected {expected}, found `{found}`", self.name, self.expected, shown)
        help: Help = Sentence("it is {current} in the mission", str(self.current)) if self.current is not None else ""
        return ExperimentError(message, help)


def collect_addresses(found: Iterable[Address]) -> dict[str, Address]:
    """Addresses by name; the first of a name."""
    known: dict[str, Address] = {}
    for address in found:
        known.setdefault(address.name, address)
    return known


def find_address(known: Mapping[str, Address], name: str) -> Address:
    """The address of that name.

    Raises:
        ExperimentError: the mission has none; the nearest one is named.
    """
    if name in known:
        return known[name]
    near: Help = did_you_mean(name, _alike(known, name))
    raise ExperimentError(
        Sentence("this mission has no `{address}` that could vary", name),
        near or Sentence("`kitrobot sweep FILE --addresses` lists all there are"),
    )


def _alike(known: Mapping[str, Address], name: str) -> list[str]:
    """Those to look for a misspelt one among, the likeliest first: of many thousands only some are compared."""
    parts = set(name.split("."))
    return sorted(known, key=lambda one: -len(parts.intersection(one.split("."))))
