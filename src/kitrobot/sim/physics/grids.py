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

ACROSS = 1e-12
"""A ray whose direction has less of x or y goes across it."""

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
    grid = Grid([left, low, max(width, height)], [1, 1], [0], [])
    if count > FEW_FIXED:
        lay_out(grid, left, low, width, height, max(math.sqrt(width * height / count), margin, 1.0), 4 * count + 4)
    size = grid.frame[2]
    cells_x, cells_y = grid.shape
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
    for found in lists:
        grid.starts.append(grid.starts[-1] + len(found))
        grid.items.extend(found)
    return grid


def lay_out(grid: Grid, left: float, low: float, width: float, height: float, size: float, most: int) -> None:
    """Gives a grid its lower left corner, and cells of this size; larger ones if they would be more than `most`."""
    while (math.floor(width / size) + 1.0) * (math.floor(height / size) + 1.0) > most:
        size *= 1.5
    grid.frame[0] = left
    grid.frame[1] = low
    grid.frame[2] = size
    grid.shape[0] = int(width / size) + 1
    grid.shape[1] = int(height / size) + 1


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
    left, low, right, high = bounds(robots)
    reach = widest + SLACK_MM
    left -= reach
    low -= reach
    width = right + reach - left
    height = high + reach - low
    count = len(robots.solid)
    if count > FEW:
        lay_out(grid, left, low, width, height, max(math.sqrt(width * height / count), 2.0 * reach), 2 * count + 4)
    else:
        grid.frame[0] = left
        grid.frame[1] = low
        grid.frame[2] = max(width, height)
        grid.shape[0] = 1
        grid.shape[1] = 1
    cells = grid.shape[0] * grid.shape[1]
    if cells == 1:
        fill_one_cell(robots, grid)
        return
    for c in range(cells + 1):
        grid.starts[c] = 0
    count_discs(robots, grid)
    add_up(cells, grid.starts)
    enter_discs(robots, grid)


def bounds(robots: Robots) -> tuple[float, float, float, float]:
    """The least and the greatest x and y of the middles of discs: left, low, right, high; all 0 where there is none."""
    x = robots.floats[X]
    y = robots.floats[Y]
    road = robots.ints[ROAD]
    left = math.inf
    low = math.inf
    right = -math.inf
    high = -math.inf
    for k in range(len(robots.solid)):
        i = robots.solid[k]
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
        return 0.0, 0.0, 0.0, 0.0
    return left, low, right, high


def fill_one_cell(robots: Robots, grid: Grid) -> None:
    """Puts all discs into the only cell."""
    ints = robots.ints
    found = 0
    for k in range(len(robots.solid)):
        i = robots.solid[k]
        ints[LOW_X][i] = 0
        ints[LOW_Y][i] = 0
        if ints[ROAD][i] >= FREE:
            grid.items[found] = i
            found += 1
    grid.starts[0] = 0
    grid.starts[1] = found


def count_discs(robots: Robots, grid: Grid) -> None:
    """Counts in `starts` the discs that reach into each cell; LOW_X and LOW_Y are the first ones of each disc."""
    x = robots.floats[X]
    y = robots.floats[Y]
    radius = robots.floats[RADIUS]
    low_x = robots.ints[LOW_X]
    low_y = robots.ints[LOW_Y]
    left = grid.frame[0]
    low = grid.frame[1]
    size = grid.frame[2]
    columns = grid.shape[0]
    rows = grid.shape[1]
    for k in range(len(robots.solid)):
        i = robots.solid[k]
        if robots.ints[ROAD][i] < FREE:
            continue
        r = radius[i] + SLACK_MM
        low_x[i] = int((x[i] - r - left) / size)
        low_y[i] = int((y[i] - r - low) / size)
        for row in range(low_y[i], min(rows - 1, int((y[i] + r - low) / size)) + 1):
            for column in range(low_x[i], min(columns - 1, int((x[i] + r - left) / size)) + 1):
                grid.starts[row * columns + column] += 1


def enter_discs(robots: Robots, grid: Grid) -> None:
    """Puts the discs into the lists of their cells, of which `starts` has the ends.

    It goes from the back, so that each list is ascending and each start ends where its cell begins.
    """
    x = robots.floats[X]
    y = robots.floats[Y]
    radius = robots.floats[RADIUS]
    low_x = robots.ints[LOW_X]
    low_y = robots.ints[LOW_Y]
    starts = grid.starts
    left = grid.frame[0]
    low = grid.frame[1]
    size = grid.frame[2]
    columns = grid.shape[0]
    rows = grid.shape[1]
    count = len(robots.solid)
    for back in range(count):
        i = robots.solid[count - 1 - back]
        if robots.ints[ROAD][i] < FREE:
            continue
        r = radius[i] + SLACK_MM
        for row in range(low_y[i], min(rows - 1, int((y[i] + r - low) / size)) + 1):
            for column in range(low_x[i], min(columns - 1, int((x[i] + r - left) / size)) + 1):
                c = row * columns + column
                starts[c] -= 1
                grid.items[starts[c]] = i


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
    lay_out(grid, left, low, right - left, high - low, max(reach, 1.0), 2 * count + 4)
    size = grid.frame[2]
    columns = grid.shape[0]
    rows = grid.shape[1]
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
    near, far = clip_ray(ax, ux, columns * size, 0.0, reach)
    near, far = clip_ray(ay, uy, rows * size, near, far)
    if near > far:
        return 0
    column = min(max(int((ax + near * ux) / size), 0), columns - 1)
    row = min(max(int((ay + near * uy) / size), 0), rows - 1)
    next_x = way_to_next_cell(column, ax, ux, size)
    next_y = way_to_next_cell(row, ay, uy, size)
    step_x = -1 if ux < 0.0 else 1
    step_y = -1 if uy < 0.0 else 1
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


def clip_ray(a: float, u: float, width: float, near: float, far: float) -> tuple[float, float]:
    """The part of a ray from `near` to `far` that lies between 0 and a width in one of x and y; `far` is less if none.

    `a` and `u` are its beginning and its direction in that.
    """
    if abs(u) < ACROSS:
        return (near, far) if 0.0 <= a < width else (1.0, 0.0)
    one = -a / u
    other = (width - a) / u
    return max(near, min(one, other)), min(far, max(one, other))


def way_to_next_cell(cell: int, a: float, u: float, size: float) -> float:
    """How far along a ray it leaves the column or row that it begins in."""
    if abs(u) < ACROSS:
        return math.inf
    return ((cell + 1) * size - a) / u if u > 0.0 else (cell * size - a) / u
