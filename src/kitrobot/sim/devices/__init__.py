"""The devices of the simulator: each module in this folder is one, found by looking, by the name robots' XML gives."""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache

from kitrobot.sim.devices.base import (
    Actuator,
    Command,
    Device,
    DisplayKind,
    ManualControl,
    Placement,
    Sensor,
    Setting,
    Values,
    ticks,
)

__all__ = [
    "Actuator",
    "Command",
    "Device",
    "DisplayKind",
    "ManualControl",
    "Placement",
    "Sensor",
    "Setting",
    "Values",
    "actuators",
    "sensors",
    "ticks",
]


@cache
def _all() -> tuple[type[Device], ...]:
    """Every class with a `name` in the modules of this package, in the order of their names."""
    found: list[type[Device]] = []
    for module in sorted(pkgutil.iter_modules(__path__), key=lambda module: module.name):
        for value in vars(importlib.import_module(f"{__name__}.{module.name}")).values():
            if isinstance(value, type) and issubclass(value, Device) and value.name and value not in found:
                found.append(value)
    found.sort(key=lambda device: device.name)
    for category in (Actuator, Sensor):
        for number, device in enumerate(device for device in found if issubclass(device, category)):
            device.kind = number
    return tuple(found)


@cache
def actuators() -> dict[str, type[Actuator]]:
    """Device name → what it is, for what does something; in the order of their kinds."""
    return {device.name: device for device in _all() if issubclass(device, Actuator)}


@cache
def sensors() -> dict[str, type[Sensor]]:
    """Device name → what it is, for what measures; in the order of their kinds."""
    return {device.name: device for device in _all() if issubclass(device, Sensor)}
