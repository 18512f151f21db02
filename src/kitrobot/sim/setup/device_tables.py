"""The devices of a run while its tables grow, and the tables of sensors, or of actuators."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices import Device, Placement, Values


@dataclass(frozen=True, slots=True)
class FittedDevice:
    """A device on its robot: `number` is its place among the robot's sensors, or actuators, as its XML lists them."""

    robot: int
    number: int
    part: RobotObject
    device: type[Device]
    values: Values
    placement: Placement
    keys: tuple[int, int]


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
