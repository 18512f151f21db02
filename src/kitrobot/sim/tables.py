"""Builds the tables of a run: the world once, then robots, machines and devices one after another, then the room
to work in.

Who may stand where, and what a robot's XML may say, was decided before (staging).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.image import Machine
from kitrobot.primitives import Robot, RobotObject
from kitrobot.sim import columns as c
from kitrobot.sim.angles import direction
from kitrobot.sim.chance import keys
from kitrobot.sim.commanding import QUEUE
from kitrobot.sim.contacts import TOUCH_MM
from kitrobot.sim.devices import Actuator, Device, Sensor, Standing, Values, actuators, sensors, ticks
from kitrobot.sim.failures import Fates
from kitrobot.sim.grids import FEW, Grid, fixed
from kitrobot.sim.physics import arrange
from kitrobot.sim.shared import SharedTables
from kitrobot.sim.standstill import HELD_ROWS, QUIET_STEPS
from kitrobot.sim.state import State
from kitrobot.world import COLOURS, Pose, World

NEVER = -(1 << 40)
"""What no sensor reads: the machine was given nothing yet."""

BY_HAND_AT_ONCE = 64
"""So much can be done to the robots of any run by hand between two steps, and be told."""


@dataclass(frozen=True, slots=True)
class Fitted:
    """A device on its robot: `number` is its place among the robot's sensors, or actuators, as its XML lists them."""

    robot: int
    number: int
    part: RobotObject
    device: type[Device]
    values: Values
    standing: Standing
    keys: tuple[int, int]


