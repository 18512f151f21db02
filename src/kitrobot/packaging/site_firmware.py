"""The firmware that a static site hands out when a page makes a file for a board: MicroPython for the micro:bit.

It is a file of its own, half a megabyte, which is fetched when it is first wanted (`server.in_worker`).
"""

from __future__ import annotations

import io
import zipfile
from importlib.metadata import distribution
from pathlib import Path
from typing import Final

FIRMWARE_ARCHIVE: Final = "microbit.zip"
_LIBRARY: Final = "micropython-microbit-fs"
_DAY: Final = (2020, 1, 1, 0, 0, 0)


def firmware_archive() -> bytes:
    """The hex files of the library and its licence as a ZIP, by their places in it; always the same bytes."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for entry in sorted(distribution(_LIBRARY).files or (), key=str):
            name = entry.as_posix()
            if name.endswith((".hex", "/METADATA")):
                archive.writestr(
                    zipfile.ZipInfo(name, _DAY), Path(str(entry.locate())).read_bytes(), zipfile.ZIP_DEFLATED
                )
    return made.getvalue()
