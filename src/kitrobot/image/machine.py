"""One robot's program as a host runs it: the arrays of a verified image, and names for what is in them.

`tick` itself is the one in `kitrobot_onboard`; this class only sets inputs before it and reads commands after it. Cells
are named by the robot's definition: sensors in the order of its file, then one `done` flag for each actuator that has a
procedure which completes later, then variables.
"""

from __future__ import annotations

from copy import copy
from functools import lru_cache

from kitrobot.image.devices import Command, Devices
from kitrobot.image.model import Image, ImageError
from kitrobot.image.verification import verify
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.text.sentences import Sentence
from kitrobot_onboard.image import header, whole_arrays
from kitrobot_onboard.interpreter import tick

_VERIFIED = 64
"""Images that are known to be safe, so that a mission which is looked through after each edit is quick about it."""


@lru_cache(_VERIFIED)
def _verified(image: Image) -> None:
    """Raises ImageError unless the image is safe to run; only that it is is remembered."""
    verify(image)


class Layout:
    """Which cell holds what, and which command is which, for a robot. The compiler and every host share it."""

    def __init__(self, robot: Robot) -> None:
        self.sensors: dict[str, int] = {}
        self.done: dict[str, int] = {}
        self.variables: dict[str, int] = {}
        at = 1
        for sensor in robot.sensors:
            self.sensors[sensor.name] = at
            at += 1
        for actuator in robot.actuators:
            if any(method.completes_later for method in actuator.methods):
                self.done[actuator.name] = at
                at += 1
        self.inputs = at - 1
        for variable in robot.variables:
            self.variables[variable.name] = at
            at += 1
        self.cells = at
        self.ranges: dict[str, RobotObject] = {sensor.name: sensor for sensor in robot.sensors}
        self.commands: list[tuple[int, str, str]] = [
            (number, actuator.name, method.name)
            for number, actuator in enumerate(robot.actuators)
            for method in actuator.methods
        ]
        self.command = {(actuator, method): index for index, (_, actuator, method) in enumerate(self.commands)}
        self.most_arguments = max(
            (len(method.parameters) for actuator in robot.actuators for method in actuator.methods), default=0
        )

    def first_values(self, robot: Robot) -> list[int]:
        """The first values of the fault flag, inputs and variables: sensors 0 (within their range), done 1."""
        sensors = [min(max(0, sensor.minimum), sensor.maximum) for sensor in robot.sensors]
        return [0, *sensors, *[1] * len(self.done), *(variable.initial for variable in robot.variables)]


class Machine:
    """One robot's running program.

    Raises ImageError when the image was made for another robot definition or cannot be run safely.
    """

    def __init__(self, image: Image, robot: Robot, *, watch: bool = False) -> None:
        if image.fingerprint != robot.fingerprint:
            raise ImageError(
                Sentence("this image was made for another robot than `{robot}` as it is defined now", robot.name),
                Sentence("compile the program again for this robot"),
            )
        _verified(image)
        self.image = image
        self.robot = robot
        self.layout = Layout(robot)
        if (image.inputs, image.variables) != (self.layout.inputs, len(self.layout.variables)):
            raise ImageError(
                Sentence("this image's cells are not those of its robot"), Sentence("compile the program again")
            )
        if image.commands != tuple(number for number, _, _ in self.layout.commands):
            raise ImageError(
                Sentence("this image's commands are not those of its robot"), Sentence("compile the program again")
            )
        data = image.to_bytes()
        code, self.cells, self.threads, self.pars, self.out = whole_arrays(data, header(data))
        self.code: list[int] = list(code)
        self.seen: list[int] = [0] * image.instructions if watch else []
        self.width: int = self.pars[3]

    def twin(self) -> Machine:
        """Another robot's machine with the same program, as this one is now; they share what never changes."""
        other = copy(self)
        other.cells, other.threads, other.pars = self.cells[:], self.threads[:], self.pars[:]
        other.out, other.seen = self.out[:], self.seen[:]
        return other

    def set_input(self, sensor: str, value: int) -> None:
        """Samples a sensor: what the program reads from the next tick on, clamped to the sensor's range."""
        part = self.layout.ranges[sensor]
        self.cells[self.layout.sensors[sensor]] = min(max(value, part.minimum), part.maximum)

    def input(self, sensor: str) -> int:
        """The sampled value of a sensor."""
        return int(self.cells[self.layout.sensors[sensor]])

    def set_done(self, actuator: str, done: bool) -> None:
        """Says whether an actuator has ended what takes it longer; of no effect for one where nothing does."""
        cell = self.layout.done.get(actuator)
        if cell is not None:
            self.cells[cell] = 1 if done else 0

    def tick(self) -> list[Command]:
        """One reaction: at most one command an actuator, in the order of the actuators."""
        self.run_tick()
        return self.commands()

    def run_tick(self) -> None:
        """The same, for who reads the commands in `out`."""
        if self.seen:
            self.seen[:] = [0] * len(self.seen)
        tick(self.code, self.cells, self.threads, self.pars, self.out, self.seen)

    def react(self, devices: Devices) -> list[Command]:
        """One reaction with a host's devices: reads them, ticks, and applies the commands, which are returned too."""
        readings = devices.read()
        for sensor, value in readings.sensors.items():
            self.set_input(sensor, value)
        for actuator, done in readings.done.items():
            self.set_done(actuator, done)
        commands = self.tick()
        devices.apply(commands)
        return commands

    def commands(self) -> list[Command]:
        """The commands of the last tick."""
        out = self.out
        given: list[Command] = []
        for at in range(0, self.width * self.image.actuators, self.width):
            if out[at]:
                _, actuator, procedure = self.layout.commands[out[at + 2]]
                parameters = self.robot.calls[actuator, procedure][1].parameters
                arguments = [int(number) for number in out[at + 3 : at + 3 + len(parameters)]]
                given.append(Command(actuator, procedure, arguments, int(out[at]) - 1, int(out[at + 1])))
        return given

    def variables(self) -> dict[str, int]:
        """All variables of the robot, in the order of its file; a boolean is 0 or 1."""
        return {name: int(self.cells[cell]) for name, cell in self.layout.variables.items()}

    def set_variable(self, name: str, value: int) -> None:
        """Sets a variable from outside, clamped to its range."""
        part = next(variable for variable in self.robot.variables if variable.name == name)
        self.cells[self.layout.variables[name]] = min(max(value, part.minimum), part.maximum)

    @property
    def fault(self) -> int:
        """The fault flag: 1 once something was clamped, until the program clears it."""
        return int(self.cells[0])

    @property
    def ended(self) -> bool:
        """Whether the program's own thread has ended."""
        return bool(self.threads[0] < 0)

    def active(self) -> list[tuple[int, int]]:
        """(slot, instruction) where each live thread stands."""
        threads = self.threads
        return [
            (at // 2, int(threads[at]) - (1 if threads[at + 1] > 0 else 0))
            for at in range(0, 2 * len(self.image.slots), 2)
            if threads[at] >= 0
        ]

    def snapshot(self) -> tuple[list[int], list[int], list[int]]:
        """The whole state, to be given to `restore` later."""
        return list(self.cells), list(self.threads), list(self.pars)

    def restore(self, snapshot: tuple[list[int], list[int], list[int]]) -> None:
        """Goes back to a state of this very image."""
        for ours, theirs in zip((self.cells, self.threads, self.pars), snapshot, strict=True):
            ours[:] = theirs
