"""`kitrobot flash`: MicroPython onto a board that shows itself as a drive."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import json_text, print_data, print_message, sanitize


def flash_board(
    file: Annotated[
        Path, typer.Argument(metavar="FILE.uf2", help="MicroPython for the board, from its maker.", show_default=False)
    ],
    drive: Annotated[
        Path | None,
        typer.Option(
            metavar="FOLDER", help="The drive that the board shows.", show_default="the only one that is there"
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Give what was done as one JSON object.")] = False,
) -> None:
    """Put MicroPython on a board by copying it to the drive that the board shows.

    For boards that take UF2 files, such as a Raspberry Pi Pico: hold its button BOOTSEL while you plug it in. The file
    is looked through first; one that is damaged, cut off, or for another chip is not copied. Nothing is fetched from
    the network: `kitrobot boards` says where a board's maker has it.
    """
    from kitrobot.deploy.firmware.uf2 import chosen_drive, flash, read_firmware

    firmware = read_firmware(file)
    target = chosen_drive(drive)
    if not firmware.micropython:
        print_message(f"no MicroPython was found in {file}; it is copied all the same")
    flash(firmware, target)
    if as_json:
        found = {
            "drive": str(target.folder),
            "board": target.board,
            "chips": list(firmware.chips),
            "micropython": firmware.micropython,
            "bytes": len(firmware.data),
        }
        print_data(json_text(found, 2) + "\n")
        return
    named = f"MicroPython {firmware.micropython}" if firmware.micropython else "the firmware"
    print_data(
        f"{sanitize(str(target.folder))}: {sanitize(named)} is on the board"
        f" ({sanitize(target.board) or 'which says no name'})\n"
    )
    print_message("it restarts by itself; then `kitrobot boards` lists it")