class Tables:
    """The tables while they grow; `state` puts them together.

    Args:
        world: where the run takes place.
        step_ms: a step of the run.
        seed: where chance begins.
    """

    def __init__(self, world: World, step_ms: int, seed: int) -> None:
        self.world = world
        self.dt = step_ms / 1000
        self.seed = seed
        self.real: list[list[float]] = [[] for _ in range(c.REALS)]
        self.whole: list[list[int]] = [[] for _ in range(c.WHOLES)]
        self.machines: list[Machine] = []
        self.robots: list[Robot] = []
        self._programs: dict[int, int] = {}
        self._code: list[list[int]] = []
        self._commands: list[list[int]] = []
        self._parts: list[int] = []
        self._sensors: list[Fitted] = []
        self._actuators: list[Fitted] = []
        self._turning: set[int] = set()
        self.fates = Fates()
        """What is to befall the robots; set before `state`."""
        self.goals: list[list[int]] = [[], []]
        """The storehouses of goals, and how many boxes each is to hold; set before `state`."""

    # -- robots

    def add_robot(self, pose: Pose, robot: Robot, machine: Machine, period: int) -> int:
        """A robot without wheels, without size, at a place; its devices give it more. Gives its number."""
        number = len(self.machines)
        for row in self.real:
            row.append(0.0)
        for counts in self.whole:
            counts.append(0)
        real, whole = self.real, self.whole
        real[c.X][number], real[c.Y][number], real[c.HEADING][number] = pose.x_mm, pose.y_mm, pose.heading_rad
        real[c.UX][number], real[c.UY][number] = direction(pose.heading_rad)
        real[c.ACCELERATION][number] = real[c.BRAKING][number] = 1.0
        real[c.GAP_AHEAD][number] = real[c.GAP_BEHIND][number] = math.inf
        whole[c.ROAD][number] = c.FREE
        whole[c.LEADER][number] = -1
        whole[c.PERIOD][number] = period
        whole[c.PROGRAM][number] = self._program(machine, robot)
        whole[c.WIRES][number] = len(self._actuators)
        self.machines.append(machine)
        self.robots.append(robot)
        return number

    def _program(self, machine: Machine, robot: Robot) -> int:
        known = self._programs.get(id(machine.code))
        if known is not None:
            return known
        number = self._programs[id(machine.code)] = len(self._code)
        self._code.append(machine.code)
        self._parts.append(len(robot.actuators))
        self._commands.append([])
        return number

    def add_device(
        self,
        robot: int,
        number: int,
        part: RobotObject,
        device: type[Device],
        values: Values,
        standing: Standing,
        name: str,
    ) -> None:
        """A device of a robot; an actuator's robot has no other robot's actuators between its own."""
        category = "sensor" if issubclass(device, Sensor) else "actuator"
        fitted = Fitted(robot, number, part, device, values, standing, keys(self.seed, name, category, part.name))
        (self._sensors if category == "sensor" else self._actuators).append(fitted)
        device.fit(robot, self.real, self.whole, values)
        if device.name == "turn":
            self._turning.add(robot)
        if category == "actuator":
            program = self.whole[c.PROGRAM][robot]
            commands = self._commands[program]
            expected = self.machines[robot].layout.commands
            assert issubclass(device, Actuator)
            if len(commands) < 3 * len(expected):
                for method in part.methods:
                    procedure = device.procedures.index(method.name)
                    commands += [procedure, len(method.parameters), 1 if method.completes_later else 0]

    # -- together

    def state(self, shared: SharedTables) -> State:
        """The state before the first step."""
        real, whole = self.real, self.whole
        count = len(self.machines)
        robots = range(count)
        solid = [i for i in robots if whole[c.SOLID][i]]
        guided = [i for i in solid if whole[c.ROAD][i] >= 0]
        free = [i for i in robots if whole[c.ROAD][i] < 0 and (whole[c.SOLID][i] or i in self._turning)]
        guided.sort(key=lambda i: (whole[c.ROAD][i], real[c.AT][i]))
        widest = max((real[c.RADIUS][i] for i in solid), default=0.0)
        free_solid = [i for i in free if whole[c.SOLID][i]]
        together = len(solid) > 1 and (bool(free_solid) or len({whole[c.ROAD][i] for i in guided}) > 1)
        world = _WorldTables(self.world, widest + TOUCH_MM)
        sensor = self._sensor_tables()
        actuator = self._actuator_tables()
        looking = any(
            item.device.name == "range" or (item.device.name == "collision" and whole[c.ROAD][item.robot] < 0)
            for item in self._sensors
        )
        sees = len(solid) > 1 and looking
        in_grid = len(solid) if together or sees else 0
        pairs = 4 * len(solid) + 64 if solid else 0
        buckets = 64
        while buckets < 2 * pairs:
            buckets *= 2
        variables = len(shared.variables)
        most_events = count + pairs + len(free_solid) + 2 * len(self._actuators) + variables
        most_events += self.fates.most_events(count, variables)
        clock = [0] * c.CLOCKS
        clock[c.RUNNING] = clock[c.LIVING] = clock[c.SOUND] = count
        clock[c.REVIVALS] = self.fates.revivals
        clock[c.MOVED] = 1
        clock[c.CYCLE] = math.lcm(*whole[c.PERIOD])
        clock[c.UNTIL] = 1
        clock[c.PATIENCE] = QUIET_STEPS + max(
            (
                size * whole[c.PERIOD][i]
                for size, i in zip(sensor.whole[c.S_SIZE], sensor.whole[c.S_ROBOT], strict=True)
            ),
            default=0,
        )
        by_hand = [item for item in sensor.fitted if issubclass(item.device, Sensor) and item.device.by_hand]
        clock[c.CHANCE] = sum(sensor.whole[c.S_RESTLESS]) + len(by_hand)
        machines = self.machines
        room = max(4 * max(len(self.world.walls), FEW), 2 * in_grid) + 32
        state = State(
            fixed=[1 if together else 0, 1 if sees else 0, most_events, self.fates.every],
            fixed_real=[self.dt, widest, self.fates.probability, self.world.width_mm, self.world.height_mm],
            clock=clock,
            events=[0] * (c.EVENT * (2 * most_events + BY_HAND_AT_ONCE + variables)),
            real=real,
            whole=whole,
            solid=solid,
            guided=guided,
            free=free,
            free_solid=free_solid,
            carriers=[i for i in robots if whole[c.BED][i]],
            code=self._code,
            commands=self._commands,
            parts=self._parts,
            cells=[machine.cells for machine in machines],
            threads=[machine.threads for machine in machines],
            pars=[machine.pars for machine in machines],
            out=[machine.out for machine in machines],
            seen=[machine.seen for machine in machines],
            was_cells=[],
            was_threads=[],
            was_pars=[],
            kept_cells=[[] for _ in robots],
            kept_threads=[[] for _ in robots],
            kept_pars=[[] for _ in robots],
            sensor=sensor.whole,
            sensor_real=sensor.real,
            sensor_bank=sensor.bank,
            past=[0] * sensor.room,
            actuator=actuator.whole,
            actuator_real=actuator.real,
            actuator_bank=actuator.bank,
            wires=actuator.wires,
            waited_for=[k for k, cell in enumerate(actuator.whole[c.A_CELL]) if cell >= 0],
            late=[k for k, delay in enumerate(actuator.whole[c.A_DELAY]) if delay],
            takens=actuator.takens,
            faces=actuator.faces,
            queue=[0] * actuator.room,
            shared=shared.rows,
            apart=shared.apart,
            mine_first=shared.mine_first,
            mine=shared.mine,
            mine_cell=shared.mine_cell,
            copy_robot=shared.copy_robot,
            copy_cell=shared.copy_cell,
            plan=self.fates.plan,
            fate=self.fates.keys,
            roads=world.roads,
            road_length=world.road_length,
            points=world.points,
            cut_from=world.cut_from,
            cut_sign=world.cut_sign,
            docks=world.docks,
            dock_road=world.dock_road,
            stock=[house.stock for house in self.world.storehouses],
            capacity=[house.capacity for house in self.world.storehouses],
            goals=self.goals,
            walls=world.walls,
            wall_frame=world.wall_grid.frame,
            wall_shape=world.wall_grid.shape,
            wall_starts=world.wall_grid.starts,
            wall_items=world.wall_grid.items,
            stretches=world.stretches,
            colours=world.colours,
            line_frame=world.line_grid.frame,
            line_shape=world.line_grid.shape,
            line_starts=world.line_grid.starts,
            line_items=world.line_grid.items,
            floors=world.floors,
            floor_box=world.floor_box,
            floor_points=world.floor_points,
            frame=[0.0, 0.0, 1.0],
            shape=[1, 1],
            starts=[0] * (2 * in_grid + 16),
            items=[0] * (4 * in_grid),
            ray_cells=[0] * room,
            ray_exits=[0.0] * room,
            pairs=[0] * (2 * pairs),
            before=[0] * (2 * pairs),
            buckets=[-1] * buckets,
            chain=[0] * pairs,
            held=[[0.0] * max(count, len(self._actuators)) for _ in range(HELD_ROWS)],
        )
        if guided:
            arrange(real, whole, guided, state.roads, state.road_length, state.points)
        return state

    def _sensor_tables(self) -> _DeviceTables:
        made = _DeviceTables(self._sensors, len(sensors()), c.SENSOR_WHOLES, c.SENSOR_REALS)
        for k, item in enumerate(made.fitted):
            robot = self.robots[item.robot]
            size = ticks(item.values.number("latency"), robot.tick_ms / 1000) + 1
            unit = next((setting.unit for setting in item.device.settings if setting.name == "noise"), None)
            flips = unit == "%"
            noise = 0.0 if unit is None else item.values.part("noise") if flips else item.values.number("noise")
            dropout = item.values.part("dropout")
            assert issubclass(item.device, Sensor)
            made.put_whole(
                k,
                {
                    c.S_ROBOT: item.robot,
                    c.S_VALUE: item.device.resting(item.values),
                    c.S_LAST: NEVER,
                    c.S_CELL: self.machines[item.robot].layout.sensors[item.part.name],
                    c.S_LEAST: item.part.minimum,
                    c.S_MOST: item.part.maximum,
                    c.S_PLAIN: 1 if size == 1 and noise == 0 and dropout == 0 else 0,
                    c.S_FLIPS: 1 if flips else 0,
                    c.S_KEY_A: item.keys[0],
                    c.S_KEY_B: item.keys[1],
                    c.S_RING: made.room,
                    c.S_SIZE: size,
                    c.S_DOCK: item.standing.dock,
                    c.S_STORE: item.standing.storehouse,
                    c.S_RESTLESS: 1 if noise > 0 or dropout > 0 or item.device.restless else 0,
                },
            )
            made.put_real(k, (noise, dropout, *item.device.reals(item.part, item.values)))
            made.room += size
        return made

    def _actuator_tables(self) -> _DeviceTables:
        made = _DeviceTables(self._actuators, len(actuators()), c.ACTUATOR_WHOLES, c.ACTUATOR_REALS)
        for k, item in enumerate(made.fitted):
            delay = ticks(item.values.number("latency"), self.dt)
            size = delay // self.whole[c.PERIOD][item.robot] + 2 if delay else 0
            made.put_whole(
                k,
                {
                    c.A_ROBOT: item.robot,
                    c.A_KIND: item.device.kind,
                    c.A_DONE: 1,
                    c.A_CELL: self.machines[item.robot].layout.done.get(item.part.name, -1),
                    c.A_TAKEN: -1,
                    c.A_KEY_A: item.keys[0],
                    c.A_KEY_B: item.keys[1],
                    c.A_DELAY: delay,
                    c.A_QUEUE: made.room,
                    c.A_SIZE: size,
                    c.A_DOCK: item.standing.dock,
                    c.A_STORE: item.standing.storehouse,
                },
            )
            reals = item.device.reals(item.part, item.values)
            made.put_real(k, (item.values.part("noise"), item.values.part("dropout"), *reals))
            made.room += QUEUE * size
            made.takens.append([0] * max((len(method.parameters) for method in item.part.methods), default=0))
            assert issubclass(item.device, Actuator)
            made.faces.append([0] * item.device.face)
        return made


