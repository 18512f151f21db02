"""The one `tick`, plain and under Numba, on `i+=1; x+=3; act(x); until i=1000`, against scratch-vm and py_trees.

A trip is one pass of that loop. In LLL a pass that does not block costs a tick, so a trip is a whole tick here, and one
in py_trees too; scratch-vm goes round without giving up its frame (turbo mode, a custom block that runs without screen
refresh). `act` hands a number to a device and keeps it. Counted: trips, and the start of each lap of 1000. Not counted:
reading, compiling, Numba's compilation, one round to warm up. Plain runs the lists of `Machine`, without its looking up
of names; Numba runs arrays of 32 bits, many robots in a call.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.measurement import Rate, Row, in_turns
from benchmarks.peers import behaviour_tree, node
from kitrobot.compiler.compilation import compile_text
from kitrobot.image.machine import Machine
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot_onboard.interpreter import tick

TITLE = "interpreting"
UNTIL = 1000
LOOP = f"*[!(Count.EqualTo({UNTIL}))]( Count.Add(1); Total.Add(3); Arm.Act(Total.Value()); );"
ROBOT = f"""<robot name="counter" version="1">
  <actuator name="Arm" device="switch">
    <procedure name="Act"><parameter name="x" min="0" max="{3 * UNTIL}"/></procedure>
  </actuator>
  <variable name="Count" type="integer" min="0" max="{UNTIL}" initial="0"/>
  <variable name="Total" type="integer" min="0" max="{3 * UNTIL}" initial="0"/>
</robot>
"""


@dataclass(frozen=True)
class Size:
    """`laps` of 1000 trips a round: plain and py_trees, scratch-vm; by Numba `robots` (or 0) of `robot_laps` each."""

    laps: int
    scratch_laps: int
    tree_laps: int
    robots: int
    robot_laps: int
    rounds: int


FULL = Size(laps=300, scratch_laps=1000, tree_laps=20, robots=100, robot_laps=200, rounds=7)
TINY = Size(laps=1, scratch_laps=1, tree_laps=1, robots=2, robot_laps=1, rounds=1)


def machine() -> Machine:
    """The loop, compiled, ready for its first tick."""
    robot, problems = read_robot(ROBOT.encode(), "counter.robot.xml")
    assert isinstance(robot, Robot), problems
    compiled = compile_text(LOOP, robot)
    assert compiled.image is not None, compiled.diagnostics
    return Machine(compiled.image, robot)


def instructions_a_trip(of: Machine) -> int:
    """Counted by running one in the middle."""
    seen = [0] * (len(of.code) // 4)
    for _ in range(3):
        seen[:] = [0] * len(seen)
        tick(of.code, of.cells, of.threads, of.pars, of.out, seen)
    return sum(seen)


def plain(of: Machine, laps: int) -> None:
    """Laps of ticks on CPython."""
    begin = of.snapshot()
    code, cells, threads, pars, out = of.code, of.cells, of.threads, of.pars, of.out
    nobody: list[int] = []
    for _ in range(laps):
        of.restore(begin)
        for _ in range(UNTIL):
            tick(code, cells, threads, pars, out, nobody)
    assert of.variables() == {"Count": UNTIL, "Total": 3 * UNTIL}
    of.restore(begin)


def compiled(of: Machine, robots: int, laps: int) -> Callable[[], object]:
    """The same under Numba, for many robots; the work, with everything set up."""
    from benchmarks.fleet import drive

    def array(values: list[int]) -> Any:
        return np.array(values, np.int32)

    def rows(values: list[int]) -> Any:
        return np.tile(array(values), (robots, 1))

    code, first_cells, first_threads = np.array(of.code, np.uint8), array(of.cells), array(of.threads)
    cells, threads, pars, out = rows(of.cells), rows(of.threads), rows(of.pars), rows(of.out)
    nobody = array([])

    def work() -> None:
        # The tick after the last trip finds the loop done and ends the program.
        ended = drive(code, cells, threads, pars, out, nobody, (first_cells, first_threads), laps * (UNTIL + 1))
        assert ended == robots * laps

    return work


def run(size: Size, *, peers: bool) -> list[Row]:
    ours = machine()
    a_trip = instructions_a_trip(machine())
    trips = {"plain": size.laps, "Numba": size.robots * size.robot_laps, "tree": size.tree_laps}
    work: dict[str, Callable[[], object]] = {"plain": lambda: plain(ours, size.laps)}
    if size.robots and importlib.util.find_spec("numba") is not None:
        work["Numba"] = compiled(ours, size.robots, size.robot_laps)
    if peers:
        work["tree"] = lambda: behaviour_tree.run(size.tree_laps, UNTIL)
    seconds = in_turns(work, size.rounds)
    rates = {name: Rate.of(trips[name] * UNTIL, taken) for name, taken in seconds.items()}
    given = {"rounds": size.rounds, "laps": size.scratch_laps, "until": UNTIL}
    result = node.run_peer("scratch.cjs", given) if peers else None
    scratch = Rate.of(size.scratch_laps * UNTIL, result["seconds"]) if result else None
    scratch_name = f"scratch-vm {node.version('scratch-vm')}" if result else ""

    rows = []
    for name in ("plain", "Numba"):
        if name not in rates:
            continue
        rows.append(Row(f"tick, {name}", "trips/s", rates[name], scratch_name, scratch))
        if "tree" in rates:
            rows.append(Row(f"tick, {name}", "trips/s", rates[name], behaviour_tree.NAME, rates["tree"]))
        instructions = Rate.of(a_trip * trips[name] * UNTIL, seconds[name])
        rows.append(Row(f"tick, {name}: {a_trip} instructions a trip", "instructions/s", instructions))
    return rows
