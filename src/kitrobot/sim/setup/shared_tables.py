"""Which agents share which variables; what they write spreads in `shared_variables`."""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.setup import rules
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables.state import SharedVariables
from kitrobot.sim.team.shared_variables import (
    APART_ROWS,
    COPIES_FIRST,
    COPIES_LAST,
    SHARED_ROWS,
    SHARED_VALUE,
    SHARED_WRITER,
    WRITING,
)
from kitrobot.text.sentences import Sentence


class SharedTables:
    """The tables of shared variables. `variables[v]` is variable v; `problems` says which have two meanings."""

    def __init__(self, agents: Sequence[Agent]) -> None:
        self.variables: list[RobotObject] = []
        self.problems: list[Diagnostic] = []
        mine_first: list[int] = [0]
        mine: list[int] = []
        mine_cell: list[int] = []
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
                    message = Sentence(
                        "{variable} is shared, and {one} and {other} define it differently", variable.name, other, name
                    )
                    self.problems.append(
                        rules.SHARED(message, help=Sentence("give it the same type, range and first value"))
                    )
                cell = agent.machine.layout.variables[variable.name]
                mine.append(number)
                mine_cell.append(cell)
                copies[number].append((agent.index, cell))
            mine_first.append(len(mine))
        rows = [[0] * len(self.variables) for _ in range(SHARED_ROWS)]
        at = 0
        for number, found in enumerate(copies):
            rows[SHARED_VALUE][number] = self.variables[number].initial
            rows[SHARED_WRITER][number] = rows[WRITING][number] = -1
            rows[COPIES_FIRST][number] = at
            at += len(found)
            rows[COPIES_LAST][number] = at
        self.tables = SharedVariables(
            ints=rows,
            apart=[[0] * len(mine) for _ in range(APART_ROWS)],
            mine_first=mine_first,
            mine=mine,
            mine_cell=mine_cell,
            copy_robot=[robot for found in copies for robot, _ in found],
            copy_cell=[cell for found in copies for _, cell in found],
        )


def _meaning(variable: RobotObject) -> tuple[object, ...]:
    return variable.type, variable.minimum, variable.maximum, variable.initial
