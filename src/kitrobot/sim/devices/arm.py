"""An arm at a dock: moves one box between the storehouse of the dock and the carrier that stands there.

The box changes hands in one moment, at the end of the swing, and only when everything is as it should be: a carrier
stands still in the dock, with room (or a box), and the storehouse has a box (or room). Else the arm comes back empty
and says so. Boxes are never made or lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from kitrobot.primitives import RobotObject
from kitrobot.sim.devices.base import LATENCY, Actuator, Setting, Stage, Standing, Values

LOAD = "Load"


class Arm(Actuator):
    """`Load()` takes a box from the storehouse to the carrier, `Unload()` back."""

    name = "arm"
    procedures = frozenset({LOAD, "Unload"})
    settings = (
        LATENCY,
        Setting("time", 2000.0, "how long one box takes", "ms", 1.0, 3_600_000.0),
        Setting("noise", 0.0, "how far that time may be off (one standard deviation)", "%", 0.0, 50.0),
    )
    needs = "dock"

    def __init__(self, stage: Stage) -> None:
        super().__init__(stage)
        self.seconds: list[float] = []
        self.noise: list[float] = []
        self.chance: list[Random] = []
        self.left: list[float] = []
        self.loads: list[bool] = []
        self.dock: list[int] = []
        self.road: list[int] = []
        self.storehouse: list[int] = []

    def add(self, robot: int, part: RobotObject, values: Values, standing: Standing, chance: Random) -> int:
        self.seconds.append(values.number("time") / 1000)
        self.noise.append(values.number("noise") / 100)
        self.chance.append(chance)
        self.left.append(0.0)
        self.loads.append(False)
        self.dock.append(standing.dock)
        self.road.append(standing.road)
        self.storehouse.append(standing.storehouse)
        return super().add(robot, part, values, standing, chance)

    def take(self, device: int, procedure: str, arguments: Sequence[int]) -> None:
        seconds = self.seconds[device]
        if self.noise[device]:
            seconds *= max(0.1, 1 + self.chance[device].gauss(0.0, self.noise[device]))
        self.left[device] = seconds
        self.loads[device] = procedure == LOAD
        self.done[device] = 0
        self.stage.bodies.arm[self.robot[device]] = 1

    def move(self, dt: float) -> None:
        for device, robot in enumerate(self.robot):
            if self.done[device]:
                continue
            self.left[device] -= dt
            if self.left[device] <= 1e-9:
                self._hand_over(device)
                self.done[device] = 1
                self.stage.bodies.arm[robot] = 0

    def _hand_over(self, device: int) -> None:
        stage, robot, house = self.stage, self.robot[device], self.storehouse[device]
        dock = stage.world.docks[self.dock[device]]
        carrier = stage.carrier_in(dock, self.road[device])
        name = stage.world.storehouses[house].name
        if self.loads[device]:
            if carrier < 0 or stage.bodies.load[carrier]:
                stage.happened.append(("message", robot, f"no empty carrier stands in dock {dock.name}"))
            elif stage.stock[house] == 0:
                stage.happened.append(("message", robot, f"storehouse {name} has no box"))
            else:
                stage.stock[house] -= 1
                stage.bodies.load[carrier] = 1
                stage.happened.append(("load", robot, f"a box from {name}"))
        elif carrier < 0 or not stage.bodies.load[carrier]:
            stage.happened.append(("message", robot, f"no loaded carrier stands in dock {dock.name}"))
        elif stage.stock[house] >= stage.capacity[house]:
            stage.happened.append(("message", robot, f"storehouse {name} is full"))
        else:
            stage.stock[house] += 1
            stage.bodies.load[carrier] = 0
            stage.delivered[carrier] += 1
            stage.happened.append(("unload", robot, f"a box into {name}"))
        assert stage.still_there(), "a box was made or lost"
