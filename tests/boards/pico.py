"""A Raspberry Pi Pico on this computer, with whatever firmware: its processor emulated by rp2040js (`rp2040/`).

It is as slow as it must be; who talks with it goes by its clock (`on_its_clock`).
"""

from __future__ import annotations

import pkgutil
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from mpremote import transport_serial

import kitrobot.deploy
from tests.boards.node_board import NodeBoard
from tools import page

HERE = Path(__file__).resolve().parent / "rp2040"
PWM = 4


class Pico(NodeBoard):
    """One with a firmware (a UF2 file) and a boot ROM, which are files."""

    def __init__(self, firmware: Path, bootrom: Path) -> None:
        page.install_modules()
        emulator = page.WEB / "node_modules" / "rp2040js" / "dist" / "esm" / "index.js"
        super().__init__(HERE / "board.mjs", emulator, {"firmware": str(firmware), "bootrom": str(bootrom)})

    def seconds(self) -> float:
        """On its clock."""
        return float(self._ask("time")["seconds"])

    def duty(self, pin: int) -> float:
        """The part of the time that a pin is on: what its wave says where it has one, else 0 or 1."""
        stands = self._ask("pins")["pins"][pin]
        return float(stands["duty"] if stands["function"] == PWM else stands["level"] == 1)

    @contextmanager
    def on_its_clock(self) -> Iterator[None]:
        """Whatever of `kitrobot.deploy` looks at the clock, or mpremote for it, looks at that of the board."""
        theirs = SimpleNamespace(**{**vars(time), "monotonic": self.seconds})
        names = [found.name for found in pkgutil.walk_packages(kitrobot.deploy.__path__, "kitrobot.deploy.")]
        modules: list[Any] = [transport_serial, *(sys.modules[name] for name in names if name in sys.modules)]
        with pytest.MonkeyPatch.context() as patch:
            for module in modules:
                if getattr(module, "time", None) is time:
                    patch.setattr(module, "time", theirs)
            yield
