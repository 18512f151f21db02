"""A run of a mission in its world, step by step.

A step is the longest time that divides the ticks of all robots (20 ms for ours). In this order: sensors measure;
every agent whose tick it is samples them, then all of these react (one tick of their program each, in team order);
devices take the commands and move; what touches is parted; shared variables spread. The same mission, world and seed
give the same run, number for number: all chance comes from generators seeded by the run's seed and the names of agent
and device, and nothing reads a clock.

`tick` counts finished steps. Once `outcome` is set (see endings), `step` does nothing more. Left to others: the clock
on the wall, the trace (recording), who watches.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from kitrobot.compiler import Compiled
from kitrobot.diagnostics import KitRobotError
from kitrobot.mission import Mission
from kitrobot.primitives import Catalogue
from kitrobot.sim.agents import Agent
from kitrobot.sim.endings import Goals, Standstill, say_done, say_failed, say_stuck, say_time
from kitrobot.sim.physics import Physics
from kitrobot.sim.shared import SharedVariables
from kitrobot.sim.staging import SimulationError, Staging
from kitrobot.trace import Threads
from kitrobot.world import World, normalised

Outcome = Literal["done", "failed", "stuck", "time"]

LAMP = 1
FAILED = 2
ALARM = 4
ARM = 8
MOVING = 16
"""The bits of an agent's flags: lamp on, failed, collision sensor pressed, arm out, moving."""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened: `kind` is load, unload, message, collision or end."""

    tick: int
    kind: str
    agent: str
    text: str


@dataclass(frozen=True, slots=True)
class AgentView:
    """An agent as it is now. `kind` is carrier, loader, unloader, store-manager or robot; `number` counts within a
    kind.

    `state` is "running" while a device of it works or moves, "waiting" while only its program goes on, "idle" after its
    program has ended. `active` is (slot, instruction) of each live thread.
    """

    name: str
    program: str
    robot: str
    kind: str
    number: int
    x_mm: float
    y_mm: float
    heading_rad: float
    load: int
    flags: int
    state: str
    active: Threads
    values: Mapping[str, int]
    inputs: Mapping[str, int]
    fault: int


