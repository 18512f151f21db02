"""Small images written by hand, as listings."""

from __future__ import annotations

from functools import cache

from kitrobot.compiler.compilation import compile_text
from kitrobot.image.listing import assemble
from kitrobot.image.model import Image
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot

TWO_BRANCHES = """\
//( °Wheel.Advance(5)°; WAIT(3);, 2*(Count.Add(1); WAIT(1);); );
//( Light.LightOn(); );
"""
"""A program with everything an image can hold: slots, parallels, a stop, counters, constants."""


@cache
def mini_robot() -> Robot:
    """The robot the programs here are for."""
    return load_catalogue().robots["mini-robot"]


def compiled(text: str) -> Image:
    """The image of a program for `mini_robot`."""
    result = compile_text(text, mini_robot())
    assert result.image is not None, result.diagnostics
    return result.image


def image(code: str, *tables: str) -> Image:
    """An image of one slot with these instructions (parted by `/`), one command, and cells 0…3: fault, a variable, and
    the constants 0 and 7. `tables` are further lines; where there are slots among them they replace the one slot.
    """
    slots = [] if any(line.startswith(".slot") for line in tables) else [".slot - 0 0 1"]
    lines = [
        ".robot 0123456789abcdef",
        ".tick 20",
        ".wait-unit 100",
        ".inputs 0",
        ".variables 1",
        ".counters 0",
        ".temporaries 0",
        ".constants 2",
        ".actuators 1",
        ".arguments 1",
        *(f".cell {value}" for value in (0, 0, 0, 7)),
        *slots,
        *tables,
        ".command 0",
        ".code",
        *code.split("/"),
    ]
    return assemble("\n".join(lines))
