"""Finding what is near without looking at everything: square cells, each with the list of what reaches into it.

A grid is its lower left corner and the side of its cells (`frame`: x, y, size), how many cells it is wide and high
(`shape`), and two lists: cell c holds `items[starts[c]]` … `items[starts[c + 1] - 1]`, in ascending order. Walls and
lines get a grid once, made by `fixed`; robots get one whenever they have moved, made by `fill`. There are never many
more cells than items, so a grid costs no more than what is in it; a few items share one cell.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from kitrobot.sim.tables.columns import FREE, LOW_X, LOW_Y, RADIUS, ROAD, X, Y
from kitrobot.sim.tables.state import Grid, Rays, Robots

FEW = 40
FEW_FIXED = 12
"""So many robots, or walls, stand in one cell: to look at all of them is quicker than to look where they are."""

SLACK_MM = 0.3
"""How much further than its disc a robot reaches: those that touch always share a cell."""


def fixed(stretches: Sequence[Sequence[float]], margin: float) -> Grid:
    """The grid of straight stretches, rows x1, y1, x2, y2, each with all cells that come nearer to it than `margin`."""
    x1, y1, x2, y2 = stretches[:4]
    count = len(x1)
    if not count:
        return Grid([0.0, 0.0, 1.0], [1, 1], [0, 0], [])
    margin += 1e-6
    left, low = min(*x1, *x2) - margin, min(*y1, *y2) - margin
    width, height = max(*x1, *x2) + margin - left, max(*y1, *y2) + margin - low
    size, cells_x, cells_y = max(width, height), 1, 1
    if count > FEW_FIXED:
        size = max(math.sqrt(width * height / count), margin, 1.0)
        cells_x, cells_y = int(width / size) + 1, int(height / size) + 1
        while cells_x * cells_y > 4 * count + 4:
            size *= 1.5
            cells_x, cells_y = int(width / size) + 1, int(height / size) + 1
    lists: list[list[int]] = [[] for _ in range(cells_x * cells_y)]
    half = size * math.sqrt(0.5) + margin
    for k in range(count):
        length = math.hypot(x2[k] - x1[k], y2[k] - y1[k])
        across_x, across_y = ((y1[k] - y2[k]) / length, (x2[k] - x1[k]) / length) if length else (0.0, 0.0)
        first, last = int((min(x1[k], x2[k]) - margin - left) / size), int((max(x1[k], x2[k]) + margin - left) / size)
        for row in range(
            max(0, int((min(y1[k], y2[k]) - margin - low) / size)),
            min(cells_y - 1, int((max(y1[k], y2[k]) + margin - low) / size)) + 1,
        ):
            for column in range(max(0, first), min(cells_x - 1, last) + 1):
                middle_x, middle_y = left + (column + 0.5) * size, low + (row + 0.5) * size
                if abs((middle_x - x1[k]) * across_x + (middle_y - y1[k]) * across_y) <= half:
                    lists[row * cells_x + column].append(k)
    starts = [0]
    for found in lists:
        starts.append(starts[-1] + len(found))
    return Grid([left, low, size], [cells_x, cells_y], starts, [k for found in lists for k in found])


def cell_at(x: float, y: float, grid: Grid) -> int:
    """The cell of a point, or -1 outside the grid."""
    frame = grid.frame
    shape = grid.shape
    column = math.floor((x - frame[0]) / frame[2])
    row = math.floor((y - frame[1]) / frame[2])
    if column < 0 or row < 0 or column >= shape[0] or row >= shape[1]:
        return -1
    return row * shape[0] + column


def fill(robots: Robots, widest: float, grid: Grid) -> None:
    """Puts the discs of the robots with wheels into a grid, each into every cell it reaches into: four at most, since a
    cell is as wide as the widest disc. Who was taken off its road is left out.

    `starts` has room for 2 cells a disc and 8 more, `items` for 4 entries a disc. LOW_X and LOW_Y of a robot become the
    first column and row that its disc reaches into.
    """
    who = robots.solid
    floats = robots.floats
    x = floats[X]
    y = floats[Y]
    radius = floats[RADIUS]
    ints = robots.ints
    low_x = ints[LOW_X]
    low_y = ints[LOW_Y]
    road = ints[ROAD]
    starts = grid.starts
    items = grid.items
    count = len(who)
    columns = 1
    rows = 1
    reach = widest + SLACK_MM
    left = math.inf
    low = math.inf
    right = -math.inf
    high = -math.inf
    for k in range(count):
        i = who[k]
        if road[i] < FREE:
            continue
        if x[i] < left:
            left = x[i]
        if x[i] > right:
            right = x[i]
        if y[i] < low:
            low = y[i]
        if y[i] > high:
            high = y[i]
    if right < left:
        left = right = low = high = 0.0
    left -= reach
    low -= reach
    width = right + reach - left
    height = high + reach - low
    size = max(width, height)
    if count > FEW:
        size = max(math.sqrt(width * height / count), 2.0 * reach)
        columns = int(width / size) + 1
        rows = int(height / size) + 1
        while columns * rows > 2 * count + 4:
            size *= 1.5
            columns = int(width / size) + 1
            rows = int(height / size) + 1
    grid.frame[0] = left
    grid.frame[1] = low
    grid.frame[2] = size
    grid.shape[0] = columns
    grid.shape[1] = rows
    if columns * rows == 1:
        found = 0
        for k in range(count):
            low_x[who[k]] = 0
            low_y[who[k]] = 0
            if road[who[k]] >= FREE:
                items[found] = who[k]
                found += 1
        starts[0] = 0
        starts[1] = found
        return
    for c in range(columns * rows + 1):
        starts[c] = 0
    for k in range(count):
        i = who[k]
        if road[i] < FREE:
            continue
        r = radius[i] + SLACK_MM
        low_x[i] = int((x[i] - r - left) / size)
        low_y[i] = int((y[i] - r - low) / size)
        for row in range(low_y[i], min(rows - 1, int((y[i] + r - low) / size)) + 1):
            for column in range(low_x[i], min(columns - 1, int((x[i] + r - left) / size)) + 1):
                starts[row * columns + column] += 1
    add_up(columns * rows, starts)
    # From the back, so that each list is ascending and each start ends where its cell begins.
    for back in range(count):
        i = who[count - 1 - back]
        if road[i] < FREE:
            continue
        r = radius[i] + SLACK_MM
        for row in range(low_y[i], min(rows - 1, int((y[i] + r - low) / size)) + 1):
            for column in range(low_x[i], min(columns - 1, int((x[i] + r - left) / size)) + 1):
                c = row * columns + column
                starts[c] -= 1
                items[starts[c]] = i


def add_up(cells: int, starts: list[int]) -> None:
    """Of how many items are in each cell, makes where the list of each ends."""
    total = 0
    for c in range(cells):
        total += starts[c]
        starts[c] = total
    starts[cells] = total


def fill_places(robots: Robots, reach: float, grid: Grid) -> None:
    """Puts the middle of each robot into the cell where it is; cells are no smaller than `reach`."""
    x = robots.floats[X]
    y = robots.floats[Y]
    count = len(x)
    left = math.inf
    low = math.inf
    right = -math.inf
    high = -math.inf
    for i in range(count):
        left = min(left, x[i])
        right = max(right, x[i])
        low = min(low, y[i])
        high = max(high, y[i])
    width = right - left
    height = high - low
    size = max(reach, 1.0)
    while (math.floor(width / size) + 1.0) * (math.floor(height / size) + 1.0) > 2 * count + 4:
        size *= 1.5
    columns = int(width / size) + 1
    rows = int(height / size) + 1
    grid.frame[0] = left
    grid.frame[1] = low
    grid.frame[2] = size
    grid.shape[0] = columns
    grid.shape[1] = rows
    starts = grid.starts
    for c in range(columns * rows + 1):
        starts[c] = 0
    for i in range(count):
        starts[int((y[i] - low) / size) * columns + int((x[i] - left) / size)] += 1
    add_up(columns * rows, starts)
    # From the back, so that each list is ascending and each start ends where its cell begins.
    for back in range(count):
        i = count - 1 - back
        c = int((y[i] - low) / size) * columns + int((x[i] - left) / size)
        starts[c] -= 1
        grid.items[starts[c]] = i


def cells_on_ray(x: float, y: float, ux: float, uy: float, reach: float, grid: Grid, rays: Rays) -> int:
    """The cells that a ray goes through, in order, and how far along the ray it leaves each; gives how many."""
    cells = rays.cells
    exits = rays.exits
    columns = grid.shape[0]
    rows = grid.shape[1]
    if columns * rows == 1:
        cells[0] = 0
        exits[0] = reach
        return 1
    size = grid.frame[2]
    ax = x - grid.frame[0]
    ay = y - grid.frame[1]
    near = 0.0
    far = reach
    if abs(ux) < 1e-12:
        if ax < 0.0 or ax >= columns * size:
            return 0
    else:
        one = -ax / ux
        other = (columns * size - ax) / ux
        near = max(near, min(one, other))
        far = min(far, max(one, other))
    if abs(uy) < 1e-12:
        if ay < 0.0 or ay >= rows * size:
            return 0
    else:
        one = -ay / uy
        other = (rows * size - ay) / uy
        near = max(near, min(one, other))
        far = min(far, max(one, other))
    if near > far:
        return 0
    column = min(max(int((ax + near * ux) / size), 0), columns - 1)
    row = min(max(int((ay + near * uy) / size), 0), rows - 1)
    next_x = math.inf
    next_y = math.inf
    step_x = 1
    step_y = 1
    if ux >= 1e-12:
        next_x = ((column + 1) * size - ax) / ux
    elif ux <= -1e-12:
        next_x = (column * size - ax) / ux
        step_x = -1
    if uy >= 1e-12:
        next_y = ((row + 1) * size - ay) / uy
    elif uy <= -1e-12:
        next_y = (row * size - ay) / uy
        step_y = -1
    each_x = size / abs(ux) if next_x < math.inf else math.inf
    each_y = size / abs(uy) if next_y < math.inf else math.inf
    count = 0
    while True:
        cells[count] = row * columns + column
        leaves = min(next_x, next_y)
        exits[count] = leaves
        count += 1
        if leaves >= far:
            break
        if next_x < next_y:
            column += step_x
            next_x += each_x
            if column < 0 or column >= columns:
                break
        else:
            row += step_y
            next_y += each_y
            if row < 0 or row >= rows:
                break
    return count
