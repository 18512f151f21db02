"""A driver that never returns: the board starts what it had before when its power comes on, or its prompt is free."""

from __future__ import annotations

from pathlib import Path
from threading import Event, Thread
from typing import Any

import pytest

from kitrobot.deploy.errors import SilentError
from kitrobot.deploy.installation import program_start
from kitrobot.deploy.installation.boot_records import TRIAL
from kitrobot.deploy.installation.deployment import DeployResult, deploy
from kitrobot.deploy.line import repl
from kitrobot.deploy.line.handshake import connect
from kitrobot.robots.program import BoardProgram
from tests.boards.bench import ONE, OTHER, bench_program
from tests.boards.qemu import Emulated
from tests.boards.test_deploy import files_of, put, runs, write
from tests.patience import PATIENCE_S

FOREVER = "from utime import sleep_ms\n        while True:\n            sleep_ms(1000)"
"""As a driver that waits for a chip; with Ctrl+C nobody ends it: a board that starts hears none."""
HANGS = {
    "while it is made": ("settings):\n        self", f"settings):\n        {FOREVER}\n        self"),
    "at its first command": ("arguments):\n        pass", f"arguments):\n        {FOREVER}"),
}


@pytest.fixture(autouse=True)
def _whoever_presses_reset_takes_the_time_of_a_busy_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(repl, "RESET_S", float(PATIENCE_S))


def hanging_program(folder: Path, where: str) -> BoardProgram:
    """A program one of whose drivers never comes back."""
    program = bench_program(folder, OTHER, "hangs")
    path = folder / "stores.driver.py"
    before = path.read_text(encoding="utf-8")
    path.write_text(before.replace(*HANGS[where]), encoding="utf-8")
    assert path.read_text(encoding="utf-8") != before
    return program


def hangs(address: str, program: BoardProgram, monkeypatch: pytest.MonkeyPatch) -> str:
    """Puts a program onto a board that hangs then; what is said of that."""
    with monkeypatch.context() as patch:
        patch.setattr(program_start, "STARTING_S", 2.0)  # it never starts, however long it is waited for
        patch.setattr(repl, "RESET_S", 2.0)  # nobody presses its button
        with pytest.raises(SilentError) as error:
            put(address, program)
    return f"{error.value.message}; {error.value.help}"


def test_a_driver_that_never_returns_costs_one_power_cut(
    board: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = put(board.address, bench_program(tmp_path))
    with connect(board.address, PATIENCE_S) as found:
        found.keep()  # it is answered also when there is nothing on trial
    assert TRIAL not in files_of(board.address), "what did its first ticks is confirmed"
    for where in HANGS:
        said = hangs(board.address, hanging_program(tmp_path, where), monkeypatch)
        assert "a driver may never return" in said
        assert "what it had before" in said
        for _ in range(2):
            board.cut_power()
            assert runs(board.address) == first.program, where
    second = put(board.address, bench_program(tmp_path, ONE, "mended"))
    board.cut_power()
    assert runs(board.address) == second.program
    assert TRIAL not in files_of(board.address)
    what_hangs_after_its_trial_is_taken_off_by_its_prompt_when_the_power_comes_on(board, tmp_path)


def test_a_first_program_that_never_returns_leaves_the_prompt_after_one_power_cut(
    board: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = hangs(board.address, hanging_program(tmp_path, "while it is made"), monkeypatch)
    assert "its prompt is free then" in said
    board.cut_power()
    done = put(board.address, bench_program(tmp_path, ONE, "mended"))
    assert runs(board.address) == done.program


UNPLUGGED = """import os
from utime import sleep_ms


def make(settings):
    while "unplugged" in os.listdir():
        sleep_ms(100)
    return lambda: 0
"""


PRESS_S = 10.0
"""So often somebody presses the reset button of a board that is asked for it: a busy machine may miss the moment."""


def freed_by_its_prompt(board: Any, folder: Path) -> DeployResult:
    """Puts a program onto a board that hangs whenever it starts: its power is cut while that is asked for."""
    wanted, over = Event(), Event()
    found: list[DeployResult | BaseException] = []
    program = bench_program(folder, ONE, "mended")

    def progress(stage: str, done: int, total: int) -> None:
        if stage == "reset":
            wanted.set()
        elif stage == "compare":
            over.set()

    def send() -> None:
        try:
            found.append(deploy(board.address, program.file.to_bytes(), program.package, progress))
        except BaseException as error:
            found.append(error)
        wanted.set()
        over.set()

    thread = Thread(target=send)
    thread.start()
    assert wanted.wait(PATIENCE_S)
    # A slow board may still be at its prompt from the power that came before.
    while not over.is_set():
        board.cut_power()
        over.wait(PRESS_S)
    thread.join()
    assert isinstance(found[0], DeployResult), found[0]
    return found[0]


def what_hangs_after_its_trial_is_taken_off_by_its_prompt_when_the_power_comes_on(board: Any, folder: Path) -> None:
    confirmed_and_hanging(board, folder)
    done = freed_by_its_prompt(board, folder)
    assert runs(board.address) == done.program


def confirmed_and_hanging(board: Any, folder: Path) -> None:
    """Puts a program onto a board that is confirmed, and hangs at once from then on: as a sensor that was unplugged."""
    program = bench_program(folder, OTHER, "hangs")
    path = folder / "zero.driver.py"
    path.write_text(UNPLUGGED)
    put(board.address, program)
    with connect(board.address, PATIENCE_S) as found:
        found.quit()
    write(board.address, "unplugged", b"x")
    board.cut_power()


@pytest.mark.boards
@pytest.mark.thorough("the other tests of this file, on a current MicroPython")
def test_on_a_micro_bit_of_2016_what_never_returns_costs_one_power_cut_and_its_prompt_is_reachable(
    microbit: Emulated, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = put(microbit.address, bench_program(tmp_path))
    with connect(microbit.address, PATIENCE_S) as found:
        found.keep()
    hangs(microbit.address, hanging_program(tmp_path, "at its first command"), monkeypatch)
    microbit.cut_power()
    assert runs(microbit.address) == first.program
    confirmed_and_hanging(microbit, tmp_path)
    done = freed_by_its_prompt(microbit, tmp_path)
    assert runs(microbit.address) == done.program
