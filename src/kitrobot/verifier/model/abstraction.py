"""The discrete abstraction of a run: each agent's program table, and the discrete form of each of its devices.

Everything is read from the tables of a run before its first step, so the model has the numbers that the simulator has.
`limits` names what cannot be abstracted exactly, and verdicts report it.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

from kitrobot.mission.breakdown import BreakdownRule
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices import actuators, collision, drive, presence, sensors, sign, work_left
from kitrobot.sim.devices.base import Discrete
from kitrobot.sim.event_text import sensor_names
from kitrobot.sim.physics.docks import DOCK_AT, DOCK_REACH
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import COMMA, Label, Sentence, Series
from kitrobot.verifier.model.programs import ProgramTable, direction_on_road, greatest_argument, value_classes
from kitrobot.verifier.model.team_agreement import Agreement
from kitrobot.verifier.tables.roads import Gaps, Track, Zones, zones_of

NOISE_DEVIATIONS = 4.0
"""The most standard deviations by which a speed may differ from its nominal value."""


@dataclass(frozen=True)
class InputModel:
    """The discrete form of one input of a program.

    Attributes:
        discrete: the source of its value; ANY for an input that may read anything.
        signs: SECTION: its value in each zone.
        reach_mm: GAP: its range, mm.
        dock: VISIT: the dock, by its number.
        load: VISIT: the required load, 0 or 1; 2 for any.
        store: EXACT: the storehouse, by its number; -1 for the robot's own bed.
        choices: ANY: its possible values.
        least, most: the range that values are clamped to.
        actuator: BUSY: the place in `Inside.busy` of the actuator whose completion it reports.
        agreed: TEAM: the place in `team_agreement.TeamState`; -1 if it reads 0.
    """

    discrete: Discrete
    signs: tuple[int, ...] = ()
    reach_mm: float = 0.0
    dock: int = -1
    load: int = 2
    store: int = -1
    choices: tuple[int, ...] = ()
    least: int = 0
    most: int = 1
    actuator: int = -1
    agreed: int = -1


@dataclass(frozen=True)
class ActuatorModel:
    """The discrete form of one actuator of a robot.

    Attributes:
        name: its name.
        discrete: MOTION, BUSY or INSTANT.
        ways: for each command to this actuator, by the command's number: the direction of the wheels (MOTION), or the
            number of the procedure (BUSY).
        later: the commands that take longer, by their numbers.
        busy: its place in `Inside.busy`; -1 if nothing waits for it.
        is_arm: whether it moves boxes.
        dock, store: its dock and storehouse, by their numbers.
        agrees: its number in the run if it takes part in team agreement; -1 otherwise.
    """

    name: str
    discrete: Discrete
    ways: dict[int, int]
    later: frozenset[int]
    busy: int = -1
    is_arm: bool = False
    dock: int = -1
    store: int = -1
    agrees: int = -1


@dataclass
class AgentModel:
    """One agent of the model.

    Attributes:
        agent: the agent of the run.
        table: its program's reactions; agents of one program have the same.
        senses: its inputs, in the order of their cells.
        acts: its actuators, in the order of its XML.
        shared: the numbers of its shared variables, in the order of its XML.
        road: the number of its road; -1 for none.
        track: the discrete form of its road.
        leader, follower: the agents ahead and behind on the same road, by their numbers; -1 for none.
        drive: the number of the actuator that moves it along its road; -1 for none.
        is_late: whether commands reach that actuator late, or may be lost.
        is_member: whether it is of the team.
        is_spare: whether it plays no role in the team, so that it does nothing until a robot fails.
        is_asked: whether properties ask for a shared variable of it: its own copy, also once it has failed.
    """

    agent: Agent
    table: ProgramTable
    senses: list[InputModel]
    acts: list[ActuatorModel]
    shared: list[int]
    road: int = -1
    track: Track | None = None
    leader: int = -1
    follower: int = -1
    drive: int = -1
    is_late: bool = False
    is_member: bool = False
    is_spare: bool = False
    is_observed: bool = False


@dataclass
class Abstraction:
    """All agents; the inexact abstractions, in sentences; and the agreement of their team, if they are one."""

    parts: list[AgentModel]
    limits: list[str] = field(default_factory=list)
    agreement: Agreement | None = None


def abstract_run(run: Simulation, observed: Collection[str] = ()) -> Abstraction:
    """Makes the discrete abstraction of a run that is before its first step.

    Args:
        run: the run.
        observed: names of variables that properties read.

    Raises:
        AbstractionError: a part of the mission has no discrete form.
    """
    return _Builder(run, observed).build()


class _Builder:
    def __init__(self, run: Simulation, observed: Collection[str]) -> None:
        self.run = run
        self.state: State = run.state
        self.observed = observed
        self.limits: dict[str, None] = {}
        self.free: dict[Label, list[str]] = {}
        """For each sensor that may read anything, by its name on the page: the agents that distinguish its values."""
        self.rows = sensor_names(run.state, run.members)
        self.tables: dict[ImageName, ProgramTable] = {}
        self.numbers: dict[str, int] = {}
        self.agreement: Agreement | None = None
        if run.team_plan is not None:
            ints, known = run.state.actuators.ints, {device.kind for device in actuators().values() if device.agrees}
            self.agreement = Agreement(run, [k for k, kind in enumerate(ints[c.A_KIND]) if kind in known])
        for agent in run.members:
            for variable in agent.robot.variables:
                if variable.shared:
                    self.numbers.setdefault(variable.name, len(self.numbers))

    def build(self) -> Abstraction:
        mission = self.run.mission
        if mission.failures:
            self._limit(Sentence("the failures on the mission's schedule are left out"))
        if mission.breakdown.rule is not BreakdownRule.STAY:
            self._limit(Sentence("a robot that fails is taken to stay on its road"))
        if mission.radio is not None:
            self._limit(Sentence("shared variables are taken to reach everybody at once"))
        if self.agreement is not None:
            self._limit_team()
        members = self.run.members
        zones = self._zones()
        parts = []
        for agent in members:
            table = self.tables.get(agent.image_name)
            if table is None:
                table = ProgramTable(agent.machine.image, agent.robot, self.observed)
                self.tables[agent.image_name] = table
            road = int(self.state.robots.ints[c.ROAD][agent.index])
            acts = self._acts(agent, road)
            part = AgentModel(agent, table, [], acts, self._shared(agent), road)
            part.drive = next((at for at, act in enumerate(acts) if road >= 0 and act.discrete is Discrete.MOTION), -1)
            part.senses = self._senses(agent, acts, zones.get(road))
            if self.agreement is not None:
                part.is_member = self.agreement.is_member(agent.index)
                part.is_spare = part.is_member and not self.agreement.plays(agent.index)
            part.is_observed = any(one.shared and one.name in self.observed for one in agent.robot.variables)
            parts.append(part)
        self._neighbours(parts, zones)
        for sensor, names in self.free.items():
            self._limit(
                Sentence("{sensor} of {agent} is taken to read anything at any time", sensor, Series(COMMA, names))
            )
        return Abstraction(parts, list(self.limits), self.agreement)

    def _limit_team(self) -> None:
        if self.run.mission.radio is not None:
            self._limit(Sentence("what a team agrees on is taken to be known at once"))
        if any(work.lease for work in self.run.mission.team.works):
            self._limit(Sentence("as long as nobody fails, units of work are taken to be never free again undone"))

    def _limit(self, words: Sentence) -> None:
        self.limits[words] = None

    def _shared(self, agent: Agent) -> list[int]:
        return [self.numbers[one.name] for one in agent.robot.variables if one.shared]

    # -- roads

    def _zones(self) -> dict[int, Zones]:
        """The zones of each road with robots."""
        state = self.state
        roads, robots = state.roads, state.robots.ints
        found: dict[int, Zones] = {}
        for road in sorted({road for road in robots[c.ROAD] if road >= 0}):
            first, last = roads.ints[c.CUT_FIRST][road], roads.ints[c.CUT_LAST][road]
            aheads = {0.0}
            for agent in self.run.members:
                if robots[c.ROAD][agent.index] == road:
                    aheads |= {
                        state.sensors.floats[sign.AHEAD][self.rows[agent.index, part.name]]
                        for part in agent.robot.sensors
                        if part.model in sensors() and sensors()[part.model].discrete is Discrete.SECTION
                    }
            cuts = [at - ahead for at in roads.cut_from[first:last] for ahead in aheads]
            for dock, of in enumerate(state.docks.road):
                if of == road:
                    middle, reach = state.docks.floats[DOCK_AT][dock], state.docks.floats[DOCK_REACH][dock]
                    cuts += [middle - reach, middle + reach]
            found[road] = zones_of(roads.length[road], bool(roads.ints[c.CLOSED][road]), cuts)
        return found

    def _neighbours(self, parts: Sequence[AgentModel], zones: dict[int, Zones]) -> None:
        """Sets leaders and followers, and the classes of the gaps between them."""
        state = self.state
        at, length = state.robots.floats[c.AT], state.robots.floats[c.LENGTH]
        for road, its_zones in zones.items():
            order = sorted((i for i, part in enumerate(parts) if part.road == road), key=lambda i: at[i])
            for n, i in enumerate(order):
                part = parts[i]
                if n + 1 < len(order) or (its_zones.closed and len(order) > 1):
                    part.leader = order[(n + 1) % len(order)]
                    parts[part.leader].follower = i
            for i in order:
                part = parts[i]
                reaches = {sense.reach_mm for one in (i, part.leader) if one >= 0 for sense in parts[one].senses}
                half = (length[i] + length[part.leader]) / 2 if part.leader >= 0 else length[i]
                gaps = Gaps(tuple(sorted(reach for reach in reaches if reach > 0.5)), half)
                part.track = Track(its_zones, gaps, *self._distances(part))
        if len(zones) > 1:
            self._limit(Sentence("robots on different roads are taken to pass each other without touching"))

    def _distances(self, part: AgentModel) -> tuple[float, float]:
        """The distances, mm, that a robot rolls at full speed until it stands, and from tick to tick."""
        i = part.agent.index
        floats, actuator = self.state.robots.floats, self.state.actuators
        k = self._row(part.agent, part.drive) if part.drive >= 0 else -1
        if k < 0:
            return 0.0, 0.0
        percent = _fastest(part.agent, part.acts[part.drive])
        speed = (
            percent
            / 100
            * actuator.floats[drive.FULL_SPEED][k]
            * (1 + NOISE_DEVIATIONS * actuator.floats[c.A_NOISE][k])
        )
        dt = self.state.fixed_floats[c.DT]
        tick = speed * dt * (part.agent.period + 1)
        late = speed * dt * actuator.ints[c.A_DELAY][k]
        part.is_late = actuator.ints[c.A_DELAY][k] > 0 or actuator.floats[c.A_DROPOUT][k] > 0.0
        if actuator.floats[c.A_DROPOUT][k] > 0.0:
            late = math.inf
            self._limit(
                Sentence("commands to {part} may be lost: it may brake at any time", part.acts[part.drive].name)
            )
        return speed * speed / 2 / floats[c.BRAKING][i] + tick + late, tick

    def _row(self, agent: Agent, number: int) -> int:
        """The number of an actuator in the tables."""
        first = self.state.robots.ints[c.ACTUATOR_INDEX][agent.index]
        return int(self.state.actuators.actuator_index[first + number])

    # -- devices

    def _acts(self, agent: Agent, road: int) -> list[ActuatorModel]:
        acts: list[ActuatorModel] = []
        busy = 0
        known = actuators()
        commands = agent.machine.layout.commands
        for number, part in enumerate(agent.robot.actuators):
            device = known[part.model]
            ways: dict[int, int] = {}
            for at, (whose, _, procedure) in enumerate(commands):
                if whose == number:
                    listed = device.procedures.index(procedure) if procedure in device.procedures else 0
                    on_road = road >= 0 and device.drives
                    ways[at] = direction_on_road(listed, agent.name, part.name, procedure) if on_road else listed
            k = self._row(agent, number)
            agrees = device.agrees and self.agreement is not None
            waits = part.name in agent.machine.layout.done and not agrees
            is_arm = device.name == "arm"
            acts.append(
                ActuatorModel(
                    part.name,
                    device.discrete,
                    ways,
                    frozenset(at for at in ways if part.methods[_named(part, commands[at][2])].completes_later),
                    busy if waits else -1,
                    is_arm,
                    int(self.state.actuators.ints[c.A_DOCK][k]),
                    int(self.state.actuators.ints[c.A_STORE][k]),
                    k if agrees else -1,
                )
            )
            busy += waits
        return acts

    def _senses(self, agent: Agent, acts: Sequence[ActuatorModel], zones: Zones | None) -> list[InputModel]:
        found = [self._sense(agent, part, zones) for part in agent.robot.sensors]
        for name in agent.machine.layout.done:
            act = next(act for act in acts if act.name == name)
            if act.agrees >= 0 and self.agreement is not None:
                found.append(InputModel(Discrete.TEAM, agreed=self.agreement.done(act.agrees)))
            else:
                found.append(InputModel(Discrete.BUSY, actuator=act.busy))
        return found

    def _sense(self, agent: Agent, part: RobotObject, zones: Zones | None) -> InputModel:
        k = self.rows[agent.index, part.name]
        ints, floats = self.state.sensors.ints, self.state.sensors.floats
        discrete = sensors()[part.model].discrete
        least, most = int(ints[c.S_LEAST][k]), int(ints[c.S_MOST][k])
        is_plain = ints[c.S_SIZE][k] == 1 and floats[c.S_NOISE][k] == 0.0 and floats[c.S_DROPOUT][k] == 0.0
        if discrete in (Discrete.SECTION, Discrete.GAP) and zones is None:
            is_plain = False
        if not is_plain or discrete is Discrete.ANY:
            cell = agent.machine.layout.sensors[part.name]
            choices = value_classes(agent.machine.image, cell, least, most)
            # What a person does may really come at any time.
            if discrete is not Discrete.ANY or (len(choices) > 1 and not sensors()[part.model].by_hand):
                self.free.setdefault(Label(part.name, part.label), []).append(agent.name)
            return InputModel(Discrete.ANY, choices=choices)
        if discrete is Discrete.TEAM:
            return InputModel(
                discrete, agreed=self._agreed(agent, part, floats[work_left.WORK][k]), least=least, most=most
            )
        if discrete is Discrete.SECTION:
            assert zones is not None
            return InputModel(discrete, signs=self._signs(agent, zones, floats[sign.AHEAD][k]), least=least, most=most)
        if discrete is Discrete.GAP:
            return InputModel(discrete, reach_mm=floats[collision.REACH][k])
        if discrete is Discrete.VISIT:
            return InputModel(discrete, dock=int(ints[c.S_DOCK][k]), load=int(floats[presence.WANTED_LOAD][k]))
        is_store = sensors()[part.model].needs == "storehouse"
        return InputModel(discrete, store=int(ints[c.S_STORE][k]) if is_store else -1, least=least, most=most)

    def _agreed(self, agent: Agent, part: RobotObject, number: float) -> int:
        """The place in the team's state that a team sensor reads."""
        if self.agreement is None:
            return -1
        if sensors()[part.model].name == "team":
            return self.agreement.answer(agent.index)
        return self.agreement.left(int(number))

    def _signs(self, agent: Agent, zones: Zones, ahead: float) -> tuple[int, ...]:
        """The sign that a sensor reads in each zone."""
        roads = self.state.roads
        road = self.state.robots.ints[c.ROAD][agent.index]
        first, last = roads.ints[c.CUT_FIRST][road], roads.ints[c.CUT_LAST][road]
        signs = []
        for zone in range(len(zones)):
            begin, end = zones.ends(zone)
            at = (begin + end) / 2 + ahead
            at = at % zones.length_mm if zones.closed else at
            inside = [cut for cut in range(first, last) if roads.cut_from[cut] <= at] or [first]
            signs.append(int(roads.cut_sign[inside[-1]]) if first < last else 0)
        return tuple(signs)


def _named(part: RobotObject, method: str) -> int:
    """The place of a method in its part."""
    return [one.name for one in part.methods].index(method)


def _fastest(agent: Agent, act: ActuatorModel) -> float:
    """The greatest speed, percent, that a program can command."""
    part = next(one for one in agent.robot.actuators if one.name == act.name)
    most = max((parameter.maximum for method in part.methods for parameter in method.parameters[:1]), default=0)
    moving = [command for command, way in act.ways.items() if way]
    return max((greatest_argument(agent.machine.image, command, most) for command in moving), default=0)
