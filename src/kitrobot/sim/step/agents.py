"""One agent of a run: its name, its machine, and what it is doing, read from the state of the run."""

from __future__ import annotations

from kitrobot.image.devices import Command
from kitrobot.image.machine import Machine
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.sim.devices import actuators
from kitrobot.sim.step.actuation import busy
from kitrobot.sim.step.dispatch import KINDS
from kitrobot.sim.step.fault_injection import HELD
from kitrobot.sim.step.fault_schedule import CAUSES
from kitrobot.sim.tables.columns import (
    A_FRESH,
    A_KIND,
    A_STORE,
    ACTUATOR_INDEX,
    CAUSE,
    DOWN,
    DT,
    ENDED,
    FAILED,
    HEIGHT,
    LEFT,
    MUTED,
    ORIGIN,
    SINCE,
    SPEED,
    TICK,
    TURN,
    WELL,
    WIDTH,
    X,
    Y,
)
from kitrobot.sim.tables.state import State, numbers
from kitrobot.sim.tables.team_columns import T_SILENT
from kitrobot.text.sentences import Recorded
from kitrobot.trace.model import Threads


class Agent:
    """A member of the team while it runs; `period` is its tick in steps of the run, `number` counts within a kind.

    Its machine's lists are rows of the state's tables.
    """

    def __init__(self, index: int, name: str, program: str, robot: Robot, machine: Machine, period: int) -> None:
        self.index = index
        self.name = name
        self.program = program
        self.image_name = ImageName(program)
        self.robot = robot
        self.machine = machine
        self.period = period
        self.kind = "robot"
        self.number = 1
        known = actuators()
        self._showing = [
            (part.name, known[part.model].shown, at)
            for at, part in enumerate(robot.actuators)
            if part.model in known and known[part.model].shown
        ]
        self.pens = [part.name for part in robot.actuators if part.model in known and known[part.model].draws]
        """Its actuators that draw."""
        self._actuators: list[int] = []
        """The numbers of its actuators, as its XML lists them."""
        self._state: State | None = None

    def show(self, state: State) -> None:
        """From now on the state is this."""
        self._state = state
        machine, tables, i = self.machine, state.machines, self.index
        first = state.robots.ints[ACTUATOR_INDEX][i]
        self._actuators = numbers(state.actuators.actuator_index[first : first + len(self.robot.actuators)])
        machine.cells, machine.threads = tables.cells[i], tables.threads[i]
        machine.pars, machine.out, machine.seen = tables.pars[i], tables.out[i], tables.seen[i]

    @property
    def state(self) -> State:
        """The state that it is part of."""
        assert self._state is not None, "an agent is shown the state before anybody looks"
        return self._state

    @property
    def ended(self) -> bool:
        """Whether its program has ended."""
        return bool(self.state.robots.ints[ENDED][self.index])

    @property
    def commands(self) -> list[Command]:
        """The commands of the last step that say something new."""
        step, given = self.state.clock[TICK], self.state.actuators.ints[A_FRESH]
        fresh = [part.name for part, k in zip(self.robot.actuators, self._actuators, strict=True) if given[k] == step]
        return [command for command in self.machine.commands() if command.actuator in fresh]

    def outputs(self) -> list[tuple[str, list[int]]]:
        """What each of its actuators that shows something shows, by the actuator's name (see devices.base)."""
        outputs = self.state.actuators.outputs
        return [(name, numbers(outputs[self._actuators[at]][:shown])) for name, shown, at in self._showing]

    @property
    def busy(self) -> bool:
        """Whether a device of it is doing something."""
        state = self.state
        return any(busy(k, state) for k in self._actuators)

    @property
    def down(self) -> int:
        """Whether its program misses its ticks: WELL, STALLED or FAILED (see columns)."""
        return int(self.state.robots.ints[DOWN][self.index])

    @property
    def doing(self) -> str:
        """What it is doing, in one word of `AgentView.state`."""
        down = self.down
        if down != WELL:
            return "failed" if down == FAILED else "stalled"
        return "running" if self.busy else "idle" if self.ended else "waiting"

    @property
    def fault_text(self) -> str:
        """In words: what befell it, when, and how that came about; "" for one that is well."""
        state, i = self.state, self.index
        if self.down == WELL:
            if state.robots.ints[MUTED][i]:
                return Recorded("{robot} has no radio", self.name)
            silent = state.team.robots[T_SILENT]
            return (
                Recorded("{robot} hears no majority of its team", self.name) if len(silent) and silent[i] >= 0 else ""
            )
        seconds = state.robots.ints[SINCE][i] * state.fixed_floats[DT]
        number = state.robots.ints[CAUSE][i]
        cause = CAUSES[number]
        if number == HELD:
            return Recorded("{robot} stands still since {seconds} s ({cause})", self.name, f"{seconds:.1f}", cause)
        if self.down == FAILED:
            return Recorded("{robot} failed after {seconds} s ({cause})", self.name, f"{seconds:.1f}", cause)
        return Recorded("{robot} stalled after {seconds} s ({cause})", self.name, f"{seconds:.1f}", cause)

    @property
    def lost_its_box(self) -> bool:
        """Whether it was towed with a box for which there was no room where it came from."""
        return bool(self.state.robots.ints[ORIGIN][self.index] < 0)

    @property
    def is_outside(self) -> bool:
        """Whether it has left the world and is beyond its edge still."""
        state, i = self.state, self.index
        x, y = state.robots.floats[X][i], state.robots.floats[Y][i]
        width, height = state.fixed_floats[WIDTH], state.fixed_floats[HEIGHT]
        return bool(state.robots.ints[LEFT][i]) and not (0.0 <= x <= width and 0.0 <= y <= height)

    @property
    def is_driving(self) -> bool:
        """Whether its motors were told to turn last; its program may have ended."""
        return any(map(any, self._commanded_motions()))

    @property
    def commanded_motion(self) -> tuple[float, float]:
        """How its program told its motors to move it last: mm/s forward, rad/s to the left; 0 once it failed.

        A distance is driven at the speed that each step has; a road turns whoever follows it by itself.
        """
        if self.down == FAILED:
            return 0.0, 0.0
        motions = self._commanded_motions()
        return float(sum(speed for speed, _ in motions)), float(sum(rate for _, rate in motions))

    def _commanded_motions(self) -> list[tuple[float, float]]:
        state = self.state
        return [KINDS[state.actuators.ints[A_KIND][k]].commanded_motion(k, state) for k in self._actuators]

    @property
    def motion(self) -> tuple[float, float]:
        """How its wheels move it now: mm/s forward, rad/s to the left."""
        state, i = self.state, self.index
        return float(state.robots.floats[SPEED][i]), float(state.robots.floats[TURN][i] / state.fixed_floats[DT])

    @property
    def full_house(self) -> int:
        """The number of the storehouse in which its arm waits for room; -1 when it waits for none."""
        state = self.state
        ints = state.actuators.ints
        for k in self._actuators:
            if KINDS[ints[A_KIND][k]].is_waiting_for_room(k, state) and self.down != FAILED:
                return int(ints[A_STORE][k])
        return -1

    @property
    def active(self) -> Threads:
        """(slot, instruction) where each live thread stands."""
        return () if self.ended else tuple(self.machine.active())
