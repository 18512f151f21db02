"""One agent of a run: its name, its machine, and what it is doing, read from the state of the run."""

from __future__ import annotations

from kitrobot.image import Command, Machine
from kitrobot.primitives import Robot
from kitrobot.sim.columns import (
    A_FRESH,
    A_KIND,
    A_Q,
    A_R,
    A_STORE,
    CAUSE,
    DOWN,
    ENDED,
    FAILED,
    LEFT,
    MUTED,
    SINCE,
    TARGET,
    TICK,
    WELL,
    WIRES,
    X,
    Y,
)
from kitrobot.sim.commanding import busy
from kitrobot.sim.devices import actuators
from kitrobot.sim.devices.arm import ARM_DEVICE
from kitrobot.sim.devices.drive import DRIVE
from kitrobot.sim.devices.turn import TURN_DEVICE
from kitrobot.sim.devices.wheel import WHEEL_DEVICE
from kitrobot.sim.failures import CAUSES
from kitrobot.sim.state import State, numbers
from kitrobot.sim.stepping import HEIGHT, WIDTH
from kitrobot.trace import Threads


class Agent:
    """A member of the team while it runs; `period` is its tick in steps of the run, `number` counts within a kind.

    Its machine's lists are rows of the state's tables.
    """

    def __init__(self, index: int, name: str, program: str, robot: Robot, machine: Machine, period: int) -> None:
        self.index = index
        self.name = name
        self.program = program
        self.robot = robot
        self.machine = machine
        self.period = period
        self.kind = "robot"
        self.number = 1
        known = actuators()
        self._showing = [
            (part.name, known[part.device].shown, at)
            for at, part in enumerate(robot.actuators)
            if part.device in known and known[part.device].shown
        ]
        self._state: State | None = None

    def show(self, state: State) -> None:
        """From now on the state is this."""
        self._state = state
        machine, i = self.machine, self.index
        machine.cells, machine.threads = state.cells[i], state.threads[i]
        machine.pars, machine.out, machine.seen = state.pars[i], state.out[i], state.seen[i]

    @property
    def state(self) -> State:
        """The state that it is part of."""
        assert self._state is not None, "an agent is shown the state before anybody looks"
        return self._state

    @property
    def ended(self) -> bool:
        """Whether its program has ended."""
        return bool(self.state.whole[ENDED][self.index])

    def _actuators(self) -> range:
        first = self.state.whole[WIRES][self.index]
        return range(first, first + len(self.robot.actuators))

    @property
    def commands(self) -> list[Command]:
        """The commands of the last step that say something new."""
        state = self.state
        step = state.clock[TICK]
        fresh = [
            name.name
            for name, at in zip(self.robot.actuators, self._actuators(), strict=True)
            if state.actuator[A_FRESH][state.wires[at]] == step
        ]
        if not fresh:
            return []
        return [command for command in self.machine.commands() if command.actuator in fresh]

    def faces(self) -> list[tuple[str, list[int]]]:
        """What each of its actuators that shows something shows, by the actuator's name (see devices.base)."""
        state = self.state
        found = []
        for name, shown, at in self._showing:
            found.append((name, numbers(state.faces[state.wires[state.whole[WIRES][self.index] + at]][:shown])))
        return found

    @property
    def busy(self) -> bool:
        """Whether a device of it is doing something."""
        state = self.state
        tables = (state.actuator, state.actuator_real, state.real, state.whole)
        return any(busy(state.wires[at], *tables) for at in self._actuators())

    @property
    def down(self) -> int:
        """Whether its program misses its ticks: WELL, STALLED or FAILED (see columns)."""
        return int(self.state.whole[DOWN][self.index])

    @property
    def doing(self) -> str:
        """What it is doing, in one word of `AgentView.state`."""
        if self.down != WELL:
            return "failed" if self.down == FAILED else "stalled"
        return "running" if self.busy else "idle" if self.ended else "waiting"

    @property
    def downfall(self) -> str:
        """In words: what befell it, when, and how that came about; "" for one that is well."""
        state, i = self.state, self.index
        if self.down == WELL:
            return f"{self.name} has no radio" if state.whole[MUTED][i] else ""
        seconds = state.whole[SINCE][i] * state.fixed_real[0]
        cause = CAUSES[state.whole[CAUSE][i]]
        if self.down == FAILED:
            return f"{self.name} failed after {seconds:.1f} s ({cause})"
        return f"{self.name} stalled after {seconds:.1f} s ({cause})"

    @property
    def is_outside(self) -> bool:
        """Whether it has left the world and is beyond its edge still."""
        state, i = self.state, self.index
        x, y = state.real[X][i], state.real[Y][i]
        width, height = state.fixed_real[WIDTH], state.fixed_real[HEIGHT]
        return bool(state.whole[LEFT][i]) and not (0.0 <= x <= width and 0.0 <= y <= height)

    @property
    def is_driving(self) -> bool:
        """Whether its motors were told to turn last; its program may have ended."""
        state = self.state
        for at in self._actuators():
            k = state.wires[at]
            kind = state.actuator[A_KIND][k]
            told = state.actuator_real[A_R if kind == WHEEL_DEVICE else A_Q][k]
            if kind == DRIVE:
                told = state.real[TARGET][self.index]
            if kind in (DRIVE, WHEEL_DEVICE, TURN_DEVICE) and told:
                return True
        return False

    @property
    def full_house(self) -> int:
        """The number of the storehouse in which its arm waits for room; -1 when it waits for none."""
        state = self.state
        for at in self._actuators():
            k = state.wires[at]
            if state.actuator[A_KIND][k] == ARM_DEVICE and state.actuator_real[A_R][k] and self.down != FAILED:
                return int(state.actuator[A_STORE][k])
        return -1

    @property
    def active(self) -> Threads:
        """(slot, instruction) where each live thread stands."""
        return () if self.ended else tuple(self.machine.active())
