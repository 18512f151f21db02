"""The addresses of a mission: its programs, its team, its radio, its failures, its robots, and its world's."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.experiments.addresses import PROGRAM, Address, Put, collect_addresses
from kitrobot.experiments.team_size import MOST_OF_A_PROGRAM, set_team_size
from kitrobot.experiments.variant import Value, Variant
from kitrobot.experiments.world_addresses import world_addresses
from kitrobot.graph.model import Program, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.radio import LARGEST_RANGE_MM, LONGEST_DELAY_MS, Radio
from kitrobot.mission.trial import LONGEST_S, Failure
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import SlotKind
from kitrobot.primitives.robot import LARGEST_VALUE, Category, Robot, RobotObject
from kitrobot.sim.setup.settings import simulated_devices
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.world.limits import MAX_NUMBER

NEVER = "never"
"""In the place of a moment: this agent does not fail."""


def mission_addresses(opened: OpenMission) -> dict[str, Address]:
    """All that can vary in a mission, by address, in the order of its file; the mission must have no errors."""
    return collect_addresses(_addresses(opened))


def _addresses(opened: OpenMission) -> Iterator[Address]:
    mission, catalogue = opened.mission, opened.catalogue
    for at, program in enumerate(mission.programs):
        for vertex_at, vertex in enumerate(program.vertices):
            yield from _parameters(catalogue, program, vertex, (at, vertex_at))
    yield from _team_addresses(opened)
    yield from _rules(opened)
    for robot in _used_robots(opened):
        yield from _variables(opened, robot)
        for category in (Category.ACTUATOR, Category.SENSOR):
            for part in robot.actuators if category is Category.ACTUATOR else robot.sensors:
                yield from _settings(robot, part, category)
    assert opened.world is not None, "a mission without its world has an error"
    yield from world_addresses(opened.world)


def _used_robots(opened: OpenMission) -> list[Robot]:
    names = [agent.robot for agent in opened.mission.team.agents]
    names += [program.target for program in opened.mission.programs]
    return [opened.catalogue.robots[name] for name in dict.fromkeys(names) if name in opened.catalogue.robots]


# -- programs


def _parameters(catalogue: Catalogue, program: Program, vertex: Vertex, place: tuple[int, int]) -> Iterator[Address]:
    for name, least, most, default, unit in _numbers(catalogue, program, vertex):
        current = vertex.settings.get(name, default)
        yield Address(
            f"{program.name}.{vertex.id}.{name}",
            int(current) if current.lstrip("-").isdigit() else current or None,
            lambda variant, value, name=name: _put_setting(variant, place, name, value),  # type: ignore[misc]
            *(least, most, True),
            unit=unit,
        )


def _numbers(catalogue: Catalogue, program: Program, vertex: Vertex) -> Iterator[tuple[str, int, int, str, str]]:
    """Of each number that can be typed into a vertex: its name, least and most, what it is unasked, and its unit."""
    constructor = catalogue.constructors.get(vertex.element)
    if constructor is not None:
        for slot in constructor.slots:
            if slot.kind is SlotKind.NUMBER or (slot.kind is SlotKind.VALUE and slot.name in vertex.settings):
                least = -LARGEST_VALUE if slot.minimum is None else slot.minimum
                yield slot.name, least, LARGEST_VALUE if slot.maximum is None else slot.maximum, slot.default, slot.unit
        return
    robot = catalogue.robots.get(program.target) if program.target else catalogue.teams.get(program.level)
    call = robot.calls.get(tuple(vertex.element.split(".", 1))) if robot and "." in vertex.element else None  # type: ignore[arg-type]
    if call is not None:
        limited = call[1].is_limited
        for one in call[1].parameters:
            bounds = (one.minimum, one.maximum) if limited else (-LARGEST_VALUE, LARGEST_VALUE)
            if one.name in vertex.settings or not _is_filled(program, vertex, one.name):
                yield one.name, *bounds, str(one.default), one.unit


def _is_filled(program: Program, vertex: Vertex, slot: str) -> bool:
    """Whether another vertex gives that number."""
    return any(arc.target == vertex.id and arc.at == slot for arc in program.arcs)


def _put_setting(variant: Variant, place: tuple[int, int], name: str, value: Value) -> None:
    variant.mission.programs[place[0]].vertices[place[1]].settings[name] = str(value)


def put_program(variant: Variant, name: str, text: str, catalogue: Catalogue, file: str) -> None:
    """Puts the LLL of a file in the place of the program of a robot.

    Raises:
        ProblemsError: the text has mistakes.
    """
    programs = variant.mission.programs
    at = next(number for number, one in enumerate(programs) if one.name == name)
    parsed = parse(text, file)
    if any(item.is_error for item in parsed.diagnostics):
        message = Sentence("the program `{name}` has errors", file)
        raise ProblemsError(message, "", tuple(parsed.diagnostics), (parsed.source,))
    programs[at] = lll_to_graph(parsed.program, catalogue.robots[programs[at].target], catalogue, name)


# -- the team, and what befalls it


def _team_addresses(opened: OpenMission) -> Iterator[Address]:
    mission = opened.mission
    for program in mission.programs:
        if program.target:
            yield Address(f"{PROGRAM}{program.name}", program.name, _nothing, 1, 0, any_word=True)
    counts = Counter((agent.program, agent.robot) for agent in mission.team.agents)
    for (name, robot), count in counts.items():
        # Those of a team run one program, whatever they are.
        yield Address(f"agents.{robot or name}", count, _size(name, robot), 0, MOST_OF_A_PROGRAM, True)
    for role in mission.team.roles:
        yield Address(f"role.{role.name}", role.most, _role(role.name), 1, MOST_OF_A_PROGRAM, True)
    for work in mission.team.works:
        yield Address(f"work.{work.name}.units", work.units, _work(work.name), 1, MAX_NUMBER, True)
    for agent in mission.team.agents:
        found = next((one.at_s for one in mission.failures if one.agent == agent.name), None)
        current = NEVER if found is None else found
        yield Address(f"fail.{agent.name}", current, _failure(agent.name), 0, LONGEST_S, words=(NEVER,), unit="s")


def _nothing(variant: Variant, value: Value) -> None:
    """A program's text is put by `point_runner`, which has the files."""


