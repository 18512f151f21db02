"""Firmware on the wire: boards that show a drive for it, and what was copied."""

from __future__ import annotations

from pydantic import BaseModel


class DriveShape(BaseModel):
    """A drive that takes firmware; `board` as it names itself, `chip` "" where that says nothing."""

    folder: str
    board: str
    chip: str


class FirmwareShape(BaseModel):
    """The drives that there are now; `page`: where MicroPython for most boards is to be had."""

    page: str
    drives: list[DriveShape]


class FlashedShape(BaseModel):
    """A firmware that was copied: the board as it names itself, and the version, "" for no MicroPython."""

    board: str
    micropython: str
