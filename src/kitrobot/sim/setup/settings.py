"""A device's settings, read from the attributes of its object in a robot's XML."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from typing import NamedTuple

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives.robot import Category, Robot, RobotObject
from kitrobot.sim.devices import Actuator, Device, Sensor, Setting, Values, actuators, sensors
from kitrobot.sim.devices.base import MOVES_BOXES, DisplayKind, ManualControl
from kitrobot.sim.setup import rules
from kitrobot.text.phrases import one_of, shown
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.world.model import World

_OTHER_DEVICE = Sentence('say what stands for it, as in <simulate as="slider"/>, or let the robot run on a board only')


SIMULATED = (Category.ACTUATOR, Category.SENSOR)
"""The categories of parts that have a device."""


def simulated_devices(category: Category) -> Mapping[str, type[Device]]:
    """The simulator's devices for actuators, or for sensors, by name."""
    return actuators() if category is Category.ACTUATOR else sensors()


def moves_boxes(part: RobotObject) -> bool:
    """Whether an actuator moves boxes between a storehouse and a robot."""
    device = actuators().get(part.model)
    return device is not None and device.handles == MOVES_BOXES


def device_problems(robot: Robot, apart_from: Collection[tuple[Category, str]] = ()) -> list[Diagnostic]:
    """All that keeps a robot's actuators and sensors, but for some, from being simulated, whatever world it is in."""
    problems: list[Diagnostic] = []
    for part in (*robot.actuators, *robot.sensors):
        if (part.category, part.name) in apart_from:
            continue
        device, found = find_device(robot, part)
        problems += found
        if device is not None:
            problems += read_settings(part, device, f"{robot.name}.{part.name}")[1]
    return problems + read_conflicts(robot)


def find_device(robot: Robot, part: RobotObject) -> tuple[type[Device] | None, list[Diagnostic]]:
    """The bank for an actuator or sensor, and why there is none."""
    known = simulated_devices(part.category)
    device = known.get(part.model)
    where = f"{robot.name}.{part.name}"
    if device is None:
        message = Sentence(
            "{where}: expected a device of the simulator ({known}), found {found}",
            where,
            one_of(sorted(known)),
            shown(part.model),
        )
        help = did_you_mean(part.model, known) or _OTHER_DEVICE
        return None, [rules.DEVICE(message, part.place, help=help)]
    problems = []
    if issubclass(device, Actuator) and device.procedures:
        for method in part.methods:
            if method.name not in device.procedures:
                message = Sentence(
                    "{where}: the device {device} does {procedures}, not {method}",
                    where,
                    part.model,
                    one_of(sorted(device.procedures)),
                    method.name,
                )
                near = did_you_mean(method.name, device.procedures)
                problems.append(rules.DEVICE(message, method.place or part.place, help=near))
    assert issubclass(device, Actuator | Sensor)
    return device, problems


def read_settings(part: RobotObject, device: type[Device], where: str) -> tuple[Values, list[Diagnostic]]:
    """The settings of one device, with what the XML leaves out filled in, and what is wrong with them; `where` is the
    part's name in messages.
    """
    problems: list[Diagnostic] = []
    known = {setting.name: setting for setting in device.settings}
    values: dict[str, float | str] = {setting.name: setting.default for setting in device.settings}
    for name, text in part.settings.items():
        setting = known.get(name)
        if setting is None:
            message = Sentence("{where}: the device {device} has no setting {setting}", where, part.model, shown(name))
            problems.append(rules.DEVICE(message, part.place, help=did_you_mean(name, known)))
            continue
        value = _value(setting, text)
        if value is None:
            message = Sentence(
                "{where}: expected {expected} in {setting}, found {found}", where, _expected(setting), name, shown(text)
            )
            problems.append(rules.DEVICE(message, part.place, help=Sentence("{setting}: {help}", name, setting.help)))
        else:
            values[name] = value
    for setting in device.settings:
        if setting.required and setting.name not in part.settings:
            message = Sentence(
                "{where}: expected the setting {setting} of the device {device}, found none",
                where,
                setting.name,
                part.model,
            )
            problems.append(
                rules.DEVICE(message, part.place, help=Sentence("{setting}: {help}", setting.name, setting.help))
            )
    return Values(values), problems


