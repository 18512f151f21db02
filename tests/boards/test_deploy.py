"""A program is put onto boards: what is sent, what stays, and what happens when the line is cut or disturbed."""

from __future__ import annotations

import contextlib
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy.errors import BoardError, LineError
from kitrobot.deploy.installation.deployment import DeployResult, deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.robots.program import BoardProgram
from tests.boards.bench import ONE, OTHER, bench_program
from tests.boards.proxy import Proxy, noise
from tests.effort import THOROUGH
from tests.patience import PATIENCE_S

pytestmark = pytest.mark.usefixtures("patient_host")

EVERY = 1 if THOROUGH else 100
SEEDS = range(20 if THOROUGH else 1)
"""In the thorough profile every single message is cut, and many seeds are tried; else one of 100, and one."""


def put(address: str, program: BoardProgram, *, replace: bool = False, fresh: bool = False) -> DeployResult:
    return deploy(address, program.file.to_bytes(), program.package, replace=replace, fresh=fresh)


def runs(address: str) -> str:
    """The program that runs on a board."""
    with connect(address, PATIENCE_S) as board:
        assert board.hello.state == 2
        return board.hello.program


def port_of(address: str) -> int:
    return int(address.rpartition(":")[2])


def files_of(address: str) -> dict[str, bytes]:
    """What lies on a board, read over its line."""
    line = Line(address)
    try:
        receiver = Receiver(RawRepl(line))
        receiver.begin()
        return {name: receiver.read(name) for name in receiver.names()}
    finally:
        line.close()


def write(address: str, name: str, content: bytes) -> None:
    """Puts a file of somebody else onto a board."""
    line = Line(address)
    try:
        receiver = Receiver(RawRepl(line))
        receiver.begin()
        receiver.write(name, content)
        receiver.end()
    finally:
        line.close()


def test_an_empty_board_gets_all_of_it_and_runs(board: Any, tmp_path: Path) -> None:
    program = bench_program(tmp_path)
    done = put(board.address, program)
    assert program.is_called(done.program)
    assert done.hello.state == 2
    assert done.generation == 1
    assert done.kept_files == ()
    assert done.free > 300
    assert runs(board.address) == done.program
    it_starts_by_itself_when_the_power_comes_on(board, done)
    a_deploy_that_broke_off_needs_no_reset_to_start_it(board, done)
    at_the_prompt_it_is_started(board, done)


def it_starts_by_itself_when_the_power_comes_on(board: Any, done: DeployResult) -> None:
    board.cut_power()
    assert runs(board.address) == done.program


def a_deploy_that_broke_off_needs_no_reset_to_start_it(board: Any, done: DeployResult) -> None:
    line = Line(board.address)
    Receiver(RawRepl(line)).begin()
    line.close()
    assert runs(board.address) == done.program


def at_the_prompt_it_is_started(board: Any, done: DeployResult) -> None:
    with connect(board.address, PATIENCE_S) as found:
        found.quit()
    assert runs(board.address) == done.program


def test_an_update_sends_only_what_differs(board: Any, tmp_path: Path) -> None:
    first = put(board.address, bench_program(tmp_path))
    second = put(board.address, bench_program(tmp_path, OTHER))
    assert second.sent_files == (f"kp{second.program}",)
    assert set(second.kept_files) == {name for name in first.sent_files if name.endswith(".py")} - {"main.py"}
    assert second.generation == 2
    again = put(board.address, bench_program(tmp_path, OTHER))
    assert again.sent_files == ()
    assert again.generation == 2
    assert runs(board.address) == second.program


def test_what_nobody_names_any_more_is_removed_by_the_next_installation(board: Any, tmp_path: Path) -> None:
    write(board.address, "mine.txt", b"of the user")
    for mark, text in (("a", ONE), ("b", OTHER), ("c", ONE), ("d", OTHER)):
        put(board.address, bench_program(tmp_path, text, mark))
    names = set(files_of(board.address))
    assert {"mine.txt", "main.py", "kr0", "kr1"} <= names
    programs = [name for name in names if name.startswith("kp")]
    assert len(programs) == 2
    package = bench_program(tmp_path, OTHER, "d")
    modules = {name for name in names if name.endswith(".py")} - {"main.py"}
    assert (
        len(modules) == len(package.package.build("machine", package.file.drivers, COMPILED_LOOP).files) + 1
    )  # the driver before


def test_a_main_of_somebody_else_is_only_overwritten_when_asked(board: Any, tmp_path: Path) -> None:
    write(board.address, "main.py", b"print('mine')\n")
    with pytest.raises(BoardError, match=r"main\.py"):
        put(board.address, bench_program(tmp_path))
    assert files_of(board.address)["main.py"] == b"print('mine')\n"
    done = put(board.address, bench_program(tmp_path), replace=True)
    assert runs(board.address) == done.program


def test_a_file_that_was_spoilt_is_sent_again_and_what_would_not_start_leaves_what_was_there(
    board: Any, tmp_path: Path
) -> None:
    first = put(board.address, bench_program(tmp_path))
    a_file_that_was_spoilt_is_sent_again(board, first, tmp_path)
    a_board_that_would_not_start_it_goes_on_with_what_it_had(board, first, tmp_path)


