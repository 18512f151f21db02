"""Files for the drive of a Pico and its like: what is in them, for readers that are not ours, and what is refused."""

from __future__ import annotations

import struct
from contextlib import suppress
from dataclasses import replace
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st
from littlefs import LittleFS, UserContext

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.errors import BoardError, FirmwareError, FullError, PackageError
from kitrobot.deploy.firmware.uf2 import FlashError, firmware_of
from kitrobot.deploy.installation.boot_records import read_line
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.script import board_file
from kitrobot.deploy.uf2_image import board_uf2
from kitrobot.deploy.uf2_image.board_uf2 import BoardUf2, make_board_uf2
from kitrobot.deploy.uf2_image.file_storage import FLASH, SECTOR, FileStorage
from kitrobot.deploy.uf2_image.littlefs_image import build_littlefs
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.embedded_mission import CarriedError, carried_mission
from kitrobot.files.uf2_file import BLOCK, MAGIC, Uf2Error, Uf2File, read_uf2
from kitrobot.robots.program import BoardProgram
from tests.deploy.uf2_firmware import ABSOLUTE, PICO, RP2040, RP2350, binary, block, micropython, uf2
from tests.verifier.check_fixtures import EXAMPLES

SQUARE = EXAMPLES / "square" / "square.krt"
OLD = b"\x5a"
"""What is in the flash before."""


@cache
def square(kit: str = "pico") -> BoardProgram:
    return load_board_program(SQUARE, kit=kit)


def made_of(firmware=None, program: BoardProgram | None = None) -> BoardUf2:
    program = program or square()
    return make_board_uf2(program.file, program.package, firmware or micropython(), program.needs, SQUARE.read_bytes())


@pytest.fixture(scope="module")
def made() -> BoardUf2:
    return made_of()


