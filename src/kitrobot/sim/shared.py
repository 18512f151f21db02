"""Which agents share which variables; what they write spreads in `sharing`."""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.diagnostics import Diagnostic
from kitrobot.primitives import RobotObject
from kitrobot.sim import rules
from kitrobot.sim.agents import Agent
from kitrobot.sim.sharing import (
    APART_ROWS,
    COPIES_FIRST,
    COPIES_LAST,
    SHARED_ROWS,
    SHARED_VALUE,
    SHARED_WRITER,
    WRITING,
)


class SharedTables:
    """The tables of shared variables. `variables[v]` is variable v; `problems` says which have two meanings."""

    def __init__(self, agents: Sequence[Agent]) -> None:
        self.variables: list[RobotObject] = []
        self.problems: list[Diagnostic] = []
        self.mine_first: list[int] = [0]
        self.mine: list[int] = []
        self.mine_cell: list[int] = []
        copies: list[list[tuple[int, int]]] = []
        numbers: dict[str, int] = {}
        first: dict[str, str] = {}
        told: set[tuple[str, str]] = set()
        for agent in agents:
            for variable in agent.robot.variables:
                if not variable.shared:
                    continue
                if variable.name not in numbers:
                    numbers[variable.name] = len(self.variables)
                    first[variable.name] = agent.robot.name
                    self.variables.append(variable)
                    copies.append([])
                number = numbers[variable.name]
                other, name = first[variable.name], agent.robot.name
                if _meaning(self.variables[number]) != _meaning(variable) and (name, variable.name) not in told:
                    told.add((name, variable.name))
                    message = f"{variable.name} is shared, and {other} and {name} define it differently"
                    self.problems.append(rules.SHARED(message, help="give it the same type, range and first value"))
                cell = agent.machine.layout.variables[variable.name]
                self.mine.append(number)
                self.mine_cell.append(cell)
                copies[number].append((agent.index, cell))
            self.mine_first.append(len(self.mine))
        self.copy_robot = [robot for found in copies for robot, _ in found]
        self.copy_cell = [cell for found in copies for _, cell in found]
        self.rows: list[list[int]] = [[0] * len(self.variables) for _ in range(SHARED_ROWS)]
        self.apart: list[list[int]] = [[0] * len(self.mine) for _ in range(APART_ROWS)]
        at = 0
        for number, found in enumerate(copies):
            self.rows[SHARED_VALUE][number] = self.variables[number].initial
            self.rows[SHARED_WRITER][number] = self.rows[WRITING][number] = -1
            self.rows[COPIES_FIRST][number] = at
            at += len(found)
            self.rows[COPIES_LAST][number] = at


def _meaning(variable: RobotObject) -> tuple[object, ...]:
    return variable.type, variable.minimum, variable.maximum, variable.initial
