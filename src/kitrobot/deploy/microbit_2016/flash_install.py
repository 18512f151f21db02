"""Installs compiled functions in a small board's flash: the board compiles them, the host reads and places them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import GarbledError
from kitrobot.deploy.microbit_2016.flash import Flash
from kitrobot.deploy.microbit_2016.flash_code import DUMP, FlashBlock, Function, lay_out, unknown_firmware
from kitrobot.text.sentences import Sentence

_TEXT = "krt.py"
_TRIES = 3
_COMPILING_S = 10
_DIGITS = 12
_NAMES = 300
"""Bytes that files take beside what is in them, at most."""


def freeze(board: Receiver, one: FlashBlock, retained: set[int], *, fresh: bool = False) -> int:
    """Puts functions into the flash, unless they are there; how many bytes were written.

    Args:
        board: in touch with the board, before and after.
        one: the functions.
        retained: signs of other blocks that stay.
        fresh: the functions are written anew if freed pieces lie beside them, which the board cannot use otherwise.

    Raises:
        SilentError: the board does not answer.
        BoardError: its MicroPython is none that we know, or the flash is full.
    """
    flash = Flash.of(board)
    if flash is None:
        board.write(_TEXT, one.groups[0][0].encode())
        flash = Flash.of(board)
    if flash is None:
        raise unknown_firmware()
    flash.clear({one.sign, *retained})
    if flash.find(one.sign) is not None and not (fresh and flash.has_stuck):
        board.remove(_TEXT)
        return 0
    flash.refuse_less_than(max(len(text) + _size(functions) for text, functions in one.groups) + _NAMES)
    _refuse_new_names(board, one.names)
    _remove_text(board, flash)
    flash.clear(retained)
    flash.erase()
    dumps = [_compiled(board, text, functions) for text, functions in one.groups]
    flash.see()
    _remove_text(board, flash)
    flash.clear(retained)
    flash.erase()  # a freed piece in a page of the block stays unusable for as long as the block is there
    content = lay_out(one, dumps)
    flash.write(one.sign, content)
    return len(content)


def _remove_text(board: Receiver, flash: Flash) -> None:
    """Removes the compiled text: in pieces between others, it would leave no run that is long enough for a block."""
    board.remove(_TEXT)
    flash.see_removals()


def _compiled(board: Receiver, text: str, functions: Sequence[Function]) -> bytes:
    """What the compiler makes of a text that writes that into the file DUMP, with an empty memory."""
    for _ in range(_TRIES):
        board.write(_TEXT, text.encode())
        board.end()
        board.repl.enter()
        try:
            board.repl.run("import micropython;micropython.opt_level(3)")
            board.repl.run(f"import {_TEXT[:-3]}", _COMPILING_S, patient=True)
        except GarbledError as error:
            failed = str(error)
        else:
            failed = ""
        board.begin()
        dump = board.read(DUMP) if DUMP in board.names() else b""
        board.remove(DUMP)
        if len(dump) == _size(functions):
            return dump
    if failed:
        raise BoardError(
            Sentence("the board cannot compile KitRobot: {reason}", failed),
            Sentence("send it once more; report it if it stays so"),
        )
    raise unknown_firmware()


def _size(functions: Sequence[Function]) -> int:
    """Bytes of DUMP."""
    return sum(function.written for function in functions)


def _refuse_new_names(board: Receiver, names: Iterable[str]) -> None:
    """Raises a BoardError when the firmware does not know all names: it would number them anew with each start."""
    board.end()
    board.repl.enter()
    heard = [board.repl.run("print(id('kr')>>2)").strip() for _ in range(3)]  # the prompt has no checksums
    first = max(heard, key=heard.count)
    board.begin()
    for name in sorted(names):
        if not first.isdecimal() or board.number(f"id({name!r})>>2") >= int(first[:_DIGITS]):
            raise unknown_firmware()
