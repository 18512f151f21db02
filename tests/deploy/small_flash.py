"""A micro:bit's flash with its file system, as far as a host touches it: pieces of 128 bytes, one spare page.

The rules are those that its firmware follows: the first unused piece from a start on; else a page whose pieces are all
freed, which is erased; else everything moves by a page, without what was freed.
"""

from __future__ import annotations

import itertools
import re

CHUNK, PAGE, END = 128, 1024, 256 * 1024
FREED, SPARE, START, UNUSED = 0, 253, 254, 255


class FlashFull(Exception):
    """No piece is left."""


class SmallFlash:
    """The memory, the board's own way with files, and what the receiver answers."""

    def __init__(self, first: int = 0x3BC00, start: int = 0, firmware: int = 7) -> None:
        self.bytes = bytearray((at * firmware) & 255 for at in range(first)) + bytearray(b"\xff" * (END - first))
        self.first = first
        self.last = END - 2 * PAGE  # the spare page, at first
        self.bytes[self.last] = SPARE
        self.pieces = (self.last - first) // CHUNK
        self.start = start % self.pieces

    def count(self, count: int) -> None:
        """Nobody wants to know."""

    @property
    def base(self) -> int:
        """Where the piece with the number 1 is."""
        return self.first + (PAGE if self.bytes[self.first] == SPARE else 0)

    def at(self, number: int) -> int:
        """Where a piece is."""
        return self.base + CHUNK * (number - 1)

    def put(self, name: str, content: bytes) -> None:
        """The board writes a file."""
        self.remove(name)
        number = first = self._piece()
        self.bytes[self.at(number)] = START
        data = bytes((len(name),)) + name.encode()
        self._program(self.at(number) + 2, data)
        place = 2 + len(data)
        for byte in content:
            self._program(self.at(number) + place, bytes((byte,)))
            place += 1
            if place == CHUNK - 1:
                following = self._piece()
                self.bytes[self.at(number) + CHUNK - 1] = following
                self.bytes[self.at(following)] = number
                number, place = following, 1
        self.bytes[self.at(first) + 1] = place - 1

    def files(self) -> dict[str, bytes]:
        """All files, as the board reads them."""
        found = {}
        for number in range(1, self.pieces + 1):
            at = self.at(number)
            if self.bytes[at] == START:
                size = self.bytes[at + 2]
                name = bytes(self.bytes[at + 3 : at + 3 + size]).decode()
                end, place, content = self.bytes[at + 1] + 1, 3 + size, b""
                while (following := self.bytes[at + CHUNK - 1]) != UNUSED:
                    content += bytes(self.bytes[at + place : at + CHUNK - 1])
                    at, place = self.at(following), 1
                found[name] = content + bytes(self.bytes[at + place : at + end])
        return found

    def remove(self, name: str) -> None:
        """The board removes a file."""
        for number in range(1, self.pieces + 1):
            at = self.at(number)
            size = self.bytes[at + 2]
            if self.bytes[at] == START and bytes(self.bytes[at + 3 : at + 3 + size]) == name.encode():
                while number <= self.pieces:
                    self.bytes[self.at(number)] = FREED
                    number = self.bytes[self.at(number) + CHUNK - 1]
                return

    def value(self, expression: str) -> bytes:
        """What the receiver of the board answers."""
        name, *numbers = re.findall(r"\w+", expression)
        if name == "g":
            at, step, count = map(int, numbers)
            return bytes(self.bytes[at : at + step * count : step])
        assert name == "k", expression
        page = int(numbers[0])
        assert page % PAGE == 0
        assert self.first <= page < self.last + PAGE
        self.bytes[page : page + PAGE] = b"\xff" * PAGE
        return b"None"

    def write_words(self, at: int, words: bytes) -> None:
        """What the receiver does when it is told words."""
        assert at % 4 == len(words) % 4 == 0
        assert self.first <= at
        assert at + len(words) <= self.last + PAGE
        self._program(at, words)

    def _program(self, at: int, data: bytes) -> None:
        for place, byte in enumerate(data, at):
            self.bytes[place] &= byte

    def _piece(self) -> int:
        numbers = [(self.start + turn) % self.pieces + 1 for turn in range(self.pieces)]
        for number in numbers:
            if self.bytes[self.at(number)] == UNUSED:
                return number
        for number in numbers:
            at = self.at(number)
            if at % PAGE == 0 and not any(self.bytes[at : at + PAGE : CHUNK]):
                self.bytes[at : at + PAGE] = b"\xff" * PAGE
                return number
        if sum(self.bytes[self.at(number)] == FREED for number in numbers) < 8:
            raise FlashFull
        self._tidy()
        return self._piece()

    def _tidy(self) -> None:
        pages = list(range(self.first, self.last + PAGE, PAGE))
        if self.bytes[self.first] != SPARE:
            pages.reverse()
        for to, source in itertools.pairwise(pages):
            self.bytes[to : to + PAGE] = b"\xff" * PAGE
            for chunk in range(0, PAGE, CHUNK):
                if self.bytes[source + chunk] != FREED:
                    self.bytes[to + chunk : to + chunk + CHUNK] = self.bytes[source + chunk : source + chunk + CHUNK]
        self.bytes[pages[-1] : pages[-1] + PAGE] = bytes((SPARE,)) + b"\xff" * (PAGE - 1)
