"""Shared variables: every agent has a copy, a write carries a logical clock, the latest write wins.

What an agent writes in a tick reaches all others before their next tick. A write is stamped one later than the newest
the writer has seen; of two with the same stamp the one of the agent that stands later in the team wins, as if they
had written one after the other. Everybody hears of every write at once, so all copies agree between steps; `clock`
and `writer` are those of the value that holds. Writing the value that is there already is no write.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.diagnostics import Diagnostic
from kitrobot.primitives import RobotObject
from kitrobot.sim import rules
from kitrobot.sim.agents import Agent


class SharedVariables:
    """The copies of all agents; `values[v]` is what holds for variable v, `names[v]` its name."""

    def __init__(self, agents: Sequence[Agent]) -> None:
        self.names: list[str] = []
        self.values: list[int] = []
        self.clock: list[int] = []
        self.writer: list[int] = []
        self.problems: list[Diagnostic] = []
        self._copies: list[list[tuple[Agent, int]]] = []
        self._cells: dict[int, list[tuple[int, int]]] = {}
        self._booleans: list[bool] = []
        first: dict[str, tuple[Agent, RobotObject]] = {}
        for agent in agents:
            cells = self._cells[agent.index] = []
            for variable in agent.robot.variables:
                if not variable.shared:
                    continue
                if variable.name not in first:
                    first[variable.name] = (agent, variable)
                    self._add(variable)
                elif _meaning(first[variable.name][1]) != _meaning(variable):
                    other = first[variable.name][0].robot.name
                    message = f"{variable.name} is shared, and {other} and {agent.robot.name} define it differently"
                    self.problems.append(rules.SHARED(message, help="give it the same type, range and first value"))
                number = self.names.index(variable.name)
                cell = agent.machine.layout.variables[variable.name]
                cells.append((cell, number))
                self._copies[number].append((agent, cell))

    def _add(self, variable: RobotObject) -> None:
        self.names.append(variable.name)
        self.values.append(variable.initial)
        self.clock.append(0)
        self.writer.append(-1)
        self._copies.append([])
        self._booleans.append(variable.minimum == 0 and variable.type.value == "boolean")

    def exchange(self, agents: Sequence[Agent]) -> list[tuple[int, str]]:
        """Spreads what `agents` wrote in this tick; gives (writer, "NAME = value") of the writes that won."""
        written: dict[int, tuple[int, int, int]] = {}
        for agent in agents:
            cells = agent.machine.cells
            for cell, number in self._cells[agent.index]:
                value = cells[cell]
                if value != self.values[number]:
                    stamp = (self.clock[number] + 1, agent.index, value)
                    if number not in written or stamp[:2] > written[number][:2]:
                        written[number] = stamp
        news: list[tuple[int, str]] = []
        for number, (clock, writer, value) in sorted(written.items()):
            self.clock[number], self.writer[number], self.values[number] = clock, writer, value
            for agent, cell in self._copies[number]:
                agent.machine.cells[cell] = value
            said = ("false", "true")[value] if self._booleans[number] else str(value)
            news.append((writer, f"{self.names[number]} = {said}"))
        return news


def _meaning(variable: RobotObject) -> tuple[object, ...]:
    return variable.type, variable.minimum, variable.maximum, variable.initial
