"""Functions that run from the flash of a small board: what may be in them, and how their code is laid out."""

from __future__ import annotations

import ast
import builtins
import struct
from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.microbit_2016.flash_code import (
    CHUNK,
    HEAD,
    OF_OTHERS,
    FlashBlock,
    Function,
    build_block,
    lay_out,
    literals_of,
)
from kitrobot.deploy.microbit_2016.flash_loop import loop_block
from kitrobot.deploy.minification.builtin_names import GLOBALS, LOCALS

BEHIND = bytes((0x14, 0xAA, 0xF9, 0x5E, 0x5B))


def functions(text: str) -> list[ast.FunctionDef]:
    return [one for one in ast.parse(text).body if isinstance(one, ast.FunctionDef)]


def dumped(function: Function, body: bytes, *, arguments: int | None = None, file: bytes = b"\x8c\x21") -> bytes:
    """What a board writes down: names of arguments, then the code, and whatever is behind it in memory."""
    count = function.arguments if arguments is None else arguments
    names = struct.pack(f"<{count}I", *range(6, 6 + 4 * count, 4)).ljust(32, b"\xee")
    code = bytes((4, 0, 0, count, 0, 0, 6, 0x82, 0x4C)) + file + b"\0\xff" + body + b"\x11\x5b"
    return names + (code + BEHIND).ljust(function.dumped, b"\xee")


def one(*sizes: int) -> FlashBlock:
    listed = tuple(Function(f"f{number}", number % 4, size) for number, size in enumerate(sizes))
    return FlashBlock("kr01234567", (("text", listed),), frozenset(), {})


def places(content: bytes, count: int) -> Sequence[tuple[int, int]]:
    found = struct.unpack_from(f"<{2 * count}H", content, HEAD)
    return list(zip(found[::2], found[1::2], strict=True))


@pytest.mark.parametrize(
    "text",
    [
        "def f():\n def g(): pass",
        "def f(): return lambda: 0",
        "def f(a): return [b for b in a]",
        "def f(a): return any(b for b in a)",
        "def f(): return (1, 2)",
        "def f(): return 1 << 30, 1073741824",
        "def f(): return 0.5",
        "def f(): return 'a'",
        "def f(): return b'a'",
        "def f(a): return f'{a}'",
        "def f():\n import gc",
        "def f():\n yield 1",
    ],
)
def test_what_has_no_place_in_flash_is_refused(text: str) -> None:
    with pytest.raises(TypeError, match="`f` cannot run from flash"):
        build_block([functions(text)], {})


def test_strings_and_bytes_are_found_once_each() -> None:
    assert literals_of(functions("def f(a): return a('x', b'y', 'x', 1, None)")) == ["'x'", "b'y'"]


def test_the_loop_of_a_small_board_uses_names_that_are_short_enough() -> None:
    loop = loop_block()
    assert loop is loop_block()
    python = {name for thing in (builtins, bytes, list) for name in dir(thing)}
    ports = {"add", "any", "read", "sleep", "stop", "struct", "uart", "pack", "do", "loop"}
    assert loop.names - python - ports <= {*GLOBALS, *LOCALS}
    assert all(len(function.name) < 9 for function in loop.functions)


def test_code_and_arguments_are_where_the_table_says() -> None:
    made = one(60, 90, 200)
    bodies = [bytes((0x60 + number,)) * 20 for number in range(3)]
    dump = b"".join(dumped(function, body) for function, body in zip(made.functions, bodies, strict=True))
    content = lay_out(made, [dump])
    for (code, names), body, function in zip(places(content, 3), bodies, made.functions, strict=True):
        assert code % 4 == names % 4 == 0
        size = 4 * function.arguments
        assert content[names : names + size] == struct.pack(
            f"<{function.arguments}I", *range(6, 6 + 4 * function.arguments, 4)
        )
        # The name of the file became the function's own, which the firmware knows; what is behind the end is gone.
        start = bytes((4, 0, 0, function.arguments, 0, 0, 6, 0x82, 0x4C, 0x82, 0x4C, 0, 0xFF))
        assert content[code:].startswith(start + body + b"\x11\x5b")
    assert BEHIND not in content


@given(st.lists(st.binary(min_size=1, max_size=700), min_size=1, max_size=12), st.integers(0, 255))
def test_no_piece_begins_with_a_byte_that_means_something(bodies: list[bytes], filling: int) -> None:
    made = one(*(len(body) for body in bodies))
    try:
        dump = b"".join(dumped(function, body) for function, body in zip(made.functions, bodies, strict=True))
        content = lay_out(made, [dump])
    except BoardError:
        return  # there are bytes that leave no place at all
    assert not [at for at in range(CHUNK, len(content), CHUNK) if content[at] in OF_OTHERS]


@pytest.mark.parametrize("cut", [0, 10, 32, 40, 60])
def test_a_dump_without_an_end_is_of_a_firmware_that_we_do_not_know(cut: int) -> None:
    made = one(60)
    with pytest.raises(BoardError, match="none that KitRobot knows"):
        lay_out(made, [dumped(made.functions[0], b"\x60" * 20)[:cut]])


def test_a_function_that_takes_something_else_is_of_a_firmware_that_we_do_not_know() -> None:
    made = one(60)
    with pytest.raises(BoardError, match="none that KitRobot knows"):
        lay_out(made, [dumped(made.functions[0], b"\x60" * 20, arguments=3)])


@pytest.mark.parametrize("file", [b"\x21", b"\x8c\x21", b"\x81\x8c\x21"])
def test_the_name_of_the_file_may_have_any_length(file: bytes) -> None:
    made = one(60)
    try:
        content = lay_out(made, [dumped(made.functions[0], b"\x60" * 20, file=file)])
    except BoardError:
        assert len(file) < 2, "the function's name is longer than what it stands for"
        return
    code = places(content, 1)[0][0]
    name = content[code + 7 + 2 : code + 7 + 2 + len(file)]
    number = 0
    for byte in name:
        number = number << 7 | byte & 0x7F
    assert number == (2 << 7 | 0x4C)