def a_file_that_was_spoilt_is_sent_again(board: Any, first: DeployResult, tmp_path: Path) -> None:
    spoilt = next(name for name in first.sent_files if name.endswith(".py"))
    content = files_of(board.address)[spoilt]
    write(board.address, spoilt, content[: len(content) // 2])
    again = put(board.address, bench_program(tmp_path))
    assert again.sent_files == (spoilt,)
    assert runs(board.address) == first.program


def a_board_that_would_not_start_it_goes_on_with_what_it_had(board: Any, first: DeployResult, tmp_path: Path) -> None:
    program = bench_program(tmp_path, OTHER, "two")
    (tmp_path / "stores.driver.py").write_text("def make(settings):\n    raise OSError('no such pin')\n")
    with pytest.raises(BoardError, match="no such pin"):
        put(board.address, program)
    assert runs(board.address) == first.program
    board.cut_power()
    assert runs(board.address) == first.program


def test_a_deploy_that_is_cut_leaves_what_was_there_and_the_next_one_mends_it(board: Any, tmp_path: Path) -> None:
    def made(number: int) -> BoardProgram:
        """A program whose program file and driver are others than those of the two before, which a board keeps."""
        return bench_program(tmp_path, (ONE, OTHER, ONE + "WAIT(7);" * 40)[number % 3], f"number {number % 3}" * 20)

    put(board.address, made(0))
    with Proxy(port_of(board.address)) as whole:
        put(whole.address, made(1))
        count = whole.messages
    stayed = 0
    running = 1
    for cut in range(EVERY, count, EVERY):
        old, new = made(running).called, made(running + 1)
        with Proxy(port_of(board.address), cut_after=cut) as wire, contextlib.suppress(LineError):
            put(wire.address, new)
        board.cut_power()
        found = runs(board.address)
        assert found in old or new.is_called(found), f"cut after message {cut}"
        stayed += found in old
        assert new.is_called(put(board.address, new).program)
        assert new.is_called(runs(board.address))
        running += 1
    # Only what comes after the line that counts may be cut without a loss: the restart and the greeting.
    assert stayed >= len(range(EVERY, count, EVERY)) - 3


def test_a_board_that_restarts_during_a_deploy_is_entered_again_while_the_line_stays_open(
    board: Any, tmp_path: Path
) -> None:
    def made(number: int) -> BoardProgram:
        return bench_program(tmp_path, (ONE, OTHER)[number % 2], f"number {number % 2}" * 20)

    put(board.address, made(0), fresh=True)
    with Proxy(port_of(board.address)) as whole:
        put(whole.address, made(1))
        count = whole.messages
    for number, at in enumerate(range(EVERY // 2, count, EVERY)):
        new = made(number)
        cut = partial(lambda wanted, messages: board.cut_power() if messages == wanted else None, at)
        with Proxy(port_of(board.address), happens=cut) as wire:
            assert new.is_called(put(wire.address, new).program), f"after message {at}"
        assert new.is_called(runs(board.address))


def test_a_receiver_without_room_to_read_a_request_is_begun_anew(
    board: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    value = Receiver.value
    times = iter([True])

    def crowded(receiver: Receiver, expression: str, timeout_s: float = 2.0) -> bytes:
        if expression.startswith("z(") and next(times, False):
            value(receiver, "bytearray(1 << 28)")
        return value(receiver, expression, timeout_s)

    put(board.address, bench_program(tmp_path))
    monkeypatch.setattr(Receiver, "value", crowded)
    program = bench_program(tmp_path)
    assert program.is_called(put(board.address, program).program)
    assert not next(times, False)
    times = iter([True] * 99)
    with pytest.raises(BoardError, match="the board failed: MemoryError"):
        put(board.address, program)
    monkeypatch.undo()
    assert program.is_called(runs(board.address))


def test_a_first_deploy_that_is_cut_is_mended_by_the_next_one(board: Any, tmp_path: Path) -> None:
    program = bench_program(tmp_path)
    for cut in range(15, 400, 10 if THOROUGH else 190):
        with Proxy(port_of(board.address), cut_after=cut) as wire, pytest.raises(LineError):
            put(wire.address, program, fresh=True)
        board.cut_power()
    assert program.is_called(put(board.address, program).program)
    assert program.is_called(runs(board.address))


@pytest.mark.parametrize("seed", SEEDS)
def test_bytes_that_are_lost_changed_and_added_are_mended(board: Any, tmp_path: Path, seed: int) -> None:
    program = bench_program(tmp_path, OTHER)
    with Proxy(port_of(board.address), disturb=noise(seed, 0.001)) as wire:
        done = put(wire.address, program)
    assert program.is_called(done.program)
    assert runs(board.address) == done.program
    files = files_of(board.address)
    built = program.package.build("machine", program.file.drivers, COMPILED_LOOP)
    for name, content in built.files.items():
        assert files[name] == content
