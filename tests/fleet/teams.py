"""Random teams of the simulator's tests, run as fleets on a network in memory."""

from __future__ import annotations

from kitrobot.lll.tree import TeamProgram
from kitrobot.sim.tables.team_columns import T_ANCHOR, T_ANCHORED
from tests.fleet.network import LEASE, Fleet
from tests.sim.team_building import RunningTeam, lost_for
from tests.team_programs.making import TeamMaker


class FleetTeam(RunningTeam):
    """A random team whose robots are apart; what `RunningTeam` sees is the world with their bodies.

    What the log says comes with or before the commands that follow from it, so a substitute's anchor is what was before
    the commands of a step.
    """

    def __init__(self, maker: TeamMaker, program: TeamProgram, seed: int, lease: int = LEASE) -> None:
        super().__init__(maker, program, seed)
        self.fleet = Fleet(self.anew, seed, lease=lease)
        self.run = run = self.fleet.run
        self.stepped = False
        self.counts: dict[str, int] = dict.fromkeys(self.names, 0)
        self.fleet.on_step = self.on_step
        run.step = lambda: None  # type: ignore[method-assign]
        set_variable = run.set_variable

        def set_both(agent: str, variable: str, value: int) -> None:
            set_variable(agent, variable, value)
            i = self.names.index(agent)
            if i in self.fleet.hosts:
                self.fleet.hosts[i].machine.set_variable(variable, value)

        run.set_variable = set_both  # type: ignore[method-assign]

    def on_step(self) -> None:
        table = self.run.state.team.robots
        for agent in self.run.members:
            if table[T_ANCHOR][agent.index] >= 0 and table[T_ANCHORED][agent.index] == self.run.tick - 1:
                self.anchors[agent.name] = self.counts[agent.name], len(self.lines[agent.name])
        before = dict(self.anchors)
        super().step()
        for name, anchor in before.items():
            if name in self.anchors and self.anchors[name] != anchor and not self.took_over(name):
                self.anchors[name] = anchor
        for agent in self.run.members:
            self.counts[agent.name] = int(agent.machine.cells[agent.machine.layout.variables["Count"]])
        self.stepped = True

    def took_over(self, name: str) -> bool:
        return any(event.agent == name and lost_for(event) for event in self.run.events)

    def step(self) -> None:
        """Until the world has made a step."""
        self.stepped = False
        while not self.stepped:
            self.fleet.step()
