"""The flash of a micro:bit of 2016: the space that its file system leaves free, for code that is executed in place.

The file system consists of pieces of 128 bytes. The first byte of each is its kind (freed, unused, the start of a
file, or the number of the piece before it), the last one the number of the next. A piece that is neither freed nor
unused is left alone, and copied when the board compacts its flash. So a block of ours is a run of pieces that belong
to no file; the board may move it by a page when it writes a file, and it is found by its head
(`kitrobot.deploy.microbit_2016.flash_code.head`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kitrobot.deploy.errors import BoardError, FullError
from kitrobot.deploy.line.receiver import Receiver, strange
from kitrobot.deploy.microbit_2016.flash_code import CHUNK, HEAD, head, unknown_firmware
from kitrobot.text.sentences import Sentence

PAGE = 1024
END = 256 * 1024
FIRST = END - 30 * PAGE
"""The file system never begins earlier."""

_FREED, _SPARE, _START, _UNUSED = 0, 253, 254, 255
_OURS = head(0, 0, whole=True)[0]
_AT_ONCE = 40
"""Bytes that are asked for at once."""

_DATA = CHUNK - 2
"""Bytes of a file that a piece holds."""

_CHUNKS_A_PAGE = PAGE // CHUNK
_SCRIPT = (0x3E000 - FIRST) // CHUNK
"""Where an editor may have put a script, which begins with M; files end in front of it then."""


@dataclass
class Area:
    """The pieces of the file system, in the order in which they lie: address, first byte and last byte of each."""

    start: int
    firsts: list[int]
    lasts: list[int]

    def address(self, place: int) -> int:
        """Where the piece at a place is."""
        return self.start + CHUNK * place

    def of_files(self) -> set[int]:
        """The places of pieces that files have."""
        found = set()
        for place, first in enumerate(self.firsts):
            if first != _START:
                continue
            while place not in found and 0 <= place < len(self.firsts):
                found.add(place)
                place = self.lasts[place] - 1
        return found


class Flash:
    """Blocks in the flash of the board that a receiver is in touch with. `area`: where its file system is."""

    def __init__(self, board: Receiver, area: Area) -> None:
        self.board = board
        self.area = area

    @classmethod
    def of(cls, board: Receiver) -> Flash | None:
        """The flash of a board; None when no file of two pieces or more says where its file system begins."""
        area = _area(list(_bytes(board, FIRST)), list(_bytes(board, FIRST + CHUNK - 1)))
        return None if area is None else cls(board, area)

    def see(self) -> None:
        """Reads again what each piece is, after files were written."""
        there = Flash.of(self.board)
        if there is None:
            raise unknown_firmware()
        self.area = there.area

    def see_removals(self) -> None:
        """Reads again what each piece is, after files were removed only: the file system begins where it did."""
        area = self.area
        count = len(area.firsts)
        firsts, lasts = (list(_bytes(self.board, area.start + at))[:count] for at in (0, CHUNK - 1))
        self.area = Area(area.start, firsts, lasts)

    def find(self, sign: int) -> int | None:
        """Where the whole block with that sign is."""
        return next((self.area.address(place) for place in self._blocks({sign})), None)

    def refuse_less_than(self, size: int) -> None:
        """Raises a FullError when files of so many bytes find no room."""
        if self.free < size:
            raise no_room()

    @property
    def free(self) -> int:
        """Bytes of files that there is room for."""
        return _DATA * sum(first in (_FREED, _UNUSED) for first in self.area.firsts)

    def pieces_of(self, sign: int) -> int:
        """How many pieces the whole block with that sign has; 0 when there is none."""
        return next(iter(self._blocks({sign}).values()), 0)

    @property
    def has_stuck(self) -> bool:
        """Whether freed pieces share a page with others: the board tidies them up only when there are eight or more."""
        return any(_FREED in pieces and not _is_empty(pieces) for _, pieces in self._pages())

    @property
    def room(self) -> int:
        """How many pieces there are, of files or not."""
        return len(self.area.firsts)

    def _blocks(self, signs: set[int]) -> dict[int, int]:
        """Where whole blocks with one of these signs are, with the number of their pieces."""
        found = {}
        for place, first in enumerate(self.area.firsts):
            if first == _OURS:
                start = _memory(self.board, self.area.address(place), 1, HEAD)
                chunks = int.from_bytes(start[-4:], "little")
                if any(start == head(sign, chunks, whole=True) for sign in signs):
                    found[place] = chunks
        return found

    def clear(self, retained: set[int]) -> None:
        """Frees what belongs neither to a file nor to a whole block with one of those signs."""
        area = self.area
        used = area.of_files()
        for place, chunks in self._blocks(retained).items():
            used.update(range(place, place + chunks))
        for place, first in enumerate(area.firsts):
            if place not in used and first not in (_FREED, _UNUSED):
                self._write(area.address(place), bytes((0, 255, 255, 255)))
                area.firsts[place] = _FREED

    def erase(self) -> None:
        """Erases the pages in which nothing is: the board writes a file into unused pieces only, wherever they are."""
        area = self.area
        for page, pieces in self._pages():
            if _FREED in pieces and _is_empty(pieces):
                self.board.value(f"k({area.address(page)})")
                area.firsts[page : page + _CHUNKS_A_PAGE] = [_UNUSED] * _CHUNKS_A_PAGE

    def _pages(self) -> Iterator[tuple[int, list[int]]]:
        """The place of the first piece of each page, and the first bytes of its pieces."""
        firsts = self.area.firsts
        for page in range(0, len(firsts), _CHUNKS_A_PAGE):
            yield page, firsts[page : page + _CHUNKS_A_PAGE]

    def write(self, sign: int, content: bytes) -> int:
        """Writes a block, reads it back and makes it count; where it is.

        Args:
            sign: the second word of its head.
            content: what it is, with room for the head in front; no piece begins with a byte that means something.

        Raises:
            FullError: there is no run of pieces that is long enough.
        """
        count = -(-len(content) // CHUNK)
        place = self._free(count)
        at = self.area.address(place)
        start = head(sign, count, whole=False)
        content = (start + content[len(start) :]).ljust(count * CHUNK, b"\x01")
        self._write(at, content)
        if self.read(at, len(content)) != content:
            raise BoardError(
                Sentence("what was written into the board's flash cannot be read back"), Sentence("send it once more")
            )
        self._write(at, head(sign, count, whole=True)[:4])
        self.area.firsts[place : place + count] = content[::CHUNK]
        return at

    def read(self, at: int, size: int) -> bytes:
        """So many bytes of the flash."""
        found = b""
        while len(found) < size:
            found += _memory(self.board, at + len(found), 1, min(_AT_ONCE, size - len(found)))
            self.board.count(_AT_ONCE)
        return found

    def _free(self, count: int) -> int:
        """The place where a run of unused pieces begins; pages without anything in them are erased for it."""
        firsts = self.area.firsts
        for erase in (False, True):
            if erase:
                self.erase()
            for place in range(len(firsts) - count + 1):
                if all(first == _UNUSED for first in firsts[place : place + count]):
                    return place
        raise no_room()

    def _write(self, at: int, words: bytes) -> None:
        self.board.write_words(at, words)


def _is_empty(pieces: Sequence[int]) -> bool:
    """Whether nothing is in any of these pieces, by their first bytes."""
    return all(first in (_FREED, _UNUSED) for first in pieces)


def pieces(name: str, size: int) -> int:
    """How many pieces a file of that name and so many bytes has."""
    return -(-(2 + len(name) + size) // _DATA)


def no_room() -> FullError:
    """The flash is full."""
    return FullError(
        Sentence("the board's flash has no room left in one piece"),
        Sentence("remove files of yours from the board, or use --fresh"),
    )


def _area(firsts: list[int], lasts: list[int]) -> Area | None:
    """The file system: the pages in which the numbers of all pieces fit to where they are."""
    if firsts[_SCRIPT] == ord("M"):
        del firsts[_SCRIPT:], lasts[_SCRIPT:]
    best, base = max((_links(firsts, lasts, base), base) for base in range(0, len(firsts), _CHUNKS_A_PAGE))
    if best == 0:
        return None
    pages = range(base, len(firsts), _CHUNKS_A_PAGE)
    # One page is spare: the one behind them, or the one in front. The last page of the flash is never theirs.
    end = next((page for page in pages if firsts[page] == _SPARE), pages[-1])
    return Area(FIRST + CHUNK * base, firsts[base:end], lasts[base:end])


def _bytes(board: Receiver, first: int) -> Iterator[int]:
    """The byte at an address, and every next one a piece further on, up to the end of the flash."""
    for at in range(first, END, _AT_ONCE * CHUNK):
        yield from _memory(board, at, CHUNK, min(_AT_ONCE, -(-(END - at) // CHUNK)))


def _memory(board: Receiver, at: int, step: int, count: int) -> bytes:
    """So many bytes of the board's memory, `step` apart."""
    found = board.value(f"g({at},{step},{count})")
    if len(found) != count:
        raise strange()
    return found


def _links(firsts: Sequence[int], lasts: Sequence[int], base: int) -> int:
    """How many files have a second piece that names its first, when the pieces are counted from `base` on."""
    found = 0
    for place in range(base, len(firsts)):
        second = base + lasts[place] - 1
        if firsts[place] == _START and second < len(firsts):
            if second < base or firsts[second] != place - base + 1:
                return 0
            found += 1
    return found
