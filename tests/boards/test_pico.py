"""The Raspberry Pi Pico's own firmware in an emulator, where somebody names its files; and the emulator's board itself.

What is said of the firmware is left out without `KITROBOT_PICO_FIRMWARE` and `KITROBOT_PICO_BOOTROM` (tools/pico.py).
"""

from __future__ import annotations

import contextlib
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
import serial

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.firmware.uf2 import read_firmware
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.news import News
from kitrobot.deploy.uf2_image.board_uf2 import make_board_uf2
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.robots.program import BoardProgram
from tests.boards.pico import Pico
from tests.boards.proxy import Proxy
from tests.boards.test_modern_robot import FORWARD_LEFT, FORWARD_RIGHT, LOOKS
from tests.boards.test_ticks import compared
from tests.patience import PATIENCE_S
from tools import pico

FLASH, RAM, UART = 0x10000000, 0x20000000, 0x40034000
KEPT = 0x100000
"""Where in the flash the little firmware keeps a letter."""

ERASE, PROGRAM = 0x40, 0x44
POOL = 0x44
WORDS = (UART, FLASH + KEPT, RAM, ERASE | 1, PROGRAM | 1)


def bootrom() -> bytes:
    """A ROM that has nothing but a table with two functions."""
    table = struct.pack("<2sH2sHH", b"RE", ERASE | 1, b"RP", PROGRAM | 1, 0)
    return (bytes(0x14) + struct.pack("<HH", 0x20, 0)).ljust(0x20, b"\0") + table.ljust(0x20, b"\0") + bytes(0x3FC0)


def firmware() -> bytes:
    """A UF2 that says again what it hears; `w` keeps the letter K in the flash, `r` tells the letter that is kept."""

    def word(at: int, register: int, number: int) -> int:
        return 0x4800 | register << 8 | (POOL + 4 * number - (at + 4 & ~3)) // 4

    def jump(at: int, target: int, when: int | None = None) -> int:
        way = (target - at - 4) >> 1
        return 0xE000 | way & 0x7FF if when is None else 0xD000 | when << 8 | way & 0xFF

    equal, other = 0, 1
    listen, echo, recall, store = 0x02, 0x16, 0x1A, 0x20
    code = [
        word(0x00, 4, 0),  # r4: the UART
        0x69A0,  # listen: r0 = its flags
        0x2110,  # r1 = nothing was heard
        0x4208,  # are they both?
        jump(0x08, listen, other),
        0x6820,  # r0 = what was heard
        0x2800 | ord("w"),
        jump(0x0E, store, equal),
        0x2800 | ord("r"),
        jump(0x12, recall, equal),
        0xBF00,
        0x6020,  # echo: says r0
        jump(0x18, listen),
        word(0x1A, 2, 1),  # recall: r0 = the letter in the flash
        0x7810,
        jump(0x1E, echo),
        word(0x20, 6, 2),  # store: a K into the memory
        0x2000 | ord("K"),
        0x6030,
        0x2001,  # erases 4096 bytes at KEPT
        0x0500,
        0x2101,
        0x0309,
        word(0x2E, 5, 3),
        0x47A8,
        0x2001,  # programs 256 bytes of the memory there
        0x0500,
        0x0031,
        0x2201,
        0x0212,
        word(0x3C, 5, 4),
        0x47A8,
        0x2000 | ord("."),
        jump(0x42, echo),
    ]
    assert len(code) == POOL // 2
    return uf2(struct.pack(f"<{len(code)}H5I", *code, *WORDS))


def uf2(data: bytes) -> bytes:
    """That file, to lie at the beginning of the flash."""
    blocks = [data[at : at + 256].ljust(256, b"\0") for at in range(0, len(data), 256)]
    return b"".join(
        struct.pack("<8I", 0x0A324655, 0x9E5D5157, 0x2000, FLASH + 256 * number, 256, number, len(blocks), 0xE48BFF56)
        + block.ljust(476, b"\0")
        + struct.pack("<I", 0x0AB16F30)
        for number, block in enumerate(blocks)
    )


def said(line: serial.Serial, words: bytes) -> bytes:
    line.write(words)
    found: bytes = line.read(len(words))
    return found


def test_the_emulated_board_runs_what_it_is_given_and_keeps_its_flash_when_its_power_is_cut(tmp_path: Path) -> None:
    (tmp_path / "little.uf2").write_bytes(firmware())
    (tmp_path / "rom.bin").write_bytes(bootrom())
    with Pico(tmp_path / "little.uf2", tmp_path / "rom.bin") as board:
        with contextlib.closing(serial.serial_for_url(board.address, timeout=PATIENCE_S)) as line:
            assert said(line, b"hello") == b"hello"
            assert said(line, b"r") == b"\xff"
            assert said(line, b"w") == b"."
            assert said(line, b"r") == b"K"
            before = board.seconds()
            board.cut_power()
            assert said(line, b"r") == b"K"
            assert board.seconds() > before > 0
        assert board.duty(2) == 0


@pytest.fixture
def board() -> Iterator[Pico]:
    found = pico.find()
    assert found is not None, pico.LEFT_OUT
    with Pico(*found) as one, one.on_its_clock():
        yield one


