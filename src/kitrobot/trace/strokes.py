"""The line of a pen as its robot goes: which points of the way are corners of what is drawn.

One source for the step of the simulator (CPython and Numba) and for reading a trace, which holds where a robot is and
how its pen is after each step: both find the same corners, to the tenth of a mm. So a trace keeps nothing of a drawing
but what its pens show.

A pen's row is numbers: its style, the point of the step before, the last corner, and the two directions between which
the line may go on without a corner (x and y each), which are not known yet while OPEN is 1. Points are whole tenths of
a mm. No point of the way is further than `TOLERANCE` from the line that is drawn.
"""

from __future__ import annotations

import math

STYLE, AT_X, AT_Y, CORNER_X, CORNER_Y, LEFT_X, LEFT_Y, RIGHT_X, RIGHT_Y, OPEN = range(10)
ROW = 10
"""Numbers a pen has."""

UP = 0
"""The style of a pen that is up; of one that is down see `style_of`."""

COLOURS = 64
"""More than there are colours."""

TOLERANCE = 2.0
"""Tenths of a mm."""

NEAR = 4.0
"""As near to a corner, in tenths of a mm, a point says nothing about where the line goes."""

GOES_ON, BEGINS, ENDS = 1, 2, 4
"""What a step makes of the point before it, as bits: a corner, the first point of a stroke, the last one."""


def style_of(down: int, colour: int, width: int) -> int:
    """The style of a pen with its colour (0…63) and its width in mm, in one number."""
    return 1 + colour + COLOURS * width if down else UP


def tenths(mm: float) -> float:
    """A length in whole tenths of a mm, as `round` has it: halves go to the even one."""
    number = mm * 10.0
    low = math.floor(number)
    over = number - low
    if over > 0.5 or (over == 0.5 and low % 2 == 1):
        low += 1
    return float(low)


def extend_stroke(row: list[float], style: int, x: float, y: float) -> int:
    """Goes on to a point with a pen of that style; gives what becomes of the point before, 0 for nothing."""
    px = row[AT_X]
    py = row[AT_Y]
    made = 0
    if float(style) != row[STYLE]:
        if row[STYLE] != 0.0:
            made = ENDS
        if style != UP:
            made += BEGINS
        row[STYLE] = float(style)
    elif style != UP and is_corner(row, x, y):
        made = GOES_ON
    if made > 0:
        row[CORNER_X] = px
        row[CORNER_Y] = py
        row[OPEN] = 1.0
    if style != UP:
        narrow(row, x - row[CORNER_X], y - row[CORNER_Y])
    row[AT_X] = x
    row[AT_Y] = y
    return made


def is_corner(row: list[float], x: float, y: float) -> bool:
    """Whether the line from the last corner to a point would miss a point of the way, or the way turns back."""
    if row[OPEN] != 0.0:
        return False
    vx = x - row[CORNER_X]
    vy = y - row[CORNER_Y]
    if vx * row[LEFT_Y] - vy * row[LEFT_X] < 0.0 or row[RIGHT_X] * vy - row[RIGHT_Y] * vx < 0.0:
        return True
    px = row[AT_X] - row[CORNER_X]
    py = row[AT_Y] - row[CORNER_Y]
    return (vx - px) * px + (vy - py) * py < 0.0


def narrow(row: list[float], vx: float, vy: float) -> None:
    """Narrows the directions so that a line within them passes the point at (vx, vy) from the corner near enough."""
    away = math.sqrt(vx * vx + vy * vy)
    if away <= NEAR:
        return
    ax = -vy / away * TOLERANCE
    ay = vx / away * TOLERANCE
    first = row[OPEN] != 0.0
    if first or (vx + ax) * row[LEFT_Y] - (vy + ay) * row[LEFT_X] > 0.0:
        row[LEFT_X] = vx + ax
        row[LEFT_Y] = vy + ay
    if first or row[RIGHT_X] * (vy - ay) - row[RIGHT_Y] * (vx - ax) > 0.0:
        row[RIGHT_X] = vx - ax
        row[RIGHT_Y] = vy - ay
    row[OPEN] = 0.0
