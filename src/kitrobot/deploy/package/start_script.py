"""The start of a robot on a board: the pieces that are the same for every program, in a file of their own.

A program file (`kitrobot.deploy.package.script`) begins with them. They load the interpreter and the loop, and make the
list that holds a robot's state. A board compiles the interpreter first, while most memory is free, then the loop, from
large to small.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.package.onboard_bundle import (
    name_pieces,
    script_pieces,
    with_short_names,
)
from kitrobot.text.sentences import Sentence

_MOST = 9999
"""Bytes that a piece may have."""

RETURN_PIECE = "$file.close();$file=$tail;$tail=0"
"""The last piece of a start: the program file goes on."""


def start_file(interpreter: str, loop: Sequence[tuple[str, int]], requests: str) -> bytes:
    """The start of a board that compiles everything. `loop`: names and sizes of files, the port first."""
    port, *others = (f"exec(open({name!r}).read({size}))" for name, size in loop)
    return b"".join(
        map(piece, [f"from {interpreter} import $tick", port, *list_pieces(requests), *others, RETURN_PIECE])
    )


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


def list_pieces(requests: str) -> list[str]:
    """The pieces that make the list of the robot's state; `requests`: the file with the answers to requests."""
    return [f"$requests={requests!r}", *script_pieces("begin"), *name_pieces()]