def program(folder: Path, text: str, kit: str | None = None) -> BoardProgram:
    path = folder / "drive.lll"
    path.write_text(text, encoding="utf-8")
    return load_board_program(path, robot="kit-robot", kit=kit)


def until_duties(board: Pico, pins: Sequence[int], duties: Sequence[float]) -> None:
    """Waits until the pins stand so."""
    end = board.seconds() + 20
    while [round(board.duty(pin), 2) for pin in pins] != list(duties):
        assert board.seconds() < end, [board.duty(pin) for pin in pins]


@pytest.mark.pico
@pytest.mark.timeout(3000)
def test_a_robot_is_deployed_to_a_pico_driven_watched_and_stopped(board: Pico, tmp_path: Path) -> None:
    made = program(tmp_path, LOOKS + "LeftWheel.Forward(50); RightWheel.Forward(20); WAIT(600);")
    pins = (FORWARD_LEFT, FORWARD_RIGHT)
    assert made.is_called(deploy(board.address, made.file.to_bytes(), made.package).program)
    with connect(board.address, PATIENCE_S) as link:
        link.start(held=True)
        link.watch(100)
        news = [link.news(5) for _ in range(10)]
        assert all(isinstance(one, News) for one in news)
        late = link.look().late
        until_duties(board, pins, (0.5, 0.2))
        for _ in range(20):
            link.news(0.1)
        assert link.look().late == late, "watching makes no tick late"
        link.stop()
        until_duties(board, pins, (0, 0))
        link.start(held=True)
        until_duties(board, pins, (0.5, 0.2))
    until_duties(board, pins, (0, 0))
    board.cut_power()
    with connect(board.address, PATIENCE_S) as link:
        assert link.hello.state_name == "running", "it starts by itself"


@pytest.mark.pico
@pytest.mark.timeout(3000)
def test_a_body_made_for_its_chip_turns_its_wheels_and_stands_after_stop_and_a_lost_hold(
    board: Pico, tmp_path: Path
) -> None:
    made = program(tmp_path, "LeftWheel.Forward(50); RightWheel.Backward(20); WAIT(600);", "pololu-3pi")
    # Of each wheel the pin with the power and the one that is high for backward.
    pins = (15, 11, 14, 10)
    deploy(board.address, made.file.to_bytes(), made.package)
    with connect(board.address, PATIENCE_S) as link:
        link.start(held=True)
        until_duties(board, pins, (0.5, 0, 0.2, 1))
        link.stop()
        until_duties(board, pins, (0, 0, 0, 0))
        link.start(held=True)
        until_duties(board, pins, (0.5, 0, 0.2, 1))
    until_duties(board, pins, (0, 0, 0, 0))


@pytest.mark.pico
@pytest.mark.timeout(3000)
def test_a_pico_gives_the_commands_of_the_simulator(board: Pico, tmp_path: Path) -> None:
    made = program(
        tmp_path, "*[!(Captor.LessThan(5))](LeftWheel.Forward(50); WAIT(1); Door.Open(); Light.LightOn(); );"
    )
    deploy(board.address, made.file.to_bytes(), made.package)
    compared(board.address, made, load_catalogue().robots["kit-robot"], seed=15)


@pytest.mark.pico
@pytest.mark.timeout(3000)
@pytest.mark.parametrize("cut", [5, 25, 60])
def test_a_deploy_to_a_pico_that_is_cut_leaves_what_was_there(board: Pico, tmp_path: Path, cut: int) -> None:
    old, new = (program(tmp_path, f"LeftWheel.Forward({speed}); WAIT(600);") for speed in (30, 40))
    deploy(board.address, old.file.to_bytes(), old.package)
    port = int(board.address.rpartition(":")[2])
    with Proxy(port, cut_after=cut) as wire, contextlib.suppress(KitRobotError):
        deploy(wire.address, new.file.to_bytes(), new.package)
    board.cut_power()
    with connect(board.address, PATIENCE_S) as link:
        assert old.is_called(link.hello.program) or new.is_called(link.hello.program)
    assert new.is_called(deploy(board.address, new.file.to_bytes(), new.package).program)


@pytest.mark.pico
@pytest.mark.timeout(3000)
def test_a_file_for_its_drive_starts_by_itself_and_sending_finds_all_of_it_there(tmp_path: Path) -> None:
    found = pico.find()
    assert found is not None, pico.LEFT_OUT
    made = program(tmp_path, "LeftWheel.Forward(50); RightWheel.Forward(20); WAIT(600);", "pico")
    file = make_board_uf2(made.file, made.package, read_firmware(found.firmware), made.needs)
    (tmp_path / "drive.uf2").write_bytes(file.data)
    with Pico(tmp_path / "drive.uf2", found.bootrom) as board, board.on_its_clock():
        with connect(board.address, PATIENCE_S) as link:
            assert (link.hello.state_name, link.hello.generation) == ("running", 1)
        sent = deploy(board.address, made.file.to_bytes(), made.package)
        assert (sent.sent_files, sent.generation) == ((), 1)
