"""Whether a program fits a board's memory, before anything is sent.

An estimate: what the loop takes at least while the board compiles it, what the package's modules take then, what the
arrays of the program take, and what is needed to work. It refuses only what is sure not to fit; what it lets through
and does not fit after all is refused by the board itself, which then goes on with what it had.
"""

from __future__ import annotations

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.package import Built
from kitrobot_onboard.image import header

_WORKING = 600
"""Bytes without which no tick and no answer is possible."""

SMALLEST = 16_000
"""Bytes that must be free before the loop is there. The micro:bit of 2016 has 9 500 and cannot compile it
(docs/reference/boards.md); every board with a current MicroPython has several times as many.
"""


def image_bytes(image: bytes) -> int:
    """Bytes of memory that the arrays of an image take on a board."""
    fields = header(image)
    inputs, variables, counters, temporaries, constants, slots, parallels, stops, commands = fields[6:15]
    actuators, most_arguments, instructions = fields[15], fields[16], fields[17]
    numbers = 1 + inputs + variables + counters + temporaries + constants  # cells
    numbers += 2 * slots  # threads
    numbers += 4 + 4 * slots + 5 * parallels + 3 * stops + commands  # pars
    numbers += (3 + most_arguments) * actuators  # out
    return int(4 * instructions + 4 * numbers)


def refuse_what_does_not_fit(image: bytes, built: Built, free: int) -> None:
    """Raises a BoardError when the program is sure to be too large for a board with so much memory free."""
    if free < SMALLEST:
        raise BoardError(
            f"this board has {free} bytes of memory free, and the loop of a robot needs {SMALLEST} to start",
            "take a board with more memory: a micro:bit V2, a Raspberry Pi Pico or an ESP32",
        )
    needed = image_bytes(image)
    room = free - package_bytes(built) - _WORKING
    if needed > room:
        raise BoardError(
            f"the program needs {needed} bytes of memory, and beside KitRobot the board has {max(room, 0)}",
            "make the program smaller, or take a board with more memory",
        )


def package_bytes(built: Built) -> int:
    """Bytes of memory that the modules of a package take at least, once they are compiled."""
    return int(0.5 * sum(map(len, built.files.values())))
