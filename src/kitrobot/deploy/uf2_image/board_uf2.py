"""A program as a UF2 file: what a board has after `deploy`, as a file that is copied onto the drive that it shows.

The file is the MicroPython that the user has for the board, byte for byte, and a new file system where that keeps its
files. The boot ROM of the RP2040 erases a sector with the first of each sixteen blocks, so every sector that is named
is written whole, beginning with such a block. The mission travels along, so the file opens in the studio.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from kitrobot.deploy.errors import FirmwareError, PackageError
from kitrobot.deploy.firmware.requirements import EVERYWHERE, FirmwareRequirements
from kitrobot.deploy.firmware.uf2 import FAMILIES_OF_CHIPS, Firmware
from kitrobot.deploy.installation.initial_files import initial_files
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import ProgramFile
from kitrobot.deploy.uf2_image.file_storage import PAGE, SECTOR, flash_content, storage_of, unknown_firmware
from kitrobot.deploy.uf2_image.littlefs_image import build_littlefs
from kitrobot.files.embedded_mission import packed_mission
from kitrobot.files.uf2_file import write_uf2
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import COMMA, Sentence, Series

MEMORY = {"RP2040": 230_000, "RP2350": 480_000}
"""Chip → bytes of memory that its MicroPython has at most, before a program is there."""

_FAMILY = "machine"
_FAMILIES = {number: chip for number, chip in FAMILIES_OF_CHIPS.items() if chip in MEMORY}
_ERASED = b"\xff" * PAGE


@dataclass(frozen=True)
class BoardUf2:
    """A UF2 file, the chip that it is for, and the version of its MicroPython."""

    data: bytes
    chip: str
    micropython: str


def make_board_uf2(
    program: ProgramFile,
    package: Package,
    firmware: Firmware,
    needs: FirmwareRequirements | None = None,
    mission: bytes = b"",
) -> BoardUf2:
    """The UF2 file of a program.

    Args:
        program: the file in which drivers have the names that robots' XML gives them.
        package: where drivers are looked for.
        firmware: the MicroPython that the file brings along.
        needs: the firmware that the robot's kit requires.
        mission: the `.krt` that travels along; none where it is empty.

    Raises:
        PackageError: a driver is missing, or the kit is of a board that takes no such file.
        FirmwareError: the firmware is none of MicroPython, too old, for another chip, or does not say where its files
            are.
        BoardError: it fits none of the chips, with what takes most.
    """
    _refuse_other_kit(needs)
    content = flash_content(_suitable(firmware, needs), _FAMILIES)
    storage = storage_of(firmware, content)
    chip = _FAMILIES[content.family]
    files = initial_files(program, package, _FAMILY, COMPILED_LOOP, MEMORY[chip])
    sectors = {storage.start + number * SECTOR: one for number, one in build_littlefs(storage, files).items()}
    pages = {address + at: one[at : at + PAGE] for address, one in sectors.items() for at in range(0, SECTOR, PAGE)}
    other = packed_mission(mission) if mission else b""
    data = write_uf2(content.family, _in_whole_sectors({**content.pages, **pages}), other, content.before)
    return BoardUf2(data, chip, firmware.micropython)


def _in_whole_sectors(pages: Mapping[int, bytes]) -> Iterator[tuple[int, bytes]]:
    for sector in sorted({address // SECTOR for address in pages}):
        for address in range(sector * SECTOR, (sector + 1) * SECTOR, PAGE):
            yield address, pages.get(address, _ERASED)


def _refuse_other_kit(needs: FirmwareRequirements | None) -> None:
    if needs is None or not needs.family:
        return
    if needs.family != _FAMILY or (needs.chip and needs.chip.upper() not in MEMORY):
        raise PackageError(
            Sentence(
                "a `.uf2` is for a board with {chips}, and the kit `{kit}` is for another board",
                one_of(MEMORY),
                needs.kit,
            ),
            Sentence("name the kit of such a board with --board, or send the program over a cable"),
        )


def _suitable(firmware: Firmware, needs: FirmwareRequirements | None) -> Firmware:
    """The firmware, when it is a MicroPython for a chip that is known here, and the kit's."""
    href = needs.href if needs is not None and needs.href else EVERYWHERE
    if not firmware.micropython:
        raise FirmwareError(
            Sentence("no MicroPython was found in `{file}`", firmware.name),
            Sentence("fetch MicroPython for your board from {href}", href),
        )
    if needs is not None and needs.chip and needs.chip.upper() not in firmware.chips:
        raise FirmwareError(
            Sentence(
                "the firmware `{file}` is for {chips}, and the kit `{kit}` has {chip}",
                firmware.name,
                Series(COMMA, firmware.chips) if firmware.chips else Sentence("an unknown chip"),
                needs.kit,
                needs.chip.upper(),
            ),
            Sentence("fetch MicroPython for your board from {href}", href),
        )
    if not any(chip in MEMORY for chip in firmware.chips):
        raise unknown_firmware(firmware)
    if needs is not None:
        needs.refuse_older(firmware.micropython)
    return firmware
