"""Booting on CPython what lands on boards: the very `main.py`, with a port of Python and the drivers of the tests.

Files of drivers are made up here, and fetch `tests.boards.drivers`; all else is what `Package` makes for boards with a
current MicroPython.
"""

from __future__ import annotations

import builtins
import gc
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import IO, Any

from kitrobot.deploy import Package, board_file, program_name, read_program_file
from kitrobot.deploy.carried import asked_file, short
from kitrobot.deploy.lying import StartLine
from kitrobot.deploy.package import MODULE, Built, name_of
from kitrobot.deploy.starting import start_file
from kitrobot_onboard.interpreter import tick
from kitrobot_onboard.link import checksum

PACKAGE = "c0ffee00"
PORT = ("ticks", "diff", "add", "read", "write", "tidy", "identify")
MICROPYTHON = SimpleNamespace(opt_level=lambda level: None, kbd_intr=lambda sign: None)


def boot(port: Any, folder: Path, program: bytes | None, generation: int) -> tuple[list[Any], Callable[[Any], None]]:
    """A robot that was started from a program file, and the loop that it is to be given to.

    `folder`: where the files of its board lie.
    """
    file = read_program_file(program) if program is not None else None
    built = _with_test_drivers(Package().built("machine", {}), list(file.drivers) if file is not None else [])
    data = board_file(file, built)
    name = program_name(program) if program is not None else "kp-"  # as robots have it that know drivers by their names
    line = StartLine(generation, built.interpreter, name, checksum(data))
    for path, content in {**built.files, name: data, "kr0": line.to_bytes()}.items():
        (folder / path).write_bytes(content)
    sys.modules.setdefault("micropython", MICROPYTHON)  # type: ignore[arg-type]
    sys.modules[built.interpreter] = SimpleNamespace(**{short()["tick"]: tick})  # type: ignore[assignment]

    def opened(path: str, mode: str = "r") -> IO[Any]:
        return builtins.open(folder / path, mode)

    space: dict[str, Any] = {"open": opened, "port": port}
    loading, _, running = built.main.decode().rpartition("\n")
    assert running.strip() == f"{short().get('run', 'run')}({short()['robot']})"
    # A board collects after each piece; here that would look at all that the tests have in memory.
    sys.modules["gc"] = SimpleNamespace(collect=lambda: None)  # type: ignore[assignment]
    try:
        exec(loading, space)
    finally:
        sys.modules["gc"] = gc
    return space[short()["robot"]], space[short().get("run", "run")]


def _with_test_drivers(built: Built, drivers: list[str]) -> Built:
    port = "\n".join(f"{short().get(name, name)}=port.{name}" for name in PORT).encode()
    texts = {
        driver: f"from tests.boards.drivers import driver as found\nmake=found({driver!r}).make".encode()
        for driver in drivers
    }
    files = dict(built.files) | {name_of(text) + ".py": text for text in (port, *texts.values())}
    loop = [name_of(port) + ".py", *built.loop[1:]]
    asked = name_of(asked_file(built.family)) + ".py"
    start = start_file(built.interpreter, [(name, len(files[name])) for name in loop], asked)
    name = name_of(start) + ".py"
    return replace(
        built,
        module=MODULE + PACKAGE,
        files={**files, name: start},
        start=name,
        loop=loop,
        drivers={driver: name_of(text) + ".py" for driver, text in texts.items()},
        wants_range=dict.fromkeys(texts, True),
    )
