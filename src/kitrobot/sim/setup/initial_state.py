"""Builds the tables of a run: robots, machines and devices one after another, the world (world_tables), and the room
to work in.

Who may stand where, and what a robot's XML may say, was decided before (setup).
"""

from __future__ import annotations

import math
from dataclasses import replace

from kitrobot.image.machine import Machine
from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.radio import Radio
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.primitives.team_objects import TEAM
from kitrobot.sim.devices import Actuator, Device, Placement, Sensor, Values, actuators, sensors, ticks
from kitrobot.sim.physics.angles import direction
from kitrobot.sim.physics.grids import FEW
from kitrobot.sim.physics.pushable_grid import pushable_tables, pushable_walls
from kitrobot.sim.physics.step import arrange
from kitrobot.sim.physics.wall_contacts import TOUCH_MM
from kitrobot.sim.setup.device_tables import DeviceTables, FittedDevice
from kitrobot.sim.setup.radio_tables import beat_steps, delay_steps, radio_tables
from kitrobot.sim.setup.shared_tables import SharedTables
from kitrobot.sim.setup.team_tables import InitialState, TeamSetup, no_team, team_tables
from kitrobot.sim.setup.world_tables import dock_tables, floor_tables, line_tables, road_tables, wall_tables
from kitrobot.sim.step.actuation import QUEUE
from kitrobot.sim.step.deadlock_detection import HELD_ROWS, QUIET_STEPS
from kitrobot.sim.step.fault_schedule import FaultPlan
from kitrobot.sim.step.pens import pen_tables
from kitrobot.sim.step.probes import no_probes
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables.state import Contacts, Faults, Grid, Machines, Rays, Robots, State, Team
from kitrobot.world.geometry import Pose
from kitrobot.world.model import World

BY_HAND_AT_ONCE = 64
"""So much can be done to the robots of any run by hand between two steps, and be told."""


