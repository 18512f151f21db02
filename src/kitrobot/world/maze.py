"""A maze from a seed: the same seed and size give the same walls, on every machine and with every Python.

Cells lie in columns and rows; between any two of them there is exactly one way. It is dug from the start at the lower
left, always on to a neighbour where nobody was, and back where there is none. The green field is in the cell that is
farthest from the start.
"""

from __future__ import annotations

from collections.abc import Iterator

from kitrobot.world.geometry import Pose
from kitrobot.world.model import Floor, Start, Wall, World, rectangle_corners

CELL_MM = 400.0
"""How wide a corridor is: a small robot turns in it."""

MOST_CELLS = 40
"""Columns or rows."""

MOST_SEED = 2**32 - 1

_FIELD_PART = 0.6
"""How much of its cell the green field takes, in each direction."""

_Cell = tuple[int, int]
_BESIDE = ((1, 0), (0, 1), (-1, 0), (0, -1))


class _RandomSource:
    """Numbers from a seed: a linear congruence of 64 bits, of which the upper half counts."""

    def __init__(self, seed: int) -> None:
        self.state = (seed * 0x9E3779B97F4A7C15 + 0xD1B54A32D192ED03) % 2**64

    def below(self, count: int) -> int:
        """A number from 0 to `count` - 1."""
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 32) * count >> 32


def make_maze(seed: int, columns: int = 8, rows: int = 5, name: str = "maze") -> World:
    """The maze.

    Args:
        seed: 0 to `MOST_SEED`; others are taken modulo 2 to the power of 32.
        columns: how many cells it is wide, 2 to `MOST_CELLS`; others become the nearest of these.
        rows: how many cells it is high, likewise.
        name: what the world is called.
    """
    columns, rows = (min(max(count, 2), MOST_CELLS) for count in (columns, rows))
    doors, far = _dig_passages(_RandomSource(seed % 2**32), columns, rows)
    side = CELL_MM * _FIELD_PART
    margin = (CELL_MM - side) / 2
    field = rectangle_corners(far[0] * CELL_MM + margin, far[1] * CELL_MM + margin, side, side)
    # The first way out of the start is to the right or up.
    heading = 0.0 if ((0, 0), (1, 0)) in doors else _QUARTER
    return World(
        name,
        columns * CELL_MM,
        rows * CELL_MM,
        walls=tuple(_walls(doors, columns, rows)),
        floors=(Floor("green", field),),
        starts=(Start("robot-1", pose=Pose(CELL_MM / 2, CELL_MM / 2, heading)),),
    )


_QUARTER = 1.5707963267948966


def _dig_passages(chance: _RandomSource, columns: int, rows: int) -> tuple[set[tuple[_Cell, _Cell]], _Cell]:
    """The open borders between cells, the lower or left one first, and the cell that is farthest from the start."""
    doors: set[tuple[_Cell, _Cell]] = set()
    way = [(0, 0)]
    seen = {(0, 0)}
    far, longest = (0, 0), 0
    while way:
        x, y = way[-1]
        free = [
            (x + dx, y + dy)
            for dx, dy in _BESIDE
            if 0 <= x + dx < columns and 0 <= y + dy < rows and (x + dx, y + dy) not in seen
        ]
        if not free:
            way.pop()
            continue
        there = free[chance.below(len(free))]
        doors.add((min((x, y), there), max((x, y), there)))
        seen.add(there)
        way.append(there)
        if len(way) > longest:
            far, longest = there, len(way)
    return doors, far


def _walls(doors: set[tuple[_Cell, _Cell]], columns: int, rows: int) -> Iterator[Wall]:
    """The walls, each as long as it goes on straight: first those that stand upright, from the left."""
    for x in range(columns + 1):
        shut = [((x - 1, y), (x, y)) not in doors for y in range(rows)]
        for first, last in _stretches(shut):
            yield Wall(x * CELL_MM, first * CELL_MM, x * CELL_MM, last * CELL_MM)
    for y in range(rows + 1):
        shut = [((x, y - 1), (x, y)) not in doors for x in range(columns)]
        for first, last in _stretches(shut):
            yield Wall(first * CELL_MM, y * CELL_MM, last * CELL_MM, y * CELL_MM)


def _stretches(shut: list[bool]) -> Iterator[tuple[int, int]]:
    """Where stretches of shut borders begin and end."""
    first = 0
    for at, one in enumerate([*shut, False]):
        if not one:
            if at > first:
                yield first, at
            first = at + 1