class Simulation:
    """A run. `collisions` counts contacts, each once; `stock` and `delivered` are by name.

    Args:
        mission: what is run, and by whom.
        world: where; it must have been read without errors.
        images: the compiled programs by name.
        catalogue: the robots.
        seed: decides all chance.
        seconds: simulated time after which the run ends with the outcome "time"; None for no limit.

    Raises:
        SimulationError: the mission cannot be run in this world; its diagnostics say everything that is in the way.
    """

    def __init__(
        self,
        mission: Mission,
        world: World,
        images: Mapping[str, Compiled],
        catalogue: Catalogue,
        seed: int = 0,
        seconds: float | None = None,
    ) -> None:
        staging = Staging(mission, world, images, catalogue, seed)
        self.mission = mission
        self.world = world
        self.seed = seed
        self.seconds_limit = seconds
        self.tick = 0
        self.tick_ms = staging.step_ms
        self.outcome: Outcome | None = None
        self.sentence = ""
        self.events: list[Event] = []
        """What happened in the last step."""
        self.members: list[Agent] = staging.agents
        self.stage = staging.stage
        self.shared = SharedVariables(self.members)
        if self.shared.problems:
            first = self.shared.problems[0]
            raise SimulationError(first.message, first.help, tuple(self.shared.problems))
        self._sensors = [bank for bank in staging.sensors.values() if bank.robot]
        self._actuators = [bank for bank in staging.actuators.values() if bank.robot]
        self._late = [wire for agent in self.members for wire in agent.late]
        self._same_period = all(agent.period == 1 for agent in self.members)
        self._goals = Goals(mission.team.goals, self.stage)
        self._physics = Physics(self.stage)
        self._standstill = Standstill(self.members)
        self._running = len(self.members)

    # -- going on

    def step(self) -> None:
        """One step of everything."""
        if self.outcome is not None:
            return
        step, stage = self.tick, self.stage
        stage.happened.clear()
        due = self.members
        if not self._same_period:
            due = [agent for agent in due if step % agent.period == 0]
        for bank in self._sensors:
            bank.sense()
        for agent in due:
            if not agent.ended:
                agent.sample()
        for agent in due:
            if agent.react(step):
                self._running -= 1
                stage.happened.append(("end", agent.index, "its program has ended"))
        for wire in self._late:
            wire.deliver(step)
        for actuators in self._actuators:
            actuators.move(stage.dt)
        for robot, other in self._physics.step(stage.dt):
            what = self.members[other].name if other >= 0 else "a wall"
            stage.happened.append(("collision", robot, f"touches {what}"))
        for writer, text in self.shared.exchange(due):
            stage.happened.append(("message", writer, text))
        self.tick = step + 1
        self.events = [Event(step, kind, self.members[index].name, text) for kind, index, text in stage.happened]
        self._look_for_an_end(due)

    def _look_for_an_end(self, due: list[Agent]) -> None:
        if self._running == 0:
            if self._goals.hold():
                self._end("done", say_done(self._goals, self.seconds))
            else:
                self._end("failed", say_failed(self._goals))
        elif self.seconds_limit is not None and self.seconds >= self.seconds_limit:
            self._end("time", say_time(self._goals, self.seconds_limit, self.members))
        elif (
            self._physics.rolling
            or self.stage.happened
            or any(agent.commands for agent in due)
            or any(agent.busy for agent in self.members)
        ):
            self._standstill.stirred()
        elif self._standstill.is_certain(self.tick):
            self._end("stuck", say_stuck(self._goals, self.members))

    def _end(self, outcome: Outcome, sentence: str) -> None:
        self.outcome, self.sentence = outcome, sentence

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures, from the next step on; None gives it back.

        Raises:
            KitRobotError: there is no such agent or sensor.
        """
        for member in self.members:
            for wire in member.sensors:
                if member.name == agent and wire.name == sensor:
                    wire.force(value)
                    self._standstill.stirred()
                    return
        raise KitRobotError(f"no agent {agent} with a sensor {sensor} takes part in this run")

    # -- looking

    @property
    def seconds(self) -> float:
        """Simulated time."""
        return self.tick * self.tick_ms / 1000

    @property
    def collisions(self) -> int:
        """How many times something began to touch something."""
        return self._physics.collisions

    @property
    def stock(self) -> dict[str, int]:
        """Boxes by storehouse."""
        return {house.name: self.stage.stock[number] for number, house in enumerate(self.world.storehouses)}

    @property
    def total(self) -> int:
        """All boxes there are, in storehouses and on carriers."""
        return self.stage.total

    @property
    def delivered(self) -> dict[str, int]:
        """Boxes each carrier brought, by its name."""
        return {agent.name: self.stage.delivered[agent.index] for agent in self.members if agent.kind == "carrier"}

    def flags(self, index: int) -> int:
        """Lamp, alarm, arm and motion of an agent, as bits."""
        bodies = self.stage.bodies
        return (
            (LAMP if bodies.lamp[index] else 0)
            | (ALARM if bodies.alarm[index] else 0)
            | (ARM if bodies.arm[index] else 0)
            | (MOVING if bodies.speed[index] or bodies.turn[index] else 0)
        )

    def poses(self) -> list[tuple[float, float, float, int, int]]:
        """(x mm, y mm, heading rad, load, flags) of each agent, in team order."""
        bodies = self.stage.bodies
        return [
            (bodies.x[i], bodies.y[i], normalised(bodies.heading[i]), bodies.load[i], self.flags(i))
            for i in range(len(bodies))
        ]

    def view(self, index: int) -> AgentView:
        """An agent as it is now, by its place in the team."""
        agent, bodies = self.members[index], self.stage.bodies
        machine = agent.machine
        return AgentView(
            agent.name,
            agent.program,
            agent.robot.name,
            agent.kind,
            agent.number,
            bodies.x[index],
            bodies.y[index],
            normalised(bodies.heading[index]),
            bodies.load[index],
            self.flags(index),
            "running" if agent.busy else "idle" if agent.ended else "waiting",
            agent.active,
            machine.variables(),
            {wire.name: machine.input(wire.name) for wire in agent.sensors},
            machine.fault,
        )

    @property
    def agents(self) -> list[AgentView]:
        """All agents as they are now, in team order."""
        return [self.view(index) for index in range(len(self.members))]
