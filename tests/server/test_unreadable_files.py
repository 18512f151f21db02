"""One file of the folder that cannot be read spoils nothing else: lists name it and say why, nobody waits for it."""

from __future__ import annotations

import os
import socket
import sys

import pytest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="files of POSIX")


def out(folder, name):
    (folder.parent / "elsewhere").write_text("<kitrobot version='1'/>")
    (folder / name).symlink_to(folder.parent / "elsewhere")


def nowhere(folder, name):
    (folder / name).symlink_to(folder / "missing")


def round_about(folder, name):
    (folder / name).symlink_to(folder / name)


def pipe(folder, name):
    os.mkfifo(folder / name)


def listening(folder, name):
    where = os.getcwd()
    os.chdir(folder)  # a socket's whole path has a hundred letters at most
    try:
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(name)
    finally:
        os.chdir(where)


def device(folder, name):
    (folder / name).symlink_to("/dev/zero")


def no_text(folder, name):
    with open(os.fsencode(folder) + b"/\xff" + name.encode(), "wb"):
        pass


ODD = [
    (out, "leads out"),
    (nowhere, "o such file"),
    (round_about, ""),
    (pipe, "is a pipe"),
    (listening, "is a socket"),
    (device, "leads out"),
    (no_text, "not text in UTF-8"),
]
LISTS = [("/api/missions", "odd.krt"), ("/api/traces", "odd.krtrace")]


@pytest.mark.parametrize(("make", "why"), ODD)
@pytest.mark.parametrize(("address", "name"), LISTS)
def test_a_list_says_what_of_it_cannot_be_opened_and_why(page, folder, make, why, address, name):
    before = page.get(address).json()
    make(folder, name)
    listed = page.get(address)
    assert listed.status_code == 200
    odd = [one for one in listed.json() if name in one["path"]]
    assert [one for one in listed.json() if one not in odd] == before
    assert len(odd) == 1
    assert why in odd[0]["problem"]
    assert odd[0]["problem"]


@pytest.mark.parametrize(("make", "why"), ODD)
def test_a_tutorial_that_cannot_be_read_is_listed_with_its_mistake(page, folder, make, why):
    before = page.get("/api/tutorials").json()
    make(folder, "odd.tutorial.xml")
    listed = page.get("/api/tutorials")
    assert listed.status_code == page.get("/api/missions").status_code == 200
    odd = [one for one in listed.json() if "odd" in one["name"]]
    assert [one for one in listed.json() if one not in odd] == before
    assert len(odd[0]["problems"]) == 1


@pytest.mark.parametrize("name", ["odd.krt", "odd.krtrace", "odd.xml", "odd.robot.xml", "odd.world.xml"])
@pytest.mark.parametrize(("make", "why"), ODD)
def test_what_cannot_be_read_is_a_sentence_and_the_mission_beside_it_opens(page, folder, make, why, name):
    make(folder, name)
    for address in (f"trace?path={name}", f"mission?path={name}", f"world/plan?path=blink.krt&href={name}"):
        answer = page.get(f"/api/{address}")
        assert answer.status_code < 500
    for address in ("mission?path=blink.krt", "catalogue?path=blink.krt", "worlds?path=blink.krt", "journal/left"):
        assert page.get(f"/api/{address}").status_code == 200
