"""The whole state of a run in tables of numbers: what the step works on, and all of it.

`State` names the tables, in groups. Under CPython they are lists (of lists, for tables of rows); `arrays` makes NumPy
arrays of them, for Numba. Nothing outside it decides how a run goes on: `state_codec` writes what changes in a run as
bytes, the same bytes for both forms, and puts it back.

What the columns of tables mean is in `columns`, those of docks in `docks`, of shared variables in
`shared_variables`, of the schedule of failures in `fault_injection`; grids are explained in `grids`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Floats = list[float]
Ints = list[int]
FloatRows = list[list[float]]
IntRows = list[list[int]]


@dataclass(frozen=True, slots=True)
class Grid:
    """What is near a place (see grids): the lower left corner and the side of the cells, how many cells it is wide and
    high, where the list of each cell begins, and the lists.
    """

    frame: Floats
    shape: Ints
    starts: Ints
    items: Ints


@dataclass(frozen=True, slots=True)
class Robots:
    """`solid` have wheels, `guided` are on roads (sorted along them), `free` are not, `carriers` have beds."""

    floats: FloatRows
    ints: IntRows
    solid: Ints
    guided: Ints
    free: Ints
    free_solid: Ints
    carriers: Ints


@dataclass(frozen=True, slots=True)
class Machines:
    """By program, then by robot; the arrays of `tick`, room for those of one machine, and a state that is kept."""

    code: IntRows
    commands: IntRows
    parts: Ints
    cells: IntRows
    threads: IntRows
    pars: IntRows
    out: IntRows
    seen: IntRows
    was_cells: Ints
    was_threads: Ints
    was_pars: Ints
    kept_cells: IntRows
    kept_threads: IntRows
    kept_pars: IntRows


@dataclass(frozen=True, slots=True)
class Sensors:
    """Those of kind k are numbers bank[k] to bank[k + 1] - 1; `past` are the readings of late ones, `numbers` what
    settings and world give to those with a table.
    """

    ints: IntRows
    floats: FloatRows
    bank: Ints
    past: Ints
    numbers: Floats


@dataclass(frozen=True, slots=True)
class Actuators:
    """Those of kind k are numbers bank[k] to bank[k + 1] - 1; `queue` are the commands on their way to `late` ones."""

    ints: IntRows
    floats: FloatRows
    bank: Ints
    actuator_index: Ints
    waited_for: Ints
    late: Ints
    takens: IntRows
    outputs: IntRows
    queue: Ints


@dataclass(frozen=True, slots=True)
class SharedVariables:
    """Shared variables (see `shared_variables`)."""

    ints: IntRows
    apart: IntRows
    mine_first: Ints
    mine: Ints
    mine_cell: Ints
    copy_robot: Ints
    copy_cell: Ints


@dataclass(frozen=True, slots=True)
class Team:
    """The points of the team's program and its robots (see meetings, substitution, team_columns); empty without one."""

    numbers: Ints
    points: IntRows
    robots: IntRows
    set_first: Ints
    names: IntRows
    members: IntRows
    groups: IntRows
    vacated: IntRows
    within: IntRows
    failure: Ints
    emptied: Ints
    since: IntRows
    works: IntRows
    holds: IntRows
    until: IntRows
    waits: IntRows
    halts: Ints
    first_cells: IntRows
    first_threads: IntRows
    first_pars: IntRows
    kept: IntRows
    kept_passes: Ints


@dataclass(frozen=True, slots=True)
class Radio:
    """Who hears whom, and messages on their way (see radio); empty without one."""

    numbers: Ints
    floats: Floats
    robots: IntRows
    keys: IntRows
    due: Ints
    air: IntRows
    grid: Grid


@dataclass(frozen=True, slots=True)
class Faults:
    """The schedule of failures, and of each robot the keys of its chance to fail."""

    plan: IntRows
    fate: IntRows


@dataclass(frozen=True, slots=True)
class Roads:
    """Their sampled points and their sections, those of all roads one after another."""

    ints: IntRows
    length: Floats
    points: FloatRows
    cut_from: Floats
    cut_sign: Ints


@dataclass(frozen=True, slots=True)
class Docks:
    """Docks, the storehouses behind them, and the goals: how many boxes are to be in which storehouse."""

    floats: FloatRows
    road: Ints
    stock: Ints
    capacity: Ints
    goals: IntRows


@dataclass(frozen=True, slots=True)
class Walls:
    """Rows x1, y1, x2, y2."""

    floats: FloatRows
    grid: Grid


@dataclass(frozen=True, slots=True)
class Lines:
    """Coloured stretches on the floor, rows x1, y1, x2, y2, half width."""

    floats: FloatRows
    colours: Ints
    grid: Grid


@dataclass(frozen=True, slots=True)
class Floors:
    """Coloured floors: rows colour, first and last point; the rectangle around each; the points of all."""

    ints: IntRows
    box: FloatRows
    points: FloatRows


@dataclass(frozen=True, slots=True)
class Rays:
    """Room for the cells that a ray goes through, and how far along it leaves each."""

    cells: Ints
    exits: Floats


@dataclass(frozen=True, slots=True)
class Contacts:
    """Room for the pairs that touch, those of the step before, and a table to look them up in."""

    pairs: Ints
    before: Ints
    buckets: Ints
    chain: Ints


@dataclass(frozen=True, slots=True)
class Pens:
    """Which actuators are pens, and a row of numbers for each (see trace.strokes)."""

    actuators: Ints
    rows: FloatRows


@dataclass(frozen=True, slots=True)
class Pushables:
    """Boxes and balls that are pushed (see `pushable`), their grid, and half the size of the largest one."""

    floats: FloatRows
    ints: IntRows
    grid: Grid
    numbers: Floats


@dataclass(frozen=True, slots=True)
class Probes:
    """Numbers that are read after each step, for who asks for them before the first (see `step.probes`), and room for
    so many steps of them; `count` says of how many there are some. Empty unless somebody asks.
    """

    count: Ints
    int_places: IntRows
    float_places: IntRows
    ints: IntRows
    floats: FloatRows


@dataclass(frozen=True, slots=True)
class State:
    """The tables, in groups. Lists of whole numbers named after a thing hold its numbers: robots, actuators, docks."""

    fixed: Ints
    fixed_floats: Floats
    clock: Ints
    events: Ints
    robots: Robots
    machines: Machines
    sensors: Sensors
    actuators: Actuators
    shared: SharedVariables
    team: Team
    radio: Radio
    faults: Faults
    roads: Roads
    docks: Docks
    walls: Walls
    lines: Lines
    floors: Floors
    grid: Grid
    """The grid of the robots that can be touched."""
    rays: Rays
    contacts: Contacts
    pens: Pens
    pushables: Pushables
    pushable_walls: Walls
    probes: Probes
    held: FloatRows
    """Of a step that may change nothing (deadlock_detection): poses and speeds of robots, numbers of devices."""


CHANGING = ("cells", "threads", "pars")
"""The tables of machines that change in a tick: of each there is what was before, and what is kept."""


def numbers(row: Any) -> list[Any]:
    """A row as a list of Python's own numbers, whatever it is."""
    return row if isinstance(row, list) else row.tolist()