class Tables:
    """The tables while they grow; `state` puts them together, without the keys of chance (`chance_keys`).

    Args:
        world: where the run takes place.
        step_ms: a step of the run.
    """

    def __init__(self, world: World, step_ms: int) -> None:
        self.world = world
        self.dt = step_ms / 1000
        self.floats: list[list[float]] = [[] for _ in range(c.ROBOT_FLOATS)]
        self.ints: list[list[int]] = [[] for _ in range(c.ROBOT_INTS)]
        self.machines: list[Machine] = []
        self.robots: list[Robot] = []
        self._programs: dict[int, int] = {}
        self._code: list[list[int]] = []
        self._commands: list[list[int]] = []
        self._parts: list[int] = []
        self._sensors: list[FittedDevice] = []
        self._actuators: list[FittedDevice] = []
        self._turning: set[int] = set()
        self.fault_plan = FaultPlan()
        """What is to befall the robots; set before `state`."""
        self.team: TeamSetup | None = None
        """The team that some of the robots are of, where they run its program; set before `state`."""
        self.radio: Radio | None = None
        """How the robots hear each other; set before `state`."""
        self.numbers: dict[str, int] = {}
        """The numbers of robots by name; set before `state`."""
        self.breakdown = Breakdown()
        """What becomes of robots that fail on a road; set before `state`."""
        self.goals: list[list[int]] = [[], []]
        """The storehouses of goals, and how many boxes each is to hold; set before `state`."""

    # -- robots

    def add_robot(self, pose: Pose, robot: Robot, machine: Machine, period: int) -> int:
        """A robot without wheels, without size, at a place; its devices give it more. Gives its number."""
        number = len(self.machines)
        for row in self.floats:
            row.append(0.0)
        for counts in self.ints:
            counts.append(0)
        floats, ints = self.floats, self.ints
        floats[c.X][number], floats[c.Y][number], floats[c.HEADING][number] = pose.x_mm, pose.y_mm, pose.heading_rad
        floats[c.UX][number], floats[c.UY][number] = direction(pose.heading_rad)
        floats[c.ACCELERATION][number] = floats[c.BRAKING][number] = 1.0
        floats[c.GAP_AHEAD][number] = floats[c.GAP_BEHIND][number] = math.inf
        ints[c.ROAD][number] = c.FREE
        ints[c.LEADER][number] = -1
        ints[c.PERIOD][number] = period
        ints[c.PIECES][number] = 1
        ints[c.PROGRAM][number] = self._program(machine, robot)
        ints[c.ACTUATOR_INDEX][number] = len(self._actuators)
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
        placement: Placement,
    ) -> None:
        """A device of a robot; an actuator's robot has no other robot's actuators between its own."""
        category = "sensor" if issubclass(device, Sensor) else "actuator"
        fitted = FittedDevice(robot, number, part, device, values, placement)
        (self._sensors if category == "sensor" else self._actuators).append(fitted)
        device.fit(robot, self.floats, self.ints, values)
        if issubclass(device, Actuator) and device.turns:
            self._turning.add(robot)
        if category == "actuator":
            program = self.ints[c.PROGRAM][robot]
            commands = self._commands[program]
            expected = self.machines[robot].layout.commands
            assert issubclass(device, Actuator)
            if len(commands) < 3 * len(expected):
                for method in part.methods:
                    procedure = device.procedure_number(part, method, values)
                    commands += [procedure, len(method.parameters), 1 if method.completes_later else 0]

    # -- together

    def state(self, shared: SharedTables) -> State:
        """The state before the first step."""
        floats, ints, world = self.floats, self.ints, self.world
        robots = self._robot_tables()
        count, discs = len(self.machines), len(robots.solid)
        sensor, actuator = self._sensor_tables(), self._actuator_tables()
        pens = [k for k, one in enumerate(actuator.fitted) if issubclass(one.device, Actuator) and one.device.draws]
        contacts = contact_tables(discs)
        most_events = self._most_events(robots, len(contacts.chain), len(pens), shared)
        widest = max((floats[c.RADIUS][i] for i in robots.solid), default=0.0)
        roads = {ints[c.ROAD][i] for i in robots.guided}
        together = discs > 1 and (bool(robots.free_solid) or len(roads) > 1)
        sees = discs > 1 and any(
            issubclass(item.device, Sensor) and item.device.sees_robots(ints[c.ROAD][item.robot] >= 0)
            for item in self._sensors
        )
        in_grid = discs if together or sees else 0
        room = max(4 * max(len(world.walls), FEW), 2 * in_grid) + 32
        state = State(
            fixed=[
                *(1 if together else 0, 1 if sees else 0, most_events, self.fault_plan.every),
                *(tuple(BreakdownRule).index(self.breakdown.rule), ticks(self.breakdown.after_s * 1000, self.dt)),
            ],
            fixed_floats=[
                *(self.dt, widest, self.fault_plan.probability, world.width_mm, world.height_mm),
                self._smallest(robots),
            ],
            clock=self._clock(sensor),
            events=[0] * (c.EVENT * (2 * most_events + BY_HAND_AT_ONCE + len(shared.variables))),
            robots=robots,
            machines=self._machine_tables(),
            sensors=sensor.sensors(),
            actuators=actuator.actuators(),
            shared=shared.tables,
            team=self._team(actuator),
            radio=radio_tables(self.radio, list(self.numbers), ints[c.PERIOD], self.dt * 1000, shared),
            faults=Faults(self.fault_plan.with_room(), self.fault_plan.keys),
            roads=road_tables(world),
            docks=dock_tables(world, self.goals),
            walls=wall_tables(world, widest + TOUCH_MM),
            lines=line_tables(world),
            floors=floor_tables(world),
            grid=Grid([0.0, 0.0, 1.0], [1, 1], starts=[0] * (2 * in_grid + 16), items=[0] * (4 * in_grid)),
            rays=Rays(cells=[0] * room, exits=[0.0] * room),
            contacts=contacts,
            pens=pen_tables(pens, [actuator.fitted[k].robot for k in pens], floats[c.X], floats[c.Y]),
            pushables=pushable_tables(world, self.dt),
            pushable_walls=pushable_walls(wall_tables(world, 0.0), world),
            probes=no_probes(),
            held=[[0.0] * max(count, len(self._actuators)) for _ in range(HELD_ROWS)],
        )
        if robots.guided:
            arrange(state.robots, state.roads)
        return state

    def _robot_tables(self) -> Robots:
        floats, ints = self.floats, self.ints
        robots = range(len(self.machines))
        guided = [i for i in robots if ints[c.SOLID][i] and ints[c.ROAD][i] >= 0]
        free = [i for i in robots if ints[c.ROAD][i] < 0 and (ints[c.SOLID][i] or i in self._turning)]
        return Robots(
            floats=floats,
            ints=ints,
            solid=[i for i in robots if ints[c.SOLID][i]],
            guided=sorted(guided, key=lambda i: (ints[c.ROAD][i], floats[c.AT][i])),
            free=free,
            free_solid=[i for i in free if ints[c.SOLID][i]],
            carriers=[i for i in robots if ints[c.BED][i]],
        )

    def _smallest(self, robots: Robots) -> float:
        """How far whoever moves may go at once, whatever it meets."""
        sizes = [self.floats[c.RADIUS][i] / 2 for i in robots.solid]
        sizes += [self.floats[c.LENGTH][i] / 2 for i in robots.guided]
        sizes += [min(one.width_mm, one.height_mm) / 2 for one in self.world.boxes]
        return min(sizes + [one.radius_mm for one in self.world.balls], default=math.inf)

    def _most_events(self, robots: Robots, pairs: int, pens: int, shared: SharedTables) -> int:
        """How many events there may be in one step."""
        count, variables = len(self.machines), len(shared.variables)
        most = count + pairs + len(robots.free_solid) + 2 * len(self._actuators) + variables
        most += self.fault_plan.most_events(count, variables) + len(robots.guided) + pens
        if self.team is not None:
            most += self.team.most_events
        if self.radio is not None:
            most += len(shared.tables.mine) + count
        return most

    def _clock(self, sensor: DeviceTables) -> list[int]:
        """The counters of the run before its first step."""
        periods = self.ints[c.PERIOD]
        clock = [0] * c.CLOCKS
        clock[c.RUNNING] = clock[c.LIVING] = clock[c.HEALTHY] = len(self.machines)
        clock[c.REVIVALS] = self.fault_plan.revivals
        clock[c.PLANS] = len(self.fault_plan.plan[0])
        clock[c.MOVED] = 1
        clock[c.CYCLE] = math.lcm(*periods)
        clock[c.UNTIL] = 1
        sizes = zip(sensor.ints[c.S_SIZE], sensor.ints[c.S_ROBOT], strict=True)
        clock[c.PATIENCE] = QUIET_STEPS + max((size * periods[i] for size, i in sizes), default=0)
        if self.radio is not None:
            # Equal copies, and a majority, are found again with the next beat.
            step_ms = self.dt * 1000
            clock[c.PATIENCE] += 2 * beat_steps(step_ms) + delay_steps(self.radio, step_ms)
        by_hand = [item for item in sensor.fitted if issubclass(item.device, Sensor) and item.device.by_hand]
        clock[c.CHANCE] = sum(sensor.ints[c.S_RESTLESS]) + len(by_hand)
        return clock

    def _team(self, actuator: DeviceTables) -> Team:
        if self.team is None:
            return no_team()
        links = {one.robot: k for k, one in enumerate(actuator.fitted) if one.part.name == TEAM}
        self.team.members = [replace(one, actuator=links[one.robot]) for one in self.team.members]
        first = {program: n for n, program in reversed(list(enumerate(self.ints[c.PROGRAM])))}
        machines = [self.machines[first[program]] for program in range(len(self._code))]
        beginnings = InitialState(
            [list(machine.cells) for machine in machines],
            [list(machine.threads) for machine in machines],
            [list(machine.pars) for machine in machines],
            [_halt(one) for one in actuator.fitted],
        )
        return team_tables(self.team, len(self.machines), self.dt * 1000, beginnings)

    def _machine_tables(self) -> Machines:
        machines = self.machines
        return Machines(
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
            kept_cells=[[] for _ in machines],
            kept_threads=[[] for _ in machines],
            kept_pars=[[] for _ in machines],
        )

    def _sensor_tables(self) -> DeviceTables:
        made = DeviceTables(self._sensors, len(sensors()), c.SENSOR_INTS, c.SENSOR_FLOATS)
        # Where the numbers of sensors stand: those that are the same stand there once.
        places: dict[tuple[float, ...], int] = {}
        for k, item in enumerate(made.fitted):
            robot = self.robots[item.robot]
            size = ticks(item.values.number("latency"), robot.tick_ms / 1000) + 1
            unit = next((setting.unit for setting in item.device.settings if setting.name == "noise"), None)
            flips = unit == "%"
            noise = 0.0 if unit is None else item.values.part("noise") if flips else item.values.number("noise")
            dropout = item.values.part("dropout")
            assert issubclass(item.device, Sensor)
            numbers = tuple(item.device.table(item.part, item.values, self.world))
            if numbers not in places:
                places[numbers] = len(made.numbers)
                made.numbers += numbers
            first = places[numbers]
            made.put_ints(
                k,
                {
                    c.S_ROBOT: item.robot,
                    c.S_VALUE: item.device.resting(item.values),
                    c.S_LAST: c.NO_READING,
                    c.S_CELL: self.machines[item.robot].layout.sensors[item.part.name],
                    c.S_LEAST: item.part.minimum,
                    c.S_MOST: item.part.maximum,
                    c.S_PLAIN: 1 if size == 1 and noise == 0 and dropout == 0 else 0,
                    c.S_FLIPS: 1 if flips else 0,
                    c.S_RING: made.room,
                    c.S_SIZE: size,
                    c.S_DOCK: item.placement.dock,
                    c.S_STORE: item.placement.storehouse,
                    c.S_FIRST: first,
                    c.S_END: first + len(numbers),
                    c.S_RESTLESS: 1 if noise > 0 or dropout > 0 or item.device.restless else 0,
                },
            )
            own = item.device.initial_floats(item.part, item.values)
            agents = [item.values.word(setting.name) for setting in item.device.settings if setting.names_agent]
            own = (*own, *(float(self.numbers[name]) for name in agents))
            made.put_floats(k, (noise, dropout, *own))
            made.room += size
        return made

    def _actuator_tables(self) -> DeviceTables:
        made = DeviceTables(self._actuators, len(actuators()), c.ACTUATOR_INTS, c.ACTUATOR_FLOATS)
        for k, item in enumerate(made.fitted):
            delay = ticks(item.values.number("latency"), self.dt)
            size = delay // self.ints[c.PERIOD][item.robot] + 2 if delay else 0
            made.put_ints(
                k,
                {
                    c.A_ROBOT: item.robot,
                    c.A_KIND: item.device.kind,
                    c.A_DONE: 1,
                    c.A_CELL: self.machines[item.robot].layout.done.get(item.part.name, -1),
                    c.A_TAKEN: -1,
                    c.A_DELAY: delay,
                    c.A_QUEUE: made.room,
                    c.A_SIZE: size,
                    c.A_DOCK: item.placement.dock,
                    c.A_STORE: item.placement.storehouse,
                },
            )
            own = item.device.initial_floats(item.part, item.values)
            made.put_floats(k, (item.values.part("noise"), item.values.part("dropout"), *own))
            made.room += QUEUE * size
            made.takens.append([0] * max((len(method.parameters) for method in item.part.methods), default=0))
            assert issubclass(item.device, Actuator)
            made.outputs.append(list(item.device.initial_outputs(item.values)))
        return made


def contact_tables(discs: int) -> Contacts:
    """Room for the contacts of so many discs."""
    pairs = 4 * discs + 64 if discs else 0
    buckets = 64
    while buckets < 2 * pairs:
        buckets *= 2
    return Contacts(pairs=[0] * (2 * pairs), before=[0] * (2 * pairs), buckets=[-1] * buckets, chain=[0] * pairs)


def _halt(fitted: FittedDevice) -> int:
    """The number by which a device knows the procedure that stops it; -1 for none."""
    assert issubclass(fitted.device, Actuator)
    methods = {method.name: method for method in fitted.part.methods}
    stops = [methods[method.stop] for method in fitted.part.methods if method.stop in methods]
    found = next((method for method in stops if not method.parameters), None)
    return -1 if found is None else fitted.device.procedure_number(fitted.part, found, fitted.values)