def name_problems(
    robot: Robot, part: RobotObject, device: type[Device], values: Values, world: World, agents: Collection[str]
) -> list[Diagnostic]:
    """The settings of a device that name a place which the world does not have, or an agent who takes no part."""
    problems: list[Diagnostic] = []
    for setting in device.settings:
        if setting.names_agent and values.word(setting.name) not in agents:
            name = values.word(setting.name)
            message = Sentence("{robot}.{part}: no agent {name} takes part", robot.name, part.name, shown(name))
            help = did_you_mean(name, agents) or Sentence("those who do are {known}", one_of(sorted(agents)[:20]))
            problems.append(rules.DEVICE(message, part.place, help=help))
        if setting.names_place and values.word(setting.name) not in world.places:
            name = values.word(setting.name)
            message = Sentence(
                "{robot}.{part}: the world {world} has no storehouse, dock or start {name}",
                robot.name,
                part.name,
                world.name,
                shown(name),
            )
            help = did_you_mean(name, world.places) or Sentence("it has {known}", one_of(sorted(world.places)[:20]))
            problems.append(
                rules.DEVICE(message, part.place, help=help if world.places else Sentence("add one to the world"))
            )
    return problems


def length_of(robot: Robot) -> float:
    """How long a robot is, in mm, which is the diameter of one that moves freely; 0 for one without wheels."""
    longest = 0.0
    for part in robot.actuators:
        device = actuators().get(part.model)
        if device is not None and any(setting.name == "length" for setting in device.settings):
            longest = max(longest, read_settings(part, device, f"{robot.name}.{part.name}")[0].number("length"))
    return longest


class Appearance(NamedTuple):
    """How the arena shows a part: the look of an actuator; the hand of a sensor, what it reads at rest, and its ray."""

    look: DisplayKind = ""
    hand: ManualControl = ""
    resting: int = 0
    ray: tuple[float, float] | None = None


def appearance_of(part: RobotObject) -> Appearance:
    """How the page shows a part in the arena; of a part that cannot be simulated, nothing."""
    device = simulated_devices(part.category).get(part.model) if part.category in SIMULATED else None
    if device is None:
        return Appearance()
    values, _ = read_settings(part, device, part.name)
    if issubclass(device, Actuator):
        return Appearance(look=device.display_kind(values))
    assert issubclass(device, Sensor)
    return Appearance(hand=device.manual_control(values), resting=device.resting(values), ray=device.ray(values))


def read_conflicts(robot: Robot) -> list[Diagnostic]:
    """Which actuators of a robot cannot be on it together."""
    problems: list[Diagnostic] = []
    taken: dict[tuple[str, str], str] = {}
    for part in robot.actuators:
        where = f"{robot.name}.{part.name}"
        device = actuators().get(part.model)
        if device is None:
            continue
        other = next((one for one in robot.actuators if one.model in device.excludes), None)
        if other is not None:
            message = Sentence(
                "{where}: a robot with the device {device} cannot have {other}, the device {other_device}, too",
                where,
                part.model,
                other.name,
                other.model,
            )
            help = Sentence("take {part} or {other} out of the robot's XML", part.name, other.name)
            problems.append(rules.DEVICE(message, part.place, help=help))
        if device.differs_in:
            default = next(str(one.default) for one in device.settings if one.name == device.differs_in)
            value = part.settings.get(device.differs_in, default)
            first = taken.setdefault((part.model, value), part.name)
            if first != part.name:
                message = Sentence(
                    "{where}: expected another {setting} than that of {first}, found {found}",
                    where,
                    device.differs_in,
                    first,
                    shown(value),
                )
                problems.append(
                    rules.DEVICE(
                        message, part.place, help=Sentence("give each of them its own {setting}", device.differs_in)
                    )
                )
    return problems


def _value(setting: Setting, text: str) -> float | str | None:
    if setting.words:
        return text if text in setting.words else None
    if setting.reads is not None:
        return text if setting.reads(text) else None
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) and setting.least <= number <= setting.most else None


def _expected(setting: Setting) -> str:
    if setting.words:
        return one_of(setting.words)
    if setting.reads is not None:
        return setting.unit
    unit = f" {setting.unit}" if setting.unit else ""
    return Sentence("a number from {least} to {most}{unit}", f"{setting.least:g}", f"{setting.most:g}", unit)
