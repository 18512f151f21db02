"""A page unpacks the firmware where Python looks for it, and finds the same as an installed KitRobot."""

from __future__ import annotations

import io
import sys
import zipfile
from pathlib import Path

import pytest

from kitrobot.deploy.microbit_hex.bundled_firmware import V1, V2, firmware_file
from kitrobot.packaging.site_firmware import firmware_archive


def test_the_archive_holds_both_firmwares_and_the_licence_and_is_found_once_unpacked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data = firmware_archive()
    assert data == firmware_archive()
    assert len(data) < 1_000_000
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert any(
            "License-Expression: MIT" in archive.read(name).decode()
            for name in archive.namelist()
            if "METADATA" in name
        )
        archive.extractall(tmp_path)
    installed = {board: firmware_file(board).read_bytes() for board in (V1, V2)}
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    monkeypatch.delitem(sys.modules, "micropython_microbit_fs", raising=False)
    for board in (V1, V2):
        found = firmware_file(board)
        assert found.is_relative_to(tmp_path)
        assert found.read_bytes() == installed[board]
