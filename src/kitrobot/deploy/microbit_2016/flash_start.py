"""The start of a robot on a board that executes the loop from its flash: the loop is only located there."""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence

from kitrobot.deploy.microbit_2016.flash import END, FIRST
from kitrobot.deploy.microbit_2016.flash_code import CHUNK, HEAD, FlashBlock, head
from kitrobot.deploy.package.onboard_bundle import join_statements, with_short_names
from kitrobot.deploy.package.start_script import RETURN_PIECE, list_pieces, piece


def start_from_flash(one: FlashBlock, statements: Sequence[str], requests: str) -> bytes:
    """The start of a board that has that block in its flash.

    Args:
        one: the block.
        statements: what the modules in it have beside functions.
        requests: the name of the file with the answers to requests.
    """
    return b"".join(map(piece, [*_located(one), *statements, *list_pieces(requests), RETURN_PIECE]))


def _located(one: FlashBlock) -> Iterator[str]:
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
