"""Drivers of a board without hardware, and some that go wrong as the real ones do.

`stores` takes every command, `zero` reads its setting `value` (else 0). What takes longer is done when it is asked the
first time. The faulty ones raise in the method that their setting `on` names, or (`stuck`) are never done.
"""

from __future__ import annotations

from types import SimpleNamespace

from kitrobot_onboard.drivers.any.team import make as make_team

log: list[tuple[str, object]] = []
"""What the drivers of this process were told, in order."""


class Stores:
    """An actuator."""

    def __init__(self, settings: dict[str, str]) -> None:
        self.settings = settings

    def do(self, procedure: str, arguments: list[int]) -> None:
        log.append((procedure, list(arguments)))

    def done(self) -> bool:
        return True

    def stop(self) -> None:
        log.append(("stop", self.settings.get("pin", "")))


class Zero:
    """A sensor."""

    def __init__(self, settings: dict[str, str]) -> None:
        self.value = int(settings.get("value", "0"))

    def read(self) -> int:
        return self.value


class Stuck(Stores):
    """An actuator that is never done."""

    def done(self) -> bool:
        return False


class Broken(Stores):
    """A device that raises where `on` says."""

    def fail(self, where: str) -> None:
        if self.settings["on"] == where:
            error = {"memory": MemoryError, "os": OSError}.get(self.settings.get("error", ""), ValueError)
            raise error("on fire")

    def do(self, procedure: str, arguments: list[int]) -> None:
        super().do(procedure, arguments)
        self.fail("do")

    def done(self) -> bool:
        self.fail("done")
        return False

    def stop(self) -> None:
        super().stop()
        self.fail("stop")

    def read(self) -> int:
        self.fail("read")
        return 0


ACTUATORS = (
    "stores",
    "unused",
    "display",
    "music",
    "pin-out",
    "led",
    "servo",
    "pwm-motor",
    "drive",
    "door",
    "lamp",
    "turn",
    "indicator",
    "arm",
)
SENSORS = ("zero", "key", "accelerometer", "pin-in", "random", "ultrasonic", "line", "range", "ground")
_KINDS: dict[str, type] = {
    **dict.fromkeys(ACTUATORS, Stores),
    **dict.fromkeys(SENSORS, Zero),
    "stuck": Stuck,
    "broken": Broken,
}


def driver(name: str) -> SimpleNamespace:
    """What a board gets when it imports a driver; ImportError when there is none of that name."""
    if name == "team":
        return SimpleNamespace(make=make_team)
    if name not in _KINDS:
        raise ImportError(f"no module named '{name}'")
    return SimpleNamespace(make=_KINDS[name])
