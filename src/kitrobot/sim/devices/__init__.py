"""The devices of the simulator: each module in this folder is one, found by looking, by the name robots' XML gives."""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache

from kitrobot.sim.devices.base import LATENCY, Actuator, Device, Sensor, Setting, Stage, Standing, Values

__all__ = [
    "LATENCY",
    "Actuator",
    "Device",
    "Sensor",
    "Setting",
    "Stage",
    "Standing",
    "Values",
    "actuators",
    "sensors",
]


@cache
def _all() -> tuple[type[Device], ...]:
    """Every class with a `name` in the modules of this package, in the order of their names."""
    found: list[type[Device]] = []
    for module in sorted(pkgutil.iter_modules(__path__), key=lambda module: module.name):
        for value in vars(importlib.import_module(f"{__name__}.{module.name}")).values():
            if isinstance(value, type) and issubclass(value, Device) and value.name and value not in found:
                found.append(value)
    return tuple(found)


@cache
def actuators() -> dict[str, type[Actuator]]:
    """Device name → bank, for what does something."""
    return {device.name: device for device in _all() if issubclass(device, Actuator)}


@cache
def sensors() -> dict[str, type[Sensor]]:
    """Device name → bank, for what measures."""
    return {device.name: device for device in _all() if issubclass(device, Sensor)}
