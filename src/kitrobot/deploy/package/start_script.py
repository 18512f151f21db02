"""The start of a robot on a board: the pieces that are the same for every program, in a file of their own.

A program file (`kitrobot.deploy.package.script`) begins with them. They load the interpreter and the loop, and make the
list that holds a robot's state. A board compiles the interpreter first, while most memory is free, then the loop, from
large to small; a board that executes them from its flash only locates them there.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.microbit_2016.flash import END, FIRST
from kitrobot.deploy.microbit_2016.flash_code import CHUNK, HEAD, FlashBlock, head
from kitrobot.deploy.package.onboard_bundle import (
    in_flash_pieces,
    join_statements,
    name_pieces,
    script_pieces,
    with_short_names,
)
from kitrobot.text.sentences import Sentence

_MOST = 9999
"""Bytes that a piece may have."""

_BACK = "$file.close();$file=$tail;$tail=0"


def start_file(interpreter: str, loop: Sequence[tuple[str, int]], requests: str) -> bytes:
    """The start of a board that compiles everything. `loop`: names and sizes of files, the port first."""
    port, *others = (f"exec(open({name!r}).read({size}))" for name, size in loop)
    return b"".join(map(piece, [f"from {interpreter} import $tick", port, *_list(requests), *others, _BACK]))


def start_from_flash(one: FlashBlock, family: str, requests: str) -> bytes:
    """The start of a board that has that block in its flash."""
    return b"".join(map(piece, [*_found(one), *in_flash_pieces(family), *_list(requests), _BACK]))


def begun(start: str, package: str) -> bytes:
    """What a program file begins with: `start` is the file's name, `package` the digits of the whole."""
    return piece(f"$package={package!r};$tail=$file;$file=open({start!r},'rb')")


def piece(text: str) -> bytes:
    """A piece, in which `$NAME` is the name that the package's modules have for it on a board.

    Raises:
        PackageError: it is too long.
    """
    found = with_short_names(text).encode()
    if len(found) > _MOST:
        raise PackageError(
            Sentence("the settings of a device are too long for a board"),
            Sentence("make them shorter in the robot's XML"),
        )
    return b"%04d" % len(found) + found


def _list(requests: str) -> list[str]:
    return [f"$requests={requests!r}", *script_pieces("begin"), *name_pieces()]


def _found(one: FlashBlock) -> Iterator[str]:
    """Looks for the block, and makes a function of each entry in it."""
    first, second = struct.unpack_from("<ii", head(one.sign, 0, whole=True))
    yield f"from machine import mem32 as $memory;$spot={FIRST}"
    yield f"while $spot<{END} and($memory[$spot]!={first} or $memory[$spot+4]!={second}):$spot+={CHUNK}"
    yield f"if $spot=={END}:raise OSError('flash')"
    yield (
        "def $place(a):\n"
        f" b=$memory[$spot+{HEAD}+4*a]\n"
        " def c():0\n"
        " $memory[id(c)+8]=$spot+b%65536\n"
        " $memory[id(c)+12]=$spot+b//65536\n"
        " return c"
    )
    yield from join_statements(
        [with_short_names(f"{each.name}=$place({number})") for number, each in enumerate(one.functions)]
    )
    yield "del $memory,$place,$spot"
