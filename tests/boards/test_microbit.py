"""The micro:bit of 2016, its real firmware in QEMU: what it can do, and what it is told that it cannot.

Its memory does not hold the loop of a robot yet (docs/reference/boards.md). It runs the very `tick`, tick by tick as
`Machine` does; files reach it whole over a bad line; and who sends it a program is told why that is not possible.
"""

from __future__ import annotations

import contextlib
import os
import random
import re
import subprocess
import sys
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path

import pytest

from kitrobot.deploy import Line, RawRepl, Receiver
from kitrobot.deploy.errors import SilentError
from kitrobot.deploy.shortening import parsed, shortened
from kitrobot.diagnostics import KitRobotError
from kitrobot.image import Image, Machine
from kitrobot.workspace import find_robot
from tests.boards.bench import PROGRAMS, bench_program
from tests.boards.proxy import Proxy, noise
from tests.boards.qemu import Emulated

pytestmark = pytest.mark.boards

TICKS = 400 if os.environ.get("KITROBOT_THOROUGH") else 60
MAIN = "from kri import tick\nexec(open('run').read())\n"
"""First the tick, while there is room to compile it."""

RUN = """
cells = {cells!r}
threads = {threads!r}
pars = {pars!r}
out = {out!r}
code = open('code', 'rb').read()
f = open('inputs', 'rb')
while True:
    r = f.read({width})
    if not r:
        break
    for i in range({width}):
        cells[1 + i] = r[i]
    tick(code, cells, threads, pars, out, ())
    print(out, threads, cells[0])
print('done')
"""


@contextlib.contextmanager
def receiving(address: str) -> Iterator[Receiver]:
    """The receiver on a board, for as long as the line is open."""
    line = Line(address)
    try:
        receiver = Receiver(RawRepl(line))
        receiver.begin()
        yield receiver
    finally:
        line.close()


def put(address: str, content: bytes) -> None:
    with receiving(address) as receiver:
        receiver.write("data", content)


def restarted(line: Line) -> str:
    """What `main.py` prints."""
    line.write(b"\x03\x02")
    line.read_until(b">>> ", 10)
    line.write(b"\x04")
    return line.read_until(b">>> ", 120).decode(errors="replace").replace("\r\n", "\n")


def test_the_same_tick_gives_the_same_in_every_tick(microbit: Emulated, tmp_path: Path) -> None:
    interpreter = files("kitrobot_onboard").joinpath("interpreter.py").read_text(encoding="utf-8")
    with receiving(microbit.address) as receiver:
        receiver.write("kri.py", shortened(parsed(interpreter, "interpreter.py")).encode())
        receiver.write("main.py", MAIN.encode())
        for number, text in enumerate(PROGRAMS):
            image = Image.from_bytes(bench_program(tmp_path, text).file.image)
            machine = Machine(image, find_robot(str(tmp_path / "bench.robot.xml")))
            run = RUN.format(
                cells=machine.cells, threads=machine.threads, pars=machine.pars, out=machine.out, width=image.inputs
            )
            chance = random.Random(number)
            inputs, expected = b"", []
            for _ in range(TICKS):
                values = [chance.randrange(101) if chance.random() < 0.5 else 1 for _ in range(image.inputs)]
                inputs += bytes(values)
                machine.cells[1 : 1 + image.inputs] = values
                machine.tick()
                expected.append(f"{list(machine.out)} {list(machine.threads)} {machine.cells[0]}")
            if number:
                receiver.begin()
            for name, content in (("run", run.encode()), ("code", bytes(machine.code)), ("inputs", inputs)):
                receiver.write(name, content)
            receiver.end()
            printed = restarted(receiver.line)
            assert re.findall(r"^\[.*$", printed, re.M) == expected, printed[-500:]


def test_files_arrive_whole_over_a_line_that_loses_changes_and_adds_bytes(microbit: Emulated) -> None:
    content = bytes(random.Random(3).randrange(256) for _ in range(1500))
    for seed in range(20):
        with Proxy(microbit.port, disturb=noise(seed, 0.001)) as proxy, contextlib.suppress(SilentError):
            put(proxy.address, content)
            break
    with receiving(microbit.address) as receiver:
        assert receiver.read("data") == content


def test_a_line_that_is_cut_at_any_tenth_message_needs_only_another_try(microbit: Emulated) -> None:
    content = bytes(random.Random(4).randrange(256) for _ in range(400))
    cut = messages = 0
    while cut <= messages:
        with Proxy(microbit.port, cut_after=cut) as proxy, contextlib.suppress(KitRobotError):
            put(proxy.address, content)
        with Proxy(microbit.port) as proxy:
            put(proxy.address, content)
            messages = proxy.messages
        cut += 10
    with receiving(microbit.address) as receiver:
        assert receiver.read("data") == content


def test_who_sends_it_a_program_is_told_that_it_has_too_little_memory(microbit: Emulated, tmp_path: Path) -> None:
    (tmp_path / "heart.lll").write_text("Display.Image(0);")
    command = [sys.executable, "-m", "kitrobot", "deploy", str(tmp_path / "heart.lll"), "--robot", "microbit"]
    said = subprocess.run([*command, "--to", microbit.address], capture_output=True, text=True, timeout=120)
    assert said.returncode == 1
    assert "bytes of memory free, and the loop of a robot needs" in " ".join((said.stdout + said.stderr).split())
    with receiving(microbit.address) as receiver:
        assert receiver.names() == []
