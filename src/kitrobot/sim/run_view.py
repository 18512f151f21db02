"""A run as it is now: what can be read of its tables, by names."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.agent_views import AgentView, poses_of, view_of
from kitrobot.sim.event_text import sensor_names
from kitrobot.sim.physics.bodies import WorldState
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.step.probes import FloatPlace, IntPlace, probe_tables
from kitrobot.sim.tables.columns import COLLISIONS, S_FORCED, TICK
from kitrobot.sim.tables.state import State, numbers
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.world.model import World


class RunView:
    """The agents and the state of a run. `collisions` counts contacts, each once; `stock` and `delivered` are by name.

    Args:
        world: where it is.
        members: the agents, in team order.
        state: the tables.
        tick_ms: how long a step is.
    """

    def __init__(self, world: World, members: list[Agent], state: State, tick_ms: int) -> None:
        self.world = world
        self.members = members
        self.tick_ms = tick_ms
        self.stage = WorldState(world, state)
        self._sensors = sensor_names(state, members)
        """The number of each sensor by its agent's number and its name."""
        self._sensors_of = [[self._sensors[one.index, s] for s in one.machine.layout.sensors] for one in members]
        self._show(state)

    def _show(self, state: State) -> None:
        """From now on the state is this."""
        self.state = state
        self.stage.show(state)
        for agent in self.members:
            agent.show(state)

    def probe(self, ints: Sequence[IntPlace], floats: Sequence[FloatPlace]) -> None:
        """Makes room to write down the numbers at these places after each step (see `step.probes`).

        Call it before the first step. Who begins to read them takes them too (`take_probed`), or no step goes on.
        """
        assert self.tick == 0, "before the first step"
        self._show(replace(self.state, probes=probe_tables(ints, floats)))

    @property
    def tick(self) -> int:
        """Finished steps."""
        return int(self.state.clock[TICK])

    @property
    def seconds(self) -> float:
        """Simulated time."""
        return self.tick * self.tick_ms / 1000

    @property
    def collisions(self) -> int:
        """How many times something began to touch something."""
        return int(self.state.clock[COLLISIONS])

    @property
    def stock(self) -> dict[str, int]:
        """Boxes by storehouse."""
        return {house.name: int(self.stage.stock[number]) for number, house in enumerate(self.world.storehouses)}

    @property
    def things(self) -> list[tuple[float, float]]:
        """(x mm, y mm) of the middle of each thing that can be pushed: the world's boxes, then its balls."""
        xs, ys = (numbers(column) for column in self.state.pushables.floats[:2])
        return list(zip(xs, ys, strict=True))

    @property
    def total(self) -> int:
        """All boxes there are, in storehouses and on carriers."""
        return self.stage.total

    @property
    def delivered(self) -> dict[str, int]:
        """Boxes each carrier brought, by its name."""
        return {agent.name: int(self.stage.delivered[agent.index]) for agent in self.members if agent.kind == "carrier"}

    def poses(self) -> list[tuple[float, float, float, int, int]]:
        """(x mm, y mm, heading rad, load, flags) of each agent, in team order."""
        return poses_of(self.state)

    def view(self, index: int) -> AgentView:
        """An agent as it is now, by its place in the team."""
        return view_of(self.members[index])

    def agent(self, name: str) -> AgentView:
        """An agent as it is now, by its name.

        Raises:
            KitRobotError: there is no such agent.
        """
        return self.view(self._member(name).index)

    @property
    def agents(self) -> list[AgentView]:
        """All agents as they are now, in team order."""
        return [self.view(index) for index in range(len(self.members))]

    def forced(self, agent: str) -> list[str]:
        """The sensors of an agent in whose place a value stands.

        Raises:
            KitRobotError: there is no such agent.
        """
        member = self._member(agent)
        forced = self.state.sensors.ints[S_FORCED]
        return [name for name in member.machine.layout.sensors if forced[self._sensors[member.index, name]]]

    def forced_bits(self) -> list[int]:
        """The same of every agent, in team order: a bit for each sensor of its robot, the first lowest."""
        forced = numbers(self.state.sensors.ints[S_FORCED])
        if not any(forced):
            return [0] * len(self.members)
        return [sum(1 << bit for bit, k in enumerate(own) if forced[k]) for own in self._sensors_of]

    def _member(self, agent: str) -> Agent:
        member = next((one for one in self.members if one.name == agent), None)
        if member is None:
            message = Sentence("no agent {agent} takes part in this run", agent)
            raise KitRobotError(message, self._names(agent))
        return member

    def _names(self, agent: str, part: str = "", parts: Callable[[Agent], Iterable[str]] | None = None) -> Help:
        """The help for a name that there is not: of an agent, or of a part of it."""
        member = next((one for one in self.members if one.name == agent), None)
        if member is None or parts is None:
            names = [one.name for one in self.members]
            return did_you_mean(agent, names) or Sentence("those who do are {known}", one_of(sorted(names)[:20]))
        known = list(parts(member))
        return did_you_mean(part, known) or (Sentence("it has {known}", one_of(known[:20])) if known else "")
