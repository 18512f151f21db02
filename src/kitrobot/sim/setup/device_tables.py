"""The devices of a run while its tables grow, and the tables of sensors, or of actuators."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices import Device, Placement, Values
from kitrobot.sim.tables.columns import A_CELL, A_DELAY
from kitrobot.sim.tables.state import Actuators, Sensors


@dataclass(frozen=True, slots=True)
class FittedDevice:
    """A device on its robot: `number` is its place among the robot's sensors, or actuators, as its XML lists them."""

    robot: int
    number: int
    part: RobotObject
    device: type[Device]
    values: Values
    placement: Placement


class DeviceTables:
    """Sensors, or actuators, sorted by their kind; `actuator_index[n]` is where the n-th that was added stands."""

    def __init__(self, fitted: Sequence[FittedDevice], kinds: int, int_columns: int, float_columns: int) -> None:
        order = sorted(range(len(fitted)), key=lambda n: fitted[n].device.kind)
        self.fitted = [fitted[n] for n in order]
        self.actuator_index = [0] * len(fitted)
        for k, n in enumerate(order):
            self.actuator_index[n] = k
        counts = [0] * kinds
        for item in fitted:
            counts[item.device.kind] += 1
        self.bank = [sum(counts[:kind]) for kind in range(kinds + 1)]
        self.ints = [[0] * len(fitted) for _ in range(int_columns)]
        self.floats = [[0.0] * len(fitted) for _ in range(float_columns)]
        self.takens: list[list[int]] = []
        self.outputs: list[list[int]] = []
        self.numbers: list[float] = []
        self.room = 0

    def put_ints(self, k: int, numbers: dict[int, int]) -> None:
        for column, number in numbers.items():
            self.ints[column][k] = number

    def put_floats(self, k: int, numbers: Sequence[float]) -> None:
        for column, number in enumerate(numbers):
            self.floats[column][k] = number

    def sensors(self) -> Sensors:
        """The tables of sensors of a state."""
        return Sensors(self.ints, self.floats, self.bank, [0] * self.room, self.numbers)

    def actuators(self) -> Actuators:
        """The tables of actuators of a state."""
        return Actuators(
            ints=self.ints,
            floats=self.floats,
            bank=self.bank,
            actuator_index=self.actuator_index,
            waited_for=[k for k, cell in enumerate(self.ints[A_CELL]) if cell >= 0],
            late=[k for k, delay in enumerate(self.ints[A_DELAY]) if delay],
            takens=self.takens,
            outputs=self.outputs,
            queue=[0] * self.room,
        )
