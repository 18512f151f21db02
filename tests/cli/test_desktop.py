"""`kitrobot desktop`: the entry in the menu of a Linux desktop, put there and taken away."""

from __future__ import annotations

import configparser
import re
import shlex
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from kitrobot import __version__
from kitrobot.packaging import desktop_entry

ODD = 'my 100% "odd" $missions `here`\\there'


@pytest.fixture
def data(here, monkeypatch):
    """The user's data folder, not there yet."""
    monkeypatch.setenv("XDG_DATA_HOME", str(here / "data"))
    monkeypatch.setattr(sys, "platform", "linux")
    # Whether desktops keep lists of their own is another matter.
    monkeypatch.setattr(shutil, "which", lambda name: None)
    return here / "data"


def files(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def entry(data: Path) -> configparser.SectionProxy:
    read = configparser.RawConfigParser(delimiters="=", comment_prefixes="#")
    read.optionxform = str  # type: ignore[assignment,method-assign]
    read.read(data / "applications" / "kitrobot.desktop", encoding="utf-8")
    return read["Desktop Entry"]


def unescaped(value: str) -> str:
    return value.replace("\\\\", "\\")


@pytest.mark.skipif(sys.platform == "win32", reason="names that Windows has not")
def test_the_entry_begins_this_kitrobot_in_the_folder_and_is_removed_without_the_missions(kitrobot, here, data):
    missions = here / ODD
    assert kitrobot("desktop", "--install", missions).status == 0
    assert files(data) == [
        "applications/kitrobot.desktop",
        "icons/hicolor/scalable/apps/kitrobot.svg",
        "mime/packages/kitrobot.xml",
    ]
    made = entry(data)
    assert unescaped(made["Path"]) == str(missions)
    assert missions.is_dir()
    *command, file = shlex.split(unescaped(made["Exec"]))
    assert file == "%f"
    ran = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True)
    assert ran.stdout == f"kitrobot {__version__}\n"
    assert made["Comment[fr]"] != made["Comment"] != made["Comment[ur]"]
    kind = ET.parse(data / "mime" / "packages" / "kitrobot.xml").getroot()
    (glob,) = kind.iter("{http://www.freedesktop.org/standards/shared-mime-info}glob")
    assert glob.get("pattern") == "*.krt"
    assert made["MimeType"] == f"{kind[0].get('type')};"

    assert kitrobot("desktop", "--install", missions).status == 0, "once more, over the old one"
    (missions / "mine.krt").write_text("kept")
    assert kitrobot("desktop", "--remove").err.count(": removed") == 3
    assert files(data) == []
    assert (missions / "mine.krt").read_text() == "kept"
    assert kitrobot("desktop", "--remove").err == "there is no entry\n"


@pytest.mark.parametrize("name", [ODD, "plain", "a\nb"])
def test_quoting_is_undone_by_reading(name):
    quoted = desktop_entry._quoted(f"/opt/{name}/kitrobot")
    assert "\n" not in desktop_entry._escaped(quoted)
    assert re.fullmatch(r'"([^"`$\\]|\\["`$\\])*"', quoted), "as the specification has it"
    assert re.sub(r"\\(.)", r"\1", quoted[1:-1]).replace("%%", "%") == f"/opt/{name}/kitrobot"


def test_what_cannot_be_is_said_and_nothing_is_written(kitrobot, here, data, monkeypatch):
    assert kitrobot("desktop").status == 2
    assert kitrobot("desktop", "--install", "--remove").status == 2
    assert kitrobot("desktop", "--remove", here).status == 2
    (here / "file").write_text("no folder")
    said = kitrobot("desktop", "--install", here / "file" / "missions")
    assert said.status == 1
    assert "could not be made" in said.err
    monkeypatch.setattr(sys, "prefix", str(here / ".cache" / "uv" / "archive-v0" / "abc"))
    said = kitrobot("desktop", "--install")
    assert "only fetched for one use" in said.err
    assert "pipx install kitrobot" in said.err
    for system in ("win32", "darwin"):
        monkeypatch.setattr(sys, "platform", system)
        said = kitrobot("desktop", "--install")
        assert said.status == 1
        assert "Linux desktops only" in said.err
        assert "make a shortcut to `" in said.err
    assert not data.exists()


def test_a_data_folder_that_is_not_absolute_does_not_count(monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("XDG_DATA_HOME", "relative")
    expected = Path.home() / ".local" / "share" / "applications" / "kitrobot.desktop"
    assert desktop_entry.desktop_files().entry == expected


def test_the_icon_is_the_sign_of_the_page():
    page = Path(__file__).parents[2] / "web" / "src" / "theme" / "sign.svg"
    assert desktop_entry._SIGN.read_bytes() == page.read_bytes()
