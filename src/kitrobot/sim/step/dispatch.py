"""Calls the functions of every device's module (see devices.base), in the order of their kinds.

Nobody keeps a list: the functions here are written from the modules of `devices`, and run by CPython and Numba alike,
for which a call must name one function. `SOURCE` is what is written.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from typing import Any

from kitrobot.sim.devices import Command, Device, actuators, sensors
from kitrobot.sim.tables.columns import A_DONE, A_KIND
from kitrobot.sim.tables.state import State

_ACTUATORS = tuple(actuators().values())
_SENSORS = tuple(sensors().values())

KINDS = _ACTUATORS
"""The kinds of actuators, by number."""

DRIVES = tuple(1 if device.drives else 0 for device in _ACTUATORS)
"""Of each kind of actuator, whether what it does is the motion of its robot."""

AGREES = tuple(1 if device.agrees else 0 for device in _ACTUATORS)
"""Of each kind of actuator, whether what it is told changes nothing but what robots of a team agree on."""


def _having(name: str, devices: tuple[type[Device], ...]) -> Iterator[tuple[type[Device], str]]:
    """The devices whose modules have a function of this name, and how that is called here."""
    for device in devices:
        if hasattr(sys.modules[device.__module__], name):
            yield device, f"{name}_{device.__module__.rpartition('.')[2]}"


def _for_banks(name: str, group: str, time: str, devices: tuple[type[Device], ...]) -> str:
    lines = [f"def {name}_all({time}, state):", f"    bank = state.{group}.bank"]
    for device, function in _having(name, devices):
        kind = device.kind
        lines.append(f"    if bank[{kind}] < bank[{kind + 1}]:")
        lines.append(f"        {function}(bank[{kind}], bank[{kind + 1}], {time}, state)")
    return "\n".join(lines)


def _for_one(name: str, arguments: str, otherwise: str) -> str:
    lines = [f"def {name}({arguments}):", f"    kind = state.actuators.ints[{A_KIND}][k]"]
    for device, function in _having(name, _ACTUATORS):
        lines += [f"    if kind == {device.kind}:", f"        return {function}({arguments})"]
    return "\n".join([*lines, f"    return {otherwise}"])


SOURCE = "\n\n\n".join(
    (
        _for_banks("sense", "sensors", "step", _SENSORS),
        _for_banks("advance", "actuators", "dt", _ACTUATORS),
        _for_one("start", "k, command, deviate, state", "None"),
        _for_one("is_busy", "k, state", f"state.actuators.ints[{A_DONE}][k] == 0"),
    )
)


def _made() -> dict[str, Any]:
    names: dict[str, Any] = {"__name__": __name__}
    for name in ("sense", "start", "advance", "is_busy"):
        for device, function in _having(name, (*_SENSORS, *_ACTUATORS)):
            names[function] = getattr(sys.modules[device.__module__], name)
    exec(compile(SOURCE, "<dispatch>", "exec"), names)
    return names


_NAMES = _made()

sense_all: Callable[[int, State], None] = _NAMES["sense_all"]
"""Measures with every sensor."""

advance_all: Callable[[float, State], None] = _NAMES["advance_all"]
"""Goes on for a step of so many seconds with every actuator."""

start: Callable[[int, Command, float, State], None] = _NAMES["start"]
"""Actuator k begins to do what a command says; the number is a normal deviate, for its noise."""

is_busy: Callable[[int, State], bool] = _NAMES["is_busy"]
"""Whether actuator k will change something without a new command."""
