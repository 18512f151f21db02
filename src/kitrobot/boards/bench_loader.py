"""Puts the program that tries parts on a board: for as many parts as its memory and its flash take and that start.

Where there is no room for all parts, the board gets a program for half of them, and so on. When its flash has no room
beside what KitRobot put there before, that is removed first. A part whose driver does not start is left out, and the
rest is tried without it. Left to others: the steps (bench_run).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from kitrobot.boards.bench import Bench, PartKey
from kitrobot.deploy.errors import BoardError, FullError, NoMemoryError
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.robot import Category
from kitrobot.robots.names import BoardNames
from kitrobot.robots.program import BoardProgram
from kitrobot.text.sentences import Sentence

WIRES = Sentence("look at its wires and its settings in the board's file")

_DEVICE = re.compile(r"^[as]\d{1,3}( |$)")
_NO_ANSWER = re.compile(r"OSError\((\[Errno )?(5|19|110|116)\b|OSError\('no answer|ENODEV|ETIMEDOUT|\bEIO\b")
"""What MicroPython says of a bus or a range finder where nothing is: EIO, ENODEV, ETIMEDOUT, and drivers of ours."""

Send = Callable[[BoardProgram, bool], object]
"""Puts a program on the board; true: what KitRobot put there before is removed first."""


@dataclass(eq=False)
class PartError(KitRobotError):
    """A part does not do what it is told; `part`: which."""

    part: PartKey | None = None


def load_parts(
    bench: Bench,
    needed: PartKey | None,
    broken: dict[PartKey, KitRobotError],
    send: Send,
) -> tuple[frozenset[PartKey], BoardProgram]:
    """Sends the program for as many parts as the board takes; which these are, and the program.

    Args:
        bench: what can be tried.
        needed: a part that is to be among them; None: any.
        broken: parts that do not start; those that are found are added.
        send: puts a program on the board.

    Raises:
        PartError: the needed part does not start.
        KitRobotError: what `send` raises.
    """
    keys = dict.fromkeys(one.key for one in bench.steps if one.key not in broken)
    parts = bench.together(list(keys), needed)
    fresh = False
    while True:
        program = bench.program(parts)
        try:
            send(program, fresh)
        except (NoMemoryError, FullError) as error:
            if isinstance(error, FullError) and not fresh:
                fresh = True
            elif len(parts) <= 1:
                raise
            else:
                parts = _half(parts, needed)
        except BoardError as error:
            blamed = blamed_part(program.names, error.said)
            if blamed is None or blamed not in parts:
                raise
            reason = reason_of(error.said)
            message = Sentence("`{part}` does not start: {reason}", blamed[1], reason or error.message)
            found = PartError(message, WIRES if reason else error.help, part=blamed)
            broken[blamed] = found
            parts.remove(blamed)
            if blamed == needed:
                raise found from error
        else:
            return frozenset(parts), program


def _half(parts: list[PartKey], needed: PartKey | None) -> list[PartKey]:
    """Half of the parts, the needed one among them."""
    middle = len(parts) // 2
    return parts[:middle] if needed is None or needed in parts[:middle] else parts[middle:]


def blamed_part(names: BoardNames, said: str) -> PartKey | None:
    """The part that a board names as to blame."""
    device = said.partition(" ")[0]
    kind, number = device[:1], device[1:]
    if not number.isdecimal() or len(number) > 3:
        return None
    if kind == "a" and int(number) < len(names.actuators):
        return Category.ACTUATOR, names.actuators[int(number)]
    sensors = {cell: name for name, cell in names.sensors.items()}
    return (Category.SENSOR, sensors[int(number)]) if kind == "s" and int(number) in sensors else None


def reason_of(said: str, meaning: str = "") -> str:
    """What a board says of a part that failed, behind the part; in plain words when nothing answers at its pins."""
    text = _DEVICE.sub("", said).strip()
    if _NO_ANSWER.search(text):
        return Sentence("it does not answer, and may be not plugged in")
    if not meaning:
        return text
    return Sentence("{meaning} ({text})", meaning, text) if text else meaning