def flash_after(data: bytes, family: int = RP2040, size: int = 2 * 1024 * 1024) -> bytes:
    """The flash of a Pico that had something else, as the boot ROM of the RP2040 writes it: blocks of another family
    and those for no flash are left out, the first of each sixteen blocks by their numbers erases its sector, and a
    program only takes bits away.
    """
    flash, erased, count = bytearray(OLD * size), set(), 0
    for at in range(0, len(data), BLOCK):
        flags, address, length, number, total, chips = struct.unpack_from("<6I", data, at + 8)
        if flags & 1 or not flags & 0x2000 or chips != family or length != 256:
            continue
        assert count < total, "it has restarted"
        count += 1
        place = address - FLASH
        if number // 16 not in erased:
            erased.add(number // 16)
            sector = place - place % SECTOR
            flash[sector : sector + SECTOR] = b"\xff" * SECTOR
        payload = data[at + 32 : at + 32 + 256]
        flash[place : place + 256] = bytes(
            old & new for old, new in zip(flash[place : place + 256], payload, strict=True)
        )
    assert count == total, "it waits for more"
    assert data[-BLOCK + 8] & 1 == 0, "a computer has sent everything when the board restarts"
    return bytes(flash)


def mounted(flash: bytes, storage: FileStorage = PICO) -> LittleFS:
    """The files as a MicroPython takes them: `ports/rp2/modules/_boot.py`, the one of 1.20."""
    context = UserContext(storage.size)
    context.buffer[:] = flash[storage.start - FLASH : storage.start - FLASH + storage.size]
    return LittleFS(
        context,
        block_size=SECTOR,
        block_count=storage.sectors,
        read_size=32,
        prog_size=256,
        lookahead_size=32,
        cache_size=1024,
        block_cycles=100,
        disk_version=0x00020000,
    )


def files_of(mount: LittleFS) -> dict[str, bytes]:
    found = {}
    for name in mount.listdir("/"):
        with mount.open(name, "rb") as file:
            found[name] = file.read()
    return found


def test_the_library_of_micropython_reads_the_files_that_are_sent_to_such_a_board(made: BoardUf2) -> None:
    program = square()
    built = program.package.build("machine", program.file.drivers, COMPILED_LOOP)
    content = board_file(program.file, built)
    found = files_of(mounted(flash_after(made.data)))
    line = read_line(found.pop("kr0"))
    assert line is not None
    assert found == {**built.files, line.program: content, "main.py": built.main}
    assert line.module == built.interpreter


@pytest.mark.parametrize("size", [0x5000, 0x5100, 0x5EFF, 0x6001])
def test_the_firmware_is_in_the_flash_byte_for_byte_wherever_it_ends(size: int) -> None:
    flash = flash_after(made_of(micropython(size=size)).data)
    assert flash[:size] == binary(size=size)
    end = -(-size // SECTOR) * SECTOR
    assert set(flash[end : PICO.start - FLASH]) == set(OLD), "what belongs to nobody stays"


@pytest.mark.parametrize("in_memory", [False, True])
def test_a_firmware_says_where_its_files_are(in_memory: bool) -> None:
    storage = FileStorage(FLASH + 0x40000, 16 * SECTOR + 64 * SECTOR)
    other = struct.pack("<2H4IH", 7, 0x1234, 0, FLASH + 0x80000, 8 * SECTOR, 0, 3)
    firmware = micropython(storage=storage, in_memory=in_memory, records=[other])
    assert "main.py" in files_of(mounted(flash_after(made_of(firmware).data), storage))


def test_a_file_for_the_rp2350_keeps_the_block_in_front() -> None:
    program = square()
    assert program.needs is not None
    newer = replace(program, needs=replace(program.needs, chip="rp2350"))
    firmware = micropython(RP2350)
    done = made_of(firmware, newer)
    assert (done.chip, done.data[:BLOCK]) == ("RP2350", firmware.data[:BLOCK])
    assert {one.family for one in read_uf2(done.data, "a").blocks} == {ABSOLUTE, RP2350}
    assert "main.py" in files_of(mounted(flash_after(done.data, RP2350)))
    assert firmware_of(done.data, "a").chips == ("RP2350",), "`kitrobot flash` copies it too"


def test_the_mission_is_inside_and_opens_again(made: BoardUf2) -> None:
    assert carried_mission(made.data, "square.uf2") == (SQUARE.read_bytes(), "square.krt")


NAMES = st.text("abcz09._", min_size=1, max_size=12).filter(lambda name: name not in (".", ".."))
SIZES = [0, 1, 64, 65, 4095, 4096, 4097, 4096 + 4092, 4096 + 4093, 40_000]
CONTENTS = st.tuples(st.sampled_from(SIZES), st.binary(min_size=1, max_size=20)).map(
    lambda found: (found[1] * (found[0] // len(found[1]) + 1))[: found[0]]
)


@given(st.dictionaries(NAMES, CONTENTS, max_size=30))
def test_a_file_system_is_read_by_the_library_which_goes_on_with_it(files: dict[str, bytes]) -> None:
    storage = FileStorage(FLASH, 400 * SECTOR)
    flash = bytearray(OLD * storage.size)
    sectors = build_littlefs(storage, files)
    for number, content in sectors.items():
        flash[number * SECTOR : (number + 1) * SECTOR] = content
    mount = mounted(bytes(flash), storage)
    assert mount.used_block_count == len(sectors)
    assert files_of(mount) == files
    with mount.open("a new one", "wb") as file:
        file.write(bytes(10_000))
    for name in files:
        mount.remove(name)
    newer = LittleFS(mount.context, block_size=SECTOR, block_count=storage.sectors)
    assert newer.listdir("/") == ["a new one"], "a later version of it too"


def test_a_full_file_system_is_refused_and_the_last_sector_is_used() -> None:
    storage = FileStorage(FLASH, 8 * SECTOR)
    files = {f"a{number}": bytes(100) for number in range(6)}
    assert len(build_littlefs(storage, files)) == 8
    with pytest.raises(FullError, match="36864 bytes of the board's flash, which has 32768"):
        build_littlefs(storage, {**files, "b": bytes(100)})
    with pytest.raises(FullError):
        build_littlefs(replace(storage, size=PICO.size), {f"{number:0>200}": b"" for number in range(30)})


def test_a_program_too_large_for_the_chip_is_refused_with_what_takes_most(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(board_uf2.MEMORY, "RP2040", 5000)
    with pytest.raises(BoardError) as refused:
        made_of()
    assert "the drivers that take most are `drive` (" in str(refused.value.help), "what to leave out"


def without_records(data: bytes) -> bytes:
    return data.replace(struct.pack("<I", 0xE71AA390), bytes(4))


def two_chips() -> bytes:
    return uf2(binary()) + uf2(binary(), RP2350)


def at_other_places() -> bytes:
    return uf2(binary()).replace(struct.pack("<I", FLASH), struct.pack("<I", FLASH - 0x100), 1)


@pytest.mark.parametrize(
    ("firmware", "said"),
    [
        (uf2(binary(), RP2350), "is for RP2350, and the kit `pico` has RP2040"),
        (uf2(binary(), 0x1234), "is for an unknown chip, and the kit `pico` has RP2040"),
        (uf2(binary().replace(b"MicroPython", b"Something  ")), "no MicroPython was found in `a.uf2`"),
        (uf2(binary(version="1.19.1")), "has MicroPython 1.19.1, and the kit `pico` needs 1.20 or later"),
        (uf2(without_records(binary())), "does not know where the firmware `a.uf2` keeps its files"),
        (uf2(binary(FileStorage(FLASH + 0xA0001, 0x10000))), "does not know where"),
        (uf2(binary(FileStorage(FLASH + 0xA0000, 0x1000))), "does not know where"),
        (uf2(binary(FileStorage(FLASH + 0xA0000, 0x7FFFF000))), "does not know where"),
        (two_chips(), "does not know where"),
        (at_other_places(), "does not know where"),
        (uf2(binary() + b"\x09\x04\x02\x00\x02\x08\x06\x50\x05"), "shows its files as a drive"),
        (uf2(binary(FileStorage(FLASH + 0x5000, 0x10000))), "brings files of its own along"),
    ],
)
def test_a_firmware_that_cannot_be_used_is_refused_with_a_way_out(firmware: bytes, said: str) -> None:
    with pytest.raises(FirmwareError) as refused:
        made_of(firmware_of(firmware, "a.uf2"))
    assert said in refused.value.message
    assert refused.value.help


def test_what_was_made_so_is_no_firmware_for_another(made: BoardUf2) -> None:
    with pytest.raises(FirmwareError, match="brings files of its own along"):
        made_of(firmware_of(made.data, "a.uf2"))


def test_a_firmware_of_another_kind_of_chip_is_refused_where_no_kit_says_which() -> None:
    with pytest.raises(FirmwareError, match="does not know where"):
        made_of(firmware_of(uf2(binary(), 0xC47E5767), "a.uf2"), replace(square(), needs=None))


@pytest.mark.parametrize("kit", ["cutebot", "esp32"])
def test_a_kit_of_another_board_is_refused(kit: str) -> None:
    with pytest.raises(PackageError, match=f"with RP2040 or RP2350, and the kit `{kit}` is for another board"):
        made_of(program=square(kit))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda data: data[:-BLOCK], "1 of its"),
        (lambda data: data[:-7], "it is cut off in its block"),
        (lambda data: data[: 3 * BLOCK] + data[4 * BLOCK :], "1 of its"),
        (lambda data: data[: BLOCK + 3] + b"?" + data[BLOCK + 4 :], "its block 2 is damaged"),
        (lambda data: uf2(binary()), "without a mission of KitRobot"),
        (lambda data: MAGIC, "it is cut off in its block 1"),
        (lambda data: b"", "is empty"),
        (lambda data: b"PK\x03\x04", "ZIP"),
        (lambda data: b"hello", "not the file for a board that its name promises"),
    ],
)
def test_a_uf2_of_others_or_a_damaged_one_is_refused(made: BoardUf2, change, said: str) -> None:
    with pytest.raises(CarriedError, match=said) as refused:
        carried_mission(change(made.data), "square.uf2")
    assert refused.value.help


@given(st.data())
def test_no_changed_byte_makes_anything_but_a_file_or_a_sentence(data: st.DataObject) -> None:
    given_file = data.draw(st.sampled_from([made_of_once(), uf2(binary())]))
    changed = bytearray(
        given_file[: data.draw(st.sampled_from([len(given_file), data.draw(st.integers(0, 40)) * BLOCK]))]
    )
    for _ in range(data.draw(st.integers(0, 4))):
        if changed:
            # Where blocks say what they are, and in what the firmware says of itself.
            place = data.draw(st.integers(0, len(changed) // BLOCK - 1)) * BLOCK
            changed[place + data.draw(st.integers(0, BLOCK - 1))] = data.draw(st.integers(0, 255))
    with suppress(CarriedError):
        carried_mission(bytes(changed), "square.uf2")
    with suppress(FlashError, FirmwareError, FullError):
        made_of(firmware_of(bytes(changed), "a.uf2"))


@cache
def made_of_once() -> bytes:
    return made_of().data


WORDS = st.one_of(st.integers(0, 0xFFFFFFFF), st.integers(FLASH, FLASH + 0x6000), st.integers(0x20000000, 0x20001000))


@given(st.lists(WORDS, min_size=40, max_size=40), st.integers(0, 0x300))
def test_what_a_firmware_says_of_itself_may_be_anything(words: list[int], at: int) -> None:
    content = bytearray(binary())
    content[0x1D4 + 4 : 0x1D4 + 16] = struct.pack("<3I", *words[:3])
    content[0x700:0x718] = struct.pack("<6I", *words[3:9])
    content[0x1000 + at : 0x1000 + at + 124] = struct.pack("<31I", *words[9:])
    with suppress(KitRobotError):
        made_of(firmware_of(uf2(bytes(content)), "a.uf2"))


@given(st.binary(max_size=1500))
def test_no_bytes_make_anything_but_a_uf2_file_or_a_sentence(data: bytes) -> None:
    with suppress(Uf2Error):
        read_uf2(MAGIC + data, "x.uf2")


@given(st.lists(st.binary(min_size=256, max_size=256), min_size=1, max_size=5), st.binary(max_size=1500))
def test_what_is_written_is_read_the_same(pages: list[bytes], other: bytes) -> None:
    from kitrobot.files.uf2_file import write_uf2

    placed = [(FLASH + 256 * place, page) for place, page in enumerate(pages)]
    found: Uf2File = read_uf2(write_uf2(RP2040, placed, other), "x.uf2")
    assert ([(one.address, one.payload) for one in found.blocks], found.other) == (placed, other)


def test_a_block_for_no_flash_is_no_part_of_a_firmware() -> None:
    assert firmware_of(block(0, 1, b"\0" * 256), "a").micropython == ""
