"""Booting on CPython what lands on boards: the very `main.py`, with a port of Python and the drivers of the tests.

Files of drivers are made up here, and fetch `tests.boards.drivers`; all else is what `Package` makes for boards with a
current MicroPython.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from kitrobot.deploy.installation.boot_records import StartLine
from kitrobot.deploy.package.board_package import BoardPackage
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.content_names import MODULE, TEAM_DRIVER, name_of
from kitrobot.deploy.package.onboard_bundle import module_names, requests_file
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import program_name, read_program_file
from kitrobot.deploy.package.script import board_file
from kitrobot.deploy.package.start_script import start_file
from kitrobot_onboard.link import checksum
from tests.boards.started import START, started

PACKAGE = "c0ffee00"
PORT = ("ticks", "diff", "add", "read", "write", "tidy", "identify")


def boot(port: Any, folder: Path, program: bytes | None, generation: int) -> tuple[list[Any], Callable[[Any], None]]:
    """A robot that was started from a program file, and the loop that it is to be given to.

    `folder`: where the files of its board lie.
    """
    lay(folder, program, generation)
    return started(port, folder)


def lay(folder: Path, program: bytes | None, generation: int) -> None:
    """Puts into a folder what lies on a board with that program, and how it is started."""
    file = read_program_file(program) if program is not None else None
    drivers = list(file.drivers) if file is not None else []
    own = dict.fromkeys(driver for driver in drivers if driver == TEAM_DRIVER)
    built = _with_test_drivers(Package().build("machine", own, COMPILED_LOOP), drivers)
    data = board_file(file, built)
    name = program_name(program) if program is not None else "kp-"  # as robots have it that know drivers by their names
    line = StartLine(generation, built.interpreter, name, checksum(data))
    for path, content in {**built.files, name: data, "kr0": line.to_bytes()}.items():
        (folder / path).write_bytes(content)
    loading, _, running = built.main.decode().rpartition("\n")
    names = {
        "tick": module_names()["tick"],
        "robot": module_names()["robot"],
        "run": module_names().get("run", "run"),
    }
    assert running.strip() == f"{names['run']}({names['robot']})"
    start = {"interpreter": built.interpreter, "loading": loading, **names}
    (folder / START).write_text(json.dumps(start), encoding="utf-8")


def _with_test_drivers(built: BoardPackage, drivers: list[str]) -> BoardPackage:
    port = "\n".join(f"{module_names().get(name, name)}=port.{name}" for name in PORT).encode()
    texts = {
        driver: f"from tests.boards.drivers import driver as found\nmake=found({driver!r}).make".encode()
        for driver in drivers
    }
    files = dict(built.files) | {name_of(text) + ".py": text for text in (port, *texts.values())}
    loop = [name_of(port) + ".py", *built.loop[1:]]
    requests = name_of(requests_file(built.family)) + ".py"
    start = start_file(built.interpreter, [(name, len(files[name])) for name in loop], requests)
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