def _size(program: str, robot: str) -> Put:
    return lambda variant, value: set_team_size(variant, program, robot, int(value))


def _role(name: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        roles = variant.mission.team.roles
        for at, role in enumerate(roles):
            if role.name == name:
                roles[at] = replace(role, least=min(role.least, int(value)), most=int(value))

    return put


def _work(name: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        works = variant.mission.team.works
        for at, work in enumerate(works):
            if work.name == name:
                works[at] = replace(work, units=int(value))

    return put


def _failure(agent: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        others = [one for one in variant.mission.failures if one.agent != agent]
        mine = [] if value == NEVER else [Failure(agent, float(value))]
        variant.mission.failures = others + mine

    return put


def _rules(opened: OpenMission) -> Iterator[Address]:
    radio, breakdown = opened.mission.radio, opened.mission.breakdown
    known = radio if radio is not None else Radio()
    yield Address("radio.range", known.range_mm, _radio("range_mm"), 1, LARGEST_RANGE_MM, unit="mm")
    yield Address("radio.delay", known.delay_ms, _radio("delay_ms"), 0, LONGEST_DELAY_MS, True, unit="ms")
    yield Address("radio.loss", known.loss, _radio("loss"), 0, 100, unit="%")
    words = tuple(rule.value for rule in BreakdownRule)
    yield Address("breakdown.rule", breakdown.rule.value, _put_rule, 1, 0, words=words)
    yield Address("breakdown.after", breakdown.after_s, _put_after, 0, LONGEST_S, unit="s")
    yield Address("fail-rate", 0, _put_fail_rate, 0, 1)


def _radio(field: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        radio = variant.mission.radio
        variant.mission.radio = replace(radio if radio is not None else Radio(), **{field: value})  # type: ignore[arg-type]

    return put


def _put_rule(variant: Variant, value: Value) -> None:
    rule = BreakdownRule(str(value))
    after_s = variant.mission.breakdown.after_s if rule is BreakdownRule.TOW else 0.0
    variant.mission.breakdown = Breakdown(rule, after_s)


def _put_after(variant: Variant, value: Value) -> None:
    variant.mission.breakdown = Breakdown(BreakdownRule.TOW, float(value))


def _put_fail_rate(variant: Variant, value: Value) -> None:
    variant.fail_rate = float(value)


# -- robots


def _variables(opened: OpenMission, robot: Robot) -> Iterator[Address]:
    own = {one.variable.name for one in opened.mission.variables if one.robot == robot.name}
    for part in robot.variables:
        bounds = part.minimum, part.maximum
        put = _initial(robot.name, part.name, part.name in own)
        yield Address(f"variable.{robot.name}.{part.name}", part.initial, put, *bounds, True, unit=part.unit)


def _initial(robot: str, name: str, is_own: bool) -> Put:
    def put(variant: Variant, value: Value) -> None:
        if not is_own:
            variant.change_part(robot, "variables", name, initial=int(value))
            return
        variables = variant.mission.variables
        for at, one in enumerate(variables):
            if one.robot == robot and one.variable.name == name:
                variables[at] = replace(one, variable=replace(one.variable, initial=int(value)))

    return put


def _settings(robot: Robot, part: RobotObject, category: Category) -> Iterator[Address]:
    device = simulated_devices(category).get(part.model)
    if device is None:
        return
    for setting in device.settings:
        current = part.settings.get(setting.name, setting.default)
        put = _setting(robot.name, f"{category.value}s", part, setting.name)
        name = f"device.{robot.name}.{part.name}.{setting.name}"
        if setting.words:
            yield Address(name, current, put, 1, 0, words=setting.words)
        elif setting.reads is None:
            yield Address(name, float(current), put, setting.least, setting.most, unit=setting.unit)


def _setting(robot: str, category: str, part: RobotObject, name: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        now = next(one for one in getattr(variant.robots[robot], category) if one.name == part.name)
        variant.change_part(robot, category, part.name, settings={**now.settings, name: str(value)})

    return put
