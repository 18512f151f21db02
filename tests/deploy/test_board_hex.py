"""Files for the drive of a micro:bit: what is in them, for readers that are not ours, and what is refused."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import micropython_microbit_fs
import pytest
import universal_hex
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.errors import BoardError, FirmwareError, FullError, PackageError
from kitrobot.deploy.installation.boot_records import read_line
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP, loop_block
from kitrobot.deploy.microbit_hex import board_hex
from kitrobot.deploy.microbit_hex.board_hex import BoardHex, make_board_hex
from kitrobot.deploy.microbit_hex.bundled_firmware import V1, V2, bundled_firmware, compiled_block
from kitrobot.deploy.microbit_hex.file_area import FileArea, area_of_firmware, build_area, pieces_of_file
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.script import board_file
from kitrobot.files.embedded_mission import CarriedError, carried_mission
from kitrobot.files.intel_hex import HexError, HexFile, read_hex, write_hex
from tests.verifier.check_fixtures import EXAMPLES

HEART = EXAMPLES / "heart" / "heart.krt"


@pytest.fixture(scope="module")
def heart() -> BoardHex:
    program = load_board_program(HEART)
    return make_board_hex(program.file, program.package, program.needs, HEART.read_bytes())


def files_of(data: bytes) -> dict[int, dict[str, bytes]]:
    """The files in the section of each board, as other people's libraries read them."""
    return {
        one.board_id: {file.name: file.content for file in micropython_microbit_fs.get_files(one.hex)}
        for one in universal_hex.separate_uhex(data.decode())
    }


@pytest.mark.parametrize(("board", "installer"), [(V1, FLASH_LOOP), (V2, COMPILED_LOOP)])
def test_other_libraries_read_the_files_that_are_sent_to_such_a_board(heart: BoardHex, board: int, installer) -> None:
    program = load_board_program(HEART)
    built = program.package.build("microbit", program.file.drivers, installer)
    content = board_file(program.file, built)
    found = files_of(heart.data)[board]
    line = read_line(found.pop("kr0"))
    assert line is not None
    assert found == {**built.files, line.program: content, "main.py": built.main}
    assert line.module == built.interpreter


def test_beside_the_files_each_board_has_its_firmware_unchanged(heart: BoardHex) -> None:
    for board, memory in read_hex(heart.data, "heart.hex").boards.items():
        firmware = bundled_firmware(board)
        kept = {at: run for at, run in memory.items() if at != firmware.area.start}
        assert kept == firmware.memory


def test_each_section_begins_at_a_block_of_512_and_names_its_board(heart: BoardHex) -> None:
    text = heart.data.decode()
    first, second = text.index(":0400000A9900C0DE"), text.index(":0400000A9903C0DE")
    address = len(":020000040000FA\n")
    assert (first - address, (second - address) % 512) == (0, 0)
    assert max(map(len, text.splitlines())) <= 1 + 2 * (5 + 32)
    assert text.endswith(":00000001FF\n")


def test_the_mission_is_inside_and_opens_again(heart: BoardHex) -> None:
    assert carried_mission(heart.data, "heart.hex") == (HEART.read_bytes(), "heart.krt")


def test_the_loop_of_2016_is_that_of_these_sources() -> None:
    """Stale? `python -m tools.flash_block --write`."""
    firmware = bundled_firmware(V1)
    assert compiled_block(firmware)[4:8] == loop_block().sign.to_bytes(4, "little")
    with pytest.raises(FirmwareError, match="not compiled for MicroPython"):
        compiled_block(replace(firmware, digest="0"))


def test_a_program_too_large_for_the_board_of_2016_is_for_the_v2_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    program = load_board_program(EXAMPLES / "square" / "square.krt", kit="cutebot")
    small = replace(board_hex._BOARDS[V1], free=5000)
    monkeypatch.setitem(board_hex._BOARDS, V1, small)
    made = make_board_hex(program.file, program.package, program.needs)
    assert made.boards == (V2,)
    assert "bytes of memory" in made.left_out[V1].message
    monkeypatch.setitem(board_hex._BOARDS, V2, replace(board_hex._BOARDS[V2], free=5000))
    with pytest.raises(BoardError) as refused:
        make_board_hex(program.file, program.package, program.needs)
    assert "the drivers that take most are `drive` (" in str(refused.value.help), "what to leave out"


def test_a_kit_of_another_board_is_refused() -> None:
    program = load_board_program(EXAMPLES / "square" / "square.krt", kit="pico")
    with pytest.raises(PackageError, match="the kit `pico` is for another board"):
        make_board_hex(program.file, program.package, program.needs)


def test_a_full_file_system_is_refused_and_the_last_piece_is_used() -> None:
    area = FileArea(0, 1024, 1024)
    size = 126 * 7 - len("name") - 3
    assert len(build_area(area, {"name": bytes(size), "b": b""})) == 2048
    with pytest.raises(FullError, match="flash"):
        build_area(area, {"name": bytes(size), "b": b"", "c": b""})
    assert pieces_of_file("name", bytes(126 - 6)) == 2, "as the board itself does"


def test_another_firmware_is_not_known() -> None:
    with pytest.raises(FirmwareError, match="none that KitRobot knows"):
        area_of_firmware({0: bytes(4096)})


def cut(data: bytes) -> bytes:
    return data[: len(data) // 2]


def other(data: bytes) -> bytes:
    return write_hex(HexFile({V1: {0: b"made by others"}}))


def without_end(data: bytes) -> bytes:
    return data[: data.rindex(b":")]


def damaged(data: bytes) -> bytes:
    at = data.index(b":20", 3000) + 15
    return data[:at] + (b"0" if data[at : at + 1] != b"0" else b"1") + data[at + 1 :]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (cut, "is not whole"),
        (without_end, "its last line is missing"),
        (damaged, "is not whole"),
        (other, "without a mission of KitRobot"),
        (lambda data: b":", "its line 1 is not whole"),
        (lambda data: b"", "is empty"),
        (lambda data: b"PK\x03\x04", "ZIP"),
        (lambda data: b"hello", "not the file for a board that its name promises"),
    ],
)
def test_a_hex_file_of_others_or_a_damaged_one_is_refused(heart: BoardHex, change, said: str) -> None:
    with pytest.raises(CarriedError, match=said) as refused:
        carried_mission(change(heart.data), "heart.hex")
    assert refused.value.help


@given(
    st.dictionaries(st.sampled_from([0x9900, 0x9901, 0x9903]), st.binary(min_size=1, max_size=200), min_size=1),
    st.integers(0, 0x2FFFF),
    st.binary(max_size=100),
)
def test_what_is_written_is_read_the_same(boards: dict[int, bytes], at: int, other: bytes) -> None:
    file = HexFile({number: {at: content} for number, content in boards.items()}, other)
    assert read_hex(write_hex(file), "x.hex") == file


@given(st.binary(max_size=300))
def test_no_bytes_make_anything_but_a_hex_file_or_a_sentence(data: bytes) -> None:
    with suppress(HexError):
        read_hex(b":" + data, "x.hex")


def test_a_file_without_a_mission_says_so_to_who_opens_it(tmp_path: Path) -> None:
    firmware = micropython_microbit_fs.get_bundled_hex(1)
    with pytest.raises(CarriedError, match="without a mission"):
        carried_mission(firmware.content.encode(), "micropython.hex")
