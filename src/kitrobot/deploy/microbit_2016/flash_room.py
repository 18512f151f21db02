"""Whether the flash of a micro:bit of 2016 has room for an installation, asked before anything is removed or written.

What is counted are pieces of its file system: of the files that stay, of those that are wanted, and of the block with
the loop. It refuses only what cannot fit: pieces that do not hang together may still leave no room for the block, which
the installation finds out itself (`Flash.write`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from kitrobot.deploy.errors import FullError
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.microbit_2016.flash import Flash, pieces
from kitrobot.deploy.microbit_2016.flash_code import CHUNK, HEAD, FlashBlock
from kitrobot.text.sentences import COMMA, Sentence, Series

_OF_A_LETTER = 0.5
"""Bytes of compiled code for a letter of its text, at least; 0.545 were found."""

_NAMED = 3


def refuse_what_has_no_room(
    board: Receiver, one: FlashBlock, wanted: Mapping[str, int], staying: Iterable[str], blocks: Iterable[int]
) -> None:
    """Raises a FullError when an installation is sure to find no room.

    Args:
        board: in touch with the board.
        one: what is to run from flash.
        wanted: sizes of all files of the installation.
        staying: names of the files on the board that stay, beside those that are wanted.
        blocks: signs of the blocks that stay, beside that of `one`.
    """
    flash = Flash.of(board)
    if flash is None:
        return  # there is hardly a file
    needed = sum(pieces(name, size) for name, size in wanted.items())
    needed += flash.pieces_of(one.sign) or least_pieces(one)
    there = {name: pieces(name, board.number(f"os.size({name!r})")) for name in staying}
    taken = sum(there.values()) + sum(flash.pieces_of(sign) for sign in blocks if sign != one.sign)
    if needed + taken <= flash.room:
        return
    largest = sorted(there, key=lambda name: -there[name])[:_NAMED]
    raise FullError(
        Sentence(
            "the board's flash has room for {free} bytes beside what stays on it, and this takes {needed}; "
            "nothing was sent",
            max(0, flash.room - taken) * CHUNK,
            needed * CHUNK,
        ),
        Sentence("remove files from the board (the largest are {files}), or use --fresh", Series(COMMA, largest))
        if largest
        else Sentence("make the program smaller, or take a board with more memory, such as a micro:bit V2"),
    )


def least_pieces(one: FlashBlock) -> int:
    """Pieces that a block has at least, before the board has compiled it."""
    letters = sum(function.letters for _, functions in one.groups for function in functions)
    return int(HEAD + _OF_A_LETTER * letters) // CHUNK
