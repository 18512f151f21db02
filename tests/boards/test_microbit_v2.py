"""A micro:bit V2 is never taken for one of 2016, though both call their platform `microbit`.

No V2 is emulated here: a current MicroPython poses as one, as its sources have it (`micropython-microbit-v2`:
`os.uname()` names the chip nRF52833; a serial line `microbit.uart`, no `sys.stdin`). It has no memory of an nRF51 and
no block of code in flash, so what is done for the board of 2016 would fail there.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import pytest

from kitrobot.deploy.errors import SilentError
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.workspace.mission_loader import open_mission
from tests.boards.modern import ModernBoard, greet_until, onboard_files
from tests.verifier.check_fixtures import EXAMPLES
from tools.microbit_kits import programs, small_kits

BOOT = b"""
import os, sys

class Sys:
    platform = "microbit"
    implementation = sys.implementation
    modules = sys.modules
    path = sys.path
    print_exception = sys.print_exception
    real = sys

os.uname = lambda: ("microbit", "microbit", "2.1.2", "micro:bit v2.1.2", "micro:bit with CHIP")
sys.modules["sys"] = Sys
"""
SERIAL = b"""
import sys, time
from select import POLLIN, poll
real = sys.real
line = poll()
line.register(real.stdin, POLLIN)

def sleep(ms):
    time.sleep_ms(ms)

def running_time():
    return time.ticks_ms()

class Uart:
    def any(self):
        return bool(line.poll(0))

    def read(self, count=1):
        return real.stdin.buffer.read(count) if line.poll(0) else None

    def write(self, data):
        return real.stdout.buffer.write(data)

uart = Uart()
"""
"""What is added to a module `microbit` that only remembers: its serial line and its clock."""


def board(
    chip: str,
    version: tuple[int, ...] = (),
    files: Mapping[str, bytes] = MappingProxyType({}),
    more: bytes = b"",
) -> ModernBoard:
    """One with that chip. `version`: what it says that the version of its MicroPython is; none: which it is. `files`:
    what is on it already. `more`: what is added to its module `microbit`.
    """
    known = onboard_files()
    pins = {name: known[name] for name in ("machine.py", "music.py", "neopixel.py")}
    boot = BOOT.replace(b"CHIP", chip.encode())
    if version:
        boot = boot.replace(b"implementation = sys.implementation", f"implementation = ('', {version})".encode())
    utime = b"from time import *\n"
    microbit = known["microbit.py"] + SERIAL + more
    return ModernBoard({**pins, **files, "boot.py": boot, "microbit.py": microbit, "utime.py": utime})


def goes_on(link: Board) -> None:
    """Waits until the robot has done some ticks more."""
    first = link.greet().tick
    greet_until(link, lambda hello: hello.tick > first + 5)


def test_it_gets_the_whole_loop_in_its_memory_and_drives() -> None:
    ((_, program),) = programs(open_mission(EXAMPLES / "square" / "square.krt"), small_kits()["cutebot"])
    with board("nRF52833") as v2:
        done = deploy(v2.address, program.file.to_bytes(), program.package, replace=True)
        assert done.program in program.called, "it is known again"
        assert any(name.endswith(".py") for name in done.sent_files)
        with connect(v2.address, 20) as link:
            goes_on(link)
            link.stop()
            assert link.last_fault() is None


@pytest.mark.parametrize(("chip", "is_2016"), [("nRF52833", False), ("nRF51822", True)])
def test_its_chip_tells_it_from_that_of_2016(chip: str, is_2016: bool) -> None:
    with board(chip) as found:
        line = Line(found.address)
        try:
            receiver = Receiver(RawRepl(line))
            if is_2016:
                # What goes to the flash of an nRF51 finds none here.
                with pytest.raises(SilentError):
                    receiver.begin()
            else:
                receiver.begin()
                receiver.end()
            assert (receiver.family, receiver.is_2016) == ("microbit", is_2016)
        finally:
            line.close()
