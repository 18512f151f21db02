"""No path leads out of the folder of missions: nothing outside is read, written or checked."""

from __future__ import annotations

import os

import pytest

from tests.server.conftest import SHORT
from tests.server.test_missions import opened

OUTSIDE = [
    "",
    ".krt",
    "..krt",
    "/etc/passwd",
    "/etc/x.krt",
    "../secret.krt",
    "sub/../../secret.krt",
    "..\\secret.krt",
    "C:\\secret.krt",
    "C:secret.krt",
    "blink.krt\0.txt",
    "blink.txt",
    "note",
    "example:../../secret.krt",
    "example:/etc/x.krt",
    "example:",
    "link-out.krt",
    "folder-out/secret.krt",
    "~/x.krt/../../secret.krt",
    "x" * 999 + "é.krt",
    "loop.krt",
]


@pytest.fixture
def secret(folder):
    """A mission outside the folder, and links that lead to it."""
    secret = folder.parent / "secret.krt"
    secret.write_text(SHORT)
    os.symlink(secret, folder / "link-out.krt")
    os.symlink(folder.parent, folder / "folder-out")
    os.symlink(folder / "loop.krt", folder / "loop.krt")
    return secret


@pytest.mark.parametrize("path", OUTSIDE)
def test_nothing_outside_the_folder_is_read(page, secret, path):
    answer = page.get("/api/mission", params={"path": path})
    assert answer.status_code in (403, 404, 422)
    assert "mission" not in answer.json()


@pytest.mark.parametrize("path", OUTSIDE)
def test_nothing_outside_the_folder_is_written(page, secret, path):
    mission = opened(page)["mission"]
    mission["programs"][0]["name"] = "changed"
    mission["agents"] = []
    answer = page.put("/api/mission", json={"path": path, "revision": "", "mission": mission})
    assert answer.status_code in (403, 409, 422)
    assert secret.read_text() == SHORT


@pytest.mark.parametrize("path", OUTSIDE[1:])
def test_checking_takes_no_path_outside_the_folder(page, secret, path):
    mission = opened(page)["mission"]
    assert page.post("/api/check", json={"mission": mission, "path": path}).status_code == 403


def test_links_out_of_the_folder_are_not_listed_as_ways_in(page, secret):
    assert "folder-out/secret.krt" not in [entry["path"] for entry in page.get("/api/missions").json()]
