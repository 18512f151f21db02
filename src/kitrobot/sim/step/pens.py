"""What pens draw in a step: a loop over rows of numbers, in the Python that Numba compiles too.

Corners of lines are told among the events of the step (kind DRAWN); `drawn_marks` makes marks of them. The rows of pens
are explained in `trace.strokes`.
"""

from __future__ import annotations

from collections.abc import Iterable

from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables.columns import A_ROBOT, DRAWN, EVENT, EVENTS, X, Y, record_event
from kitrobot.sim.tables.state import Pens, State, numbers
from kitrobot.trace.drawing import Mark, Pen, marks_of, packed, unpacked
from kitrobot.trace.strokes import AT_X, AT_Y, COLOURS, ROW, STYLE, extend_stroke, style_of, tenths

_BITS = 8
"""What a step makes of a point is less than this."""

_STYLES = COLOURS * 1000


def pen_tables(pens: list[int], robots: list[int], xs: list[float], ys: list[float]) -> Pens:
    """The pens, which are the actuators `pens` of those robots, where these stand before the first step."""
    rows = [[0.0] * ROW for _ in pens]
    for row, robot in zip(rows, robots, strict=True):
        row[AT_X], row[AT_Y] = tenths(xs[robot]), tenths(ys[robot])
    return Pens(pens, rows)


def draw(state: State) -> None:
    """Every pen goes on to where its robot is now."""
    pens = state.pens.actuators
    rows = state.pens.rows
    robots = state.actuators.ints[A_ROBOT]
    outputs = state.actuators.outputs
    x = state.robots.floats[X]
    y = state.robots.floats[Y]
    for n in range(len(pens)):
        k = pens[n]
        row = rows[n]
        output = outputs[k]
        style = style_of(output[0], output[1], output[2])
        if style == 0 and row[STYLE] == 0.0:
            row[AT_X] = tenths(x[robots[k]])
            row[AT_Y] = tenths(y[robots[k]])
            continue
        before = int(row[STYLE])
        place = packed(row[AT_X], row[AT_Y])
        made = extend_stroke(row, style, tenths(x[robots[k]]), tenths(y[robots[k]]))
        if made > 0:
            record_event(state.events, state.clock, DRAWN, n, made + _BITS * (style + _STYLES * before), place)


def drawn_marks(state: State) -> list[Mark]:
    """What was drawn in the steps whose events are in the tables."""
    count = int(state.clock[EVENTS])
    if count == 0 or len(state.pens.actuators) == 0:
        return []
    rows = numbers(state.events[: EVENT * count])
    found: list[Mark] = []
    for at in range(0, len(rows), EVENT):
        kind, pen, what, place, step = rows[at : at + EVENT]
        if kind == DRAWN:
            made, styles = what % _BITS, what // _BITS
            found += marks_of(step + 1, pen, made, styles % _STYLES, styles // _STYLES, *unpacked(place))
    return found


def pens_of(members: Iterable[Agent]) -> list[Pen]:
    """Everybody's pens, in the order of the numbers of `Mark.pen`."""
    return [Pen(agent.index, name) for agent in members for name in agent.pens]