class _DeviceTables:
    """Sensors, or actuators, sorted by their kind; `wires[n]` is where the n-th that was added stands."""

    def __init__(self, fitted: Sequence[Fitted], kinds: int, wholes: int, reals: int) -> None:
        order = sorted(range(len(fitted)), key=lambda n: fitted[n].device.kind)
        self.fitted = [fitted[n] for n in order]
        self.wires = [0] * len(fitted)
        for k, n in enumerate(order):
            self.wires[n] = k
        counts = [0] * kinds
        for item in fitted:
            counts[item.device.kind] += 1
        self.bank = [sum(counts[:kind]) for kind in range(kinds + 1)]
        self.whole = [[0] * len(fitted) for _ in range(wholes)]
        self.real = [[0.0] * len(fitted) for _ in range(reals)]
        self.takens: list[list[int]] = []
        self.faces: list[list[int]] = []
        self.room = 0

    def put_whole(self, k: int, numbers: dict[int, int]) -> None:
        for column, number in numbers.items():
            self.whole[column][k] = number

    def put_real(self, k: int, numbers: Sequence[float]) -> None:
        for column, number in enumerate(numbers):
            self.real[column][k] = number


class _WorldTables:
    """What stands still. The last point of a road is inclusive, the last of its sections exclusive."""

    def __init__(self, world: World, margin: float) -> None:
        self.roads: list[list[int]] = [[], [], [], [], []]
        self.road_length: list[float] = []
        self.points: list[list[float]] = [[], [], [], [], []]
        self.cut_from: list[float] = []
        self.cut_sign: list[int] = []
        for road in world.roads:
            line = road.line
            points, cuts = len(self.points[0]), len(self.cut_from)
            for row, numbers in zip(
                self.points,
                (
                    line.xs,
                    line.ys,
                    line.along,
                    (*line.heading_from, line.heading_to[-1]),
                    (*line.heading_to, line.heading_to[-1]),
                ),
                strict=True,
            ):
                row += numbers
            self.cut_from += [section.from_mm for section in road.sections]
            self.cut_sign += [section.sign for section in road.sections]
            numbers_of = (1 if road.closed else 0, points, len(self.points[0]) - 1, cuts, len(self.cut_from))
            for whole, number in zip(self.roads, numbers_of, strict=True):
                whole.append(number)
            self.road_length.append(line.length_mm)
        names = [road.name for road in world.roads]
        self.docks = [[dock.at_mm for dock in world.docks], [dock.reach_mm for dock in world.docks]]
        self.dock_road = [names.index(dock.road) for dock in world.docks]
        self.walls = wall_rows(world)
        self.wall_grid: Grid = fixed(self.walls, margin)
        self.stretches: list[list[float]] = [[], [], [], [], []]
        self.colours: list[int] = []
        for coloured in world.lines:
            xs, ys = coloured.line.xs, coloured.line.ys
            for row, numbers in zip(self.stretches, (xs[:-1], ys[:-1], xs[1:], ys[1:]), strict=False):
                row += numbers
            self.stretches[4] += [coloured.width_mm / 2] * (len(xs) - 1)
            self.colours += [COLOURS[coloured.colour]] * (len(xs) - 1)
        self.line_grid: Grid = fixed(self.stretches, max(self.stretches[4], default=0.0))
        self.floors: list[list[int]] = [[], [], []]
        self.floor_box: list[list[float]] = [[], [], [], []]
        self.floor_points: list[list[float]] = [[], []]
        for floor in world.floors:
            xs, ys = floor.line.xs, floor.line.ys
            first = len(self.floor_points[0])
            for whole, number in zip(self.floors, (COLOURS[floor.colour], first, first + len(xs) - 1), strict=True):
                whole.append(number)
            for row, side in zip(self.floor_box, (min(xs), min(ys), max(xs), max(ys)), strict=True):
                row.append(side)
            self.floor_points[0] += xs
            self.floor_points[1] += ys


def wall_rows(world: World) -> list[list[float]]:
    """The walls as rows x1, y1, x2, y2."""
    return [
        [wall.x1_mm for wall in world.walls],
        [wall.y1_mm for wall in world.walls],
        [wall.x2_mm for wall in world.walls],
        [wall.y2_mm for wall in world.walls],
    ]
