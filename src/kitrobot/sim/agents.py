"""One agent of a run: its machine, and the wires between the machine and the simulated devices.

A wire from a sensor carries a value into the machine when the agent samples, as old and as noisy as the device's
settings say; a wire to an actuator carries a command to the device, as late as they say. Latency counts in the agent's
own ticks for sensors and in steps of the run for actuators. All chance comes from the wire's own generator.
"""

from __future__ import annotations

from collections import deque
from random import Random

from kitrobot.image import Command, Machine
from kitrobot.primitives import Robot
from kitrobot.sim.devices import Actuator, Sensor
from kitrobot.trace import Threads


class SensorWire:
    """From sensor `device` of a bank to the input `name`. `forced` takes the place of what is measured."""

    __slots__ = ("_chance", "_noise", "_past", "bank", "device", "forced", "last", "name", "plain")

    def __init__(self, name: str, bank: Sensor, device: int, delay: int, noise: float, chance: Random) -> None:
        self.name = name
        self.bank = bank
        self.device = device
        self.last: int | None = None
        self.forced: int | None = None
        self._past: deque[int] = deque(maxlen=delay + 1)
        self._noise = noise
        self._chance = chance
        self.plain = delay == 0 and noise == 0.0

    @property
    def noisy(self) -> bool:
        """Whether a reading may change although nothing does."""
        return self._noise > 0.0 and self.forced is None

    def reading(self) -> int:
        """What the machine gets to see now."""
        past = self._past
        past.append(self.bank.values[self.device])
        value = past[0]
        if self._noise:
            value += round(self._chance.gauss(0.0, self._noise))
        return value if self.forced is None else self.forced

    def force(self, value: int | None) -> None:
        """Puts a value in the place of what is measured; None gives the sensor back."""
        self.forced = value
        self.plain = value is None and self._past.maxlen == 1 and self._noise == 0.0

    def state(self) -> tuple[int, ...]:
        """What the next readings depend on."""
        return tuple(self._past)


class ActuatorWire:
    """From the machine to actuator `device` of a bank; `later` are its procedures that take longer."""

    __slots__ = ("_delay", "_queue", "_taken", "bank", "device", "done", "later", "name", "waited_for")

    def __init__(self, name: str, bank: Actuator, device: int, delay: int, later: frozenset[str]) -> None:
        self.name = name
        self.bank = bank
        self.device = device
        self.later = later
        self.done: int | None = None
        self.waited_for = bool(later)
        self._delay = delay
        self._queue: deque[tuple[int, Command]] = deque()
        self._taken: tuple[str, list[int]] | None = None

    def give(self, command: Command, step: int) -> bool:
        """Sends a command on its way; False when it says again what the device does already."""
        again = (command.procedure, command.arguments)
        if again == self._taken and command.procedure not in self.later:
            return False
        self._taken = again
        if self._delay:
            self._queue.append((step + self._delay, command))
        else:
            self.bank.take(self.device, command.procedure, command.arguments)
        return True

    def deliver(self, step: int) -> None:
        """Hands over the commands whose time has come."""
        while self._queue and self._queue[0][0] <= step:
            command = self._queue.popleft()[1]
            self.bank.take(self.device, command.procedure, command.arguments)

    @property
    def busy(self) -> bool:
        """Whether something is on its way or going on."""
        return bool(self._queue) or self.bank.busy(self.device)

    @property
    def finished(self) -> int:
        """The done flag: 0 from the moment a command that takes longer was given until it has ended."""
        return 0 if any(command.procedure in self.later for _, command in self._queue) else self.bank.done[self.device]


class Agent:
    """A member of the team while it runs; `period` is its tick in steps of the run."""

    def __init__(self, index: int, name: str, program: str, robot: Robot, machine: Machine, period: int) -> None:
        self.index = index
        self.name = name
        self.program = program
        self.robot = robot
        self.machine = machine
        self.period = period
        self.kind = "robot"
        self.number = 1
        self.ended = False
        self.sensors: list[SensorWire] = []
        self.actuators: dict[str, ActuatorWire] = {}
        self.late: list[ActuatorWire] = []
        self.waited_for: list[ActuatorWire] = []
        self.commands: list[Command] = []

    def add_actuator(self, wire: ActuatorWire, delay: int) -> None:
        """Connects an actuator."""
        self.actuators[wire.name] = wire
        if delay:
            self.late.append(wire)
        if wire.waited_for:
            self.waited_for.append(wire)

    def sample(self) -> None:
        """Carries what is measured, and what is done, into the machine."""
        machine = self.machine
        for wire in self.sensors:
            value = wire.bank.values[wire.device] if wire.plain else wire.reading()
            if value != wire.last:
                wire.last = value
                machine.set_input(wire.name, value)
        for actuator in self.waited_for:
            done = actuator.finished
            if done != actuator.done:
                actuator.done = done
                machine.set_done(actuator.name, done == 1)

    def react(self, step: int) -> bool:
        """One tick of the program; its commands go to the devices. Whether the program ended in this tick.

        `commands` are those that say something new.
        """
        if self.ended:
            self.commands = []
            return False
        machine = self.machine
        given = machine.tick()
        self.commands = [command for command in given if self.actuators[command.actuator].give(command, step)]
        self.ended = machine.threads[0] < 0
        return self.ended

    @property
    def busy(self) -> bool:
        """Whether a device of it is doing something."""
        return any(wire.busy for wire in self.actuators.values())

    @property
    def active(self) -> Threads:
        """(slot, instruction) where each live thread stands."""
        return () if self.ended else tuple(self.machine.active())
