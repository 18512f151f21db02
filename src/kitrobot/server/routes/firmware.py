"""`/api/firmware`: boards that show a drive for new firmware, and MicroPython copied to one of them.

A file is whole and for that chip before its first byte is copied (`kitrobot.deploy.firmware.uf2`). Only drives that
this machine shows as boards are written to, and only for who sits at it.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import Depends, Query, Request

from kitrobot.server.routes.api_router import api_router, refuse_visitors
from kitrobot.wire.firmware import DriveShape, FirmwareShape, FlashedShape

firmware_routes = api_router()


async def _body(request: Request) -> bytes:
    return await request.body()


@firmware_routes.get("/firmware")
def firmware(request: Request) -> FirmwareShape:
    """The drives of boards that there are now, and the page where MicroPython is to be had."""
    refuse_visitors(request)
    from kitrobot.deploy.firmware.requirements import EVERYWHERE
    from kitrobot.deploy.firmware.uf2 import drives

    found = [DriveShape(folder=str(one.folder), board=one.board, chip=one.chip) for one in drives()]
    return FirmwareShape(page=EVERYWHERE, drives=found)


@firmware_routes.post("/firmware")
def flash_firmware(
    request: Request,
    data: Annotated[bytes, Depends(_body)],
    file: Annotated[str, Query(max_length=200)],
    drive: Annotated[str, Query(max_length=1000)],
) -> FlashedShape:
    """Copies a UF2 file to a board; the board restarts with it."""
    refuse_visitors(request)
    from kitrobot.deploy.firmware.uf2 import drive_shown, firmware_of, flash

    found = firmware_of(data, file)
    target = drive_shown(drive)
    flash(found, target)
    return FlashedShape(board=target.board, micropython=found.micropython)
