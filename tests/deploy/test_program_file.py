"""The program file: what it says of devices, that it reads back, and that damage is noticed."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.deploy.errors import BoardError, DeployError
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP
from kitrobot.deploy.minification.tree_shaking import UsedParts
from kitrobot.deploy.package.board_package import LoopInstaller
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.memory import image_bytes, refuse_what_does_not_fit
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import ProgramFile, read_program_file
from kitrobot.deploy.package.script import board_file
from kitrobot_onboard.link import checksum
from kitrobot_onboard.state import ACTUATORS
from tests.boards.bench import OTHER, bench_program
from tests.boards.booting import boot
from tests.boards.host_board import SocketPort


@pytest.fixture
def data(tmp_path: Path) -> bytes:
    return bench_program(tmp_path, OTHER).file.to_bytes()


def test_each_device_has_its_line(data: bytes) -> None:
    lines = data.partition(b"\n\n")[0].decode().split("\n")
    assert lines[0] == f"KRP1 {checksum(data.partition(chr(10).encode())[2])}"
    assert lines[1:] == [
        "a stores 2 Turn/1+,Stop/0 pin=1",
        "a stores - Advance/1,Stop/0 pin=2",
        "s zero 1 0 100",
    ]


def test_it_reads_back(data: bytes) -> None:
    assert read_program_file(data).to_bytes() == data


def test_of_each_driver_it_knows_what_the_program_asks(data: bytes) -> None:
    file = read_program_file(data)
    assert file.commands == [(0, "Turn", 1, True), (0, "", 0, False), (1, "Advance", 1, False), (1, "Stop", 0, False)]
    pins = frozenset({("pin", "1"), ("pin", "2")})
    procedures = frozenset({"Turn", "Advance", "Stop"})
    assert file.drivers == {"stores": UsedParts(procedures, later=True, settings=pins), "zero": UsedParts()}


@pytest.mark.parametrize("setting", ["$robot", "'", '"', "\\", "a$file"])
def test_a_setting_is_text_whatever_stands_in_it(data: bytes, tmp_path: Path, setting: str) -> None:
    file = read_program_file(data)
    first, *rest = file.devices
    file = ProgramFile((first._replace(words=(*first.words, f"note={setting}")), *rest), file.image)
    robot, _ = boot(SocketPort(), tmp_path, file.to_bytes(), 1)
    assert robot[ACTUATORS][0][0].settings["note"] == setting


@given(st.data())
def test_damage_is_noticed(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    whole = bench_program(tmp_path_factory.mktemp("bench"), OTHER).file.to_bytes()
    at = data.draw(st.integers(0, len(whole) - 1))
    byte = data.draw(st.integers(0, 255))
    spoilt = whole[:at] + bytes((byte,)) + whole[at + 1 :]
    # Fletcher-16 cannot tell 0 from 255.
    if byte == whole[at] or {byte, whole[at]} <= {0, 255}:
        return
    with pytest.raises(DeployError, match="damaged"):
        read_program_file(spoilt)
    with pytest.raises(DeployError, match="damaged"):
        read_program_file(whole[:at])


def test_a_program_that_is_too_large_for_a_board_is_refused(tmp_path: Path) -> None:
    program = bench_program(tmp_path, "Count.Add(1);\n" * 2000)
    image = program.file.image
    assert image_bytes(image) > 8000
    installers: tuple[tuple[LoopInstaller, str], ...] = (
        (COMPILED_LOOP, rf"needs {image_bytes(image)} bytes"),
        (FLASH_LOOP, "needs 1[0-9]{4} bytes"),
    )
    for installer, needs in installers:
        built = Package((tmp_path,)).build("microbit", program.file.drivers, installer)
        size = len(board_file(program.file, built))
        with pytest.raises(BoardError, match=needs):
            refuse_what_does_not_fit(program.file, built, size, 14_000)
        refuse_what_does_not_fit(program.file, built, size, 200_000)
