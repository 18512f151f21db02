"""A device's settings, read from the attributes of its object in a robot's XML."""

from __future__ import annotations

import math
from collections.abc import Collection

from kitrobot.diagnostics import Diagnostic
from kitrobot.primitives import Category, Robot, RobotObject, did_you_mean, one_of, shown
from kitrobot.sim import rules
from kitrobot.sim.devices import Actuator, Device, Sensor, Setting, Values, actuators, sensors

_OTHER_DEVICE = "give it one of these, or let the robot run on a board only"


def simulated_devices(category: Category) -> Collection[str]:
    """The names of the simulator's devices for actuators, or for sensors."""
    return (actuators() if category is Category.ACTUATOR else sensors()).keys()


def device_problems(robot: Robot, apart_from: Collection[tuple[Category, str]] = ()) -> list[Diagnostic]:
    """All that keeps a robot's actuators and sensors, but for some, from being simulated, whatever world it is in."""
    problems: list[Diagnostic] = []
    for part in (*robot.actuators, *robot.sensors):
        if (part.category, part.name) in apart_from:
            continue
        device, found = find_device(robot, part)
        problems += found
        if device is not None:
            problems += read_settings(robot, part, device)[1]
    return problems + read_conflicts(robot)


def find_device(robot: Robot, part: RobotObject) -> tuple[type[Device] | None, list[Diagnostic]]:
    """The bank for an actuator or sensor, and why there is none."""
    known: dict[str, type[Device]] = dict(actuators() if part.category is Category.ACTUATOR else sensors())
    device = known.get(part.device)
    where = f"{robot.name}.{part.name}"
    if device is None:
        message = f"{where}: expected a device of the simulator ({one_of(sorted(known))}), found {shown(part.device)}"
        help = did_you_mean(part.device, known) or _OTHER_DEVICE
        return None, [rules.DEVICE(message, part.place, help=help)]
    problems = []
    if issubclass(device, Actuator):
        for method in part.methods:
            if method.name not in device.procedures:
                message = (
                    f"{where}: the device {part.device} does {one_of(sorted(device.procedures))}, not {method.name}"
                )
                help = did_you_mean(method.name, device.procedures)
                problems.append(rules.DEVICE(message, method.place or part.place, help=help))
    assert issubclass(device, Actuator | Sensor)
    return device, problems


def read_settings(robot: Robot, part: RobotObject, device: type[Device]) -> tuple[Values, list[Diagnostic]]:
    """The settings of one device, with what the XML leaves out filled in, and what is wrong with them."""
    where = f"{robot.name}.{part.name}"
    problems: list[Diagnostic] = []
    known = {setting.name: setting for setting in device.settings}
    values: dict[str, float | str] = {setting.name: setting.default for setting in device.settings}
    for name, text in part.settings.items():
        setting = known.get(name)
        if setting is None:
            message = f"{where}: the device {part.device} has no setting {shown(name)}"
            problems.append(rules.DEVICE(message, part.place, help=did_you_mean(name, known)))
            continue
        value = _value(setting, text)
        if value is None:
            message = f"{where}: expected {_expected(setting)} in {name}, found {shown(text)}"
            problems.append(rules.DEVICE(message, part.place, help=f"{name}: {setting.help}"))
        else:
            values[name] = value
    return Values(values), problems


def length_of(robot: Robot) -> float:
    """How long a robot is, in mm, which is the diameter of one that moves freely; 0 for one without wheels."""
    longest = 0.0
    for part in robot.actuators:
        device = actuators().get(part.device)
        if device is not None and any(setting.name == "length" for setting in device.settings):
            longest = max(longest, read_settings(robot, part, device)[0].number("length"))
    return longest


def read_conflicts(robot: Robot) -> list[Diagnostic]:
    """Which actuators of a robot cannot be on it together."""
    problems: list[Diagnostic] = []
    taken: dict[tuple[str, str], str] = {}
    for part in robot.actuators:
        where = f"{robot.name}.{part.name}"
        device = actuators().get(part.device)
        if device is None:
            continue
        other = next((one for one in robot.actuators if one.device in device.excludes), None)
        if other is not None:
            message = (
                f"{where}: a robot with the device {part.device} cannot have {other.name}, "
                f"the device {other.device}, too"
            )
            help = f"take {part.name} or {other.name} out of the robot's XML"
            problems.append(rules.DEVICE(message, part.place, help=help))
        if device.differs_in:
            default = next(str(one.default) for one in device.settings if one.name == device.differs_in)
            value = part.settings.get(device.differs_in, default)
            first = taken.setdefault((part.device, value), part.name)
            if first != part.name:
                message = f"{where}: expected another {device.differs_in} than that of {first}, found {shown(value)}"
                problems.append(
                    rules.DEVICE(message, part.place, help=f"give each of them its own {device.differs_in}")
                )
    return problems


def _value(setting: Setting, text: str) -> float | str | None:
    if setting.words:
        return text if text in setting.words else None
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) and setting.least <= number <= setting.most else None


def _expected(setting: Setting) -> str:
    if setting.words:
        return one_of(setting.words)
    unit = f" {setting.unit}" if setting.unit else ""
    return f"a number from {setting.least:g} to {setting.most:g}{unit}"
