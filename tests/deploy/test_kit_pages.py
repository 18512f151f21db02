"""docs/kits.md and its pictures say what the kits are; every program of the gallery runs on one of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tools import kit_pages
from tools.microbit_kits import small_kits

Runs = dict[str, dict[str, str]]
"""By mission and kit, what is missing."""


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Runs:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("nobody")))
        return kit_pages.what_runs(kit_pages.shown_kits())


@pytest.fixture(scope="module")
def made(runs: Runs, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Mapping[Path, str]]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("nobody")))
        yield kit_pages.pages(runs)


def test_the_page_and_the_pictures_are_current(made: Mapping[Path, str]) -> None:
    assert [path.name for path in kit_pages.stale(made)] == [], "write them with `python -m tools.kit_pages`"


def test_what_was_measured_is_of_missions_that_the_kits_have_all_parts_for(runs: Runs) -> None:
    found = kit_pages.measured_2016()
    for mission, row in runs.items():
        for kit in small_kits():
            assert (kit in found.get(mission, {})) == (row[kit] == ""), f"{mission} on {kit}: measure it again"


def test_every_program_of_the_gallery_runs_on_a_kit(made: Mapping[Path, str]) -> None:
    lines = made[kit_pages.PAGE].partition("## Which program runs on which kit")[2].partition("\n## ")[0].splitlines()
    table = [line for line in lines if line.startswith("| ") and "](#" not in line]
    assert len(table) >= 30
    assert [row for row in table if " yes |" not in row] == []


def test_a_picture_shows_every_wire_once_at_its_pin(made: Mapping[Path, str]) -> None:
    (text,) = (text for path, text in made.items() if path.suffix == ".svg")
    root = ElementTree.fromstring(text)
    space = "{http://www.w3.org/2000/svg}"
    wires = list(root.iter(f"{space}path"))
    words = [one.text for one in root.iter(f"{space}text")]
    modules = kit_pages.shown_kits()[1].modules
    assert len(wires) == sum(len(module.wires) for module in modules)
    for name, pin in (("AIN1", "GP2"), ("PWMA", "GP4"), ("Trig", "GP14"), ("Echo", "GP15")):
        assert words[words.index(name) + 1] == pin
