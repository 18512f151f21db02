"""Conditions over several agents in a run, simulated or recorded, on what the agents read in their last tick.

The *beginning* of a run, tick 0, is a state too: variables, roles and groups as they are before the first tick, and
what the sensors read first, which is known once the first tick is over. It is the first state of a check.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from kitrobot.image.machine import Layout
from kitrobot.mission.model import Team
from kitrobot.primitives.robot import Robot
from kitrobot.sim.breakpoints import Condition as Test
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.state import Team as TeamTables
from kitrobot.sim.tables.team_columns import T_ROLE
from kitrobot.sim.team.meetings import in_group
from kitrobot.verifier.properties.conditions import AgentCondition, Member, Members

_MOST_KNOWN = 200_000
"""Answers that are remembered at most; then they are forgotten, all at once."""


def team_of(run: Simulation) -> list[Member]:
    """The agents of a run, as conditions name them."""
    return [Member(agent.name, agent.program, agent.robot) for agent in run.members]


def declared_of(run: Simulation) -> Team | None:
    """The team of a run if its robots run a team program; None otherwise."""
    return run.mission.team if run.team_plan is not None else None


def members_in_set(run: Simulation, team: TeamTables, name: str) -> tuple[int, ...]:
    """The numbers of the agents that are in a role or a group."""
    playing, groups = team.robots[T_ROLE], run.team_plan.groups if run.team_plan is not None else []
    if name in groups:
        group = list(groups).index(name)
        return tuple(i for i, role in enumerate(playing) if role >= 0 and in_group(i, group, team))
    number = next((at for at, role in enumerate(run.mission.team.roles) if role.name == name), -1)
    return tuple(i for i, role in enumerate(playing) if role >= 0 and role == number)


@dataclass
class AgentValuation:
    """The values that an agent reads and stores (`sim.breakpoints.Mind`)."""

    cells: Sequence[int]
    seen: Sequence[int] = ()


class RunConditions:
    """Decides conditions on a run as it is now. The same values come up often, so each answer is remembered.

    Args:
        conditions: those that are asked for.
        robots: the robot of each agent, by the agent's number.
        cells: what an agent has read and stores, by its number.
        members: the numbers of the agents that are in a role or a group.
    """

    def __init__(
        self,
        conditions: Iterable[AgentCondition],
        robots: Mapping[int, Robot],
        cells: Callable[[int], tuple[int, ...]],
        members: Members,
    ) -> None:
        self._cells = cells
        self._members = members
        self._robots = robots
        self._conditions = tuple(conditions)
        self._first_cells: dict[int, tuple[int, ...]] = {}
        self._first_members: dict[str, tuple[int, ...]] = {}
        self._tests = {
            (agent, test): Test(test, robots[agent])
            for one in self._conditions
            for test, agents in one.tests.items()
            for agent in agents
        }
        self._known: dict[tuple[int, str, tuple[int, ...]], bool] = {}

    def keep_beginning(self) -> None:
        """Keeps what is stored before the first tick, for `held_at_beginning`."""
        self._first_cells = {agent: self._cells(agent) for agent, _ in self._tests}
        self._first_members = {name: tuple(self._members(name)) for one in self._conditions for name in one.sets}

    def held_at_beginning(self, condition: AgentCondition) -> bool:
        """Whether one of them held at the beginning, which was kept; the run is in its first tick now."""
        return condition.holds(
            lambda agent, test: self._is_true(agent, test, self._beginning_of), self._first_members.__getitem__
        )

    def _beginning_of(self, agent: int) -> tuple[int, ...]:
        read, first = 1 + Layout(self._robots[agent]).inputs, self._first_cells[agent]
        return (*first[:1], *self._cells(agent)[1:read], *first[read:])

    def holds(self, condition: AgentCondition) -> bool:
        """Whether one of them holds."""
        return condition.holds(lambda agent, test: self._is_true(agent, test, self._cells), self._members)

    def _is_true(self, agent: int, test: str, cells_of: Callable[[int], tuple[int, ...]]) -> bool:
        if (agent, test) not in self._tests:
            return False
        cells = cells_of(agent)
        key = agent, test, cells
        known = self._known.get(key)
        if known is None:
            if len(self._known) >= _MOST_KNOWN:
                self._known.clear()
            known = self._known[key] = self._tests[agent, test].holds(AgentValuation(cells))
        return known


def simulated_conditions(conditions: Iterable[AgentCondition], run: Simulation) -> RunConditions:
    """Decides conditions on a run of the simulator."""

    def cells(agent: int) -> tuple[int, ...]:
        machine = run.members[agent].machine
        return tuple(int(cell) for cell in machine.cells[: machine.layout.cells])

    robots = {agent.index: agent.robot for agent in run.members}
    return RunConditions(conditions, robots, cells, lambda name: members_in_set(run, run.state.team, name))
