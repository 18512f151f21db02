"""MicroPython copied from the studio to a board that shows a drive, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy.firmware import uf2
from tests.deploy.test_firmware import INFO, whole
from tests.deploy.uf2_firmware import RP2350
from tests.server.conftest import HOST, TOKEN, TestClient


@pytest.fixture
def here(app: Any) -> TestClient:
    """A page at this machine."""
    return TestClient(app, base_url=HOST, headers={"X-KitRobot-Token": TOKEN}, client=("127.0.0.1", 50_000))


@pytest.fixture
def shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], Path]:
    """Shows a Pico's drive among others that are none."""
    folders: list[Path] = [tmp_path / "stick"]
    monkeypatch.setattr(uf2, "_mounted", lambda: iter(folders))

    def show() -> Path:
        drive = tmp_path / "RPI-RP2"
        drive.mkdir()
        (drive / "INFO_UF2.TXT").write_text(INFO, encoding="ascii")
        folders.append(drive)
        return drive

    return show


def flash(page: TestClient, drive: object, data: bytes, file: str = "pico.uf2") -> Any:
    return page.post("/api/firmware", params={"file": file, "drive": str(drive)}, content=data)


def test_a_board_that_shows_a_drive_is_listed_and_takes_a_file(here: TestClient, shown: Callable[[], Path]) -> None:
    assert here.get("/api/firmware").json() == {"page": "https://micropython.org/download/", "drives": []}
    drive = shown()
    (found,) = here.get("/api/firmware").json()["drives"]
    assert found == {"folder": str(drive), "board": "RPI-RP2", "chip": "RP2040"}
    assert flash(here, drive, whole()).json() == {"board": "RPI-RP2", "micropython": "1.27.0"}
    assert (drive / "FIRMWARE.UF2").read_bytes() == whole()


def test_what_is_no_firmware_for_it_is_not_copied(here: TestClient, shown: Callable[[], Path], tmp_path: Path) -> None:
    drive = shown()
    for data, says in (
        (b"", "does not begin as"),
        (whole()[:-1], "cut off in its block 3"),
        (whole(RP2350), "is for RP2350, and the board has RP2040"),
    ):
        refused = flash(here, drive, data)
        assert refused.status_code == 422
        assert says in refused.json()["message"]
    assert [path.name for path in drive.iterdir()] == ["INFO_UF2.TXT"]
    for other in (tmp_path, f"{drive}/..", "", "x" * 900):
        assert "drive is gone" in flash(here, other, whole()).json()["message"], "only what is shown is written to"
    assert flash(here, "x" * 2000, whole()).status_code == 422
    assert not list(tmp_path.glob("*.UF2"))


def test_a_visitor_from_another_machine_neither_sees_nor_writes_drives(app: Any, shown: Callable[[], Path]) -> None:
    visitor = TestClient(app, base_url=HOST, headers={"X-KitRobot-Token": TOKEN}, client=("192.168.1.7", 50_000))
    drive = shown()
    assert "another machine" in visitor.get("/api/firmware").json()["message"]
    assert "another machine" in flash(visitor, drive, whole()).json()["message"]
    assert [path.name for path in drive.iterdir()] == ["INFO_UF2.TXT"]


def test_kits_say_the_least_version_that_they_need(page: TestClient) -> None:
    kits = {kit["name"]: kit for kit in page.get("/api/kits", params={"path": ""}).json()}
    assert kits["xrp"]["micropython"] == "1.25"
    assert kits["maqueen"]["micropython"] == ""
    assert all(kit["firmware"] == "" or kit["firmware"].startswith("https://") for kit in kits.values())
