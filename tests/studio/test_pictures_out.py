"""A user keeps the graph as a picture, and opens the picture again: the mission is in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]


def export(studio: Studio, kind: str, folder: Path) -> Path:
    with studio.page.expect_download() as waiting:
        studio.at("menu-File").click()
        studio.at(f"menu-file-export-{kind}").click()
    path = folder / waiting.value.suggested_filename
    waiting.value.save_as(path)
    return path


def test_an_exported_picture_is_opened_again_from_the_menu_and_runs(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = open_studio("transport/transport.krt")
    kept = [export(studio, kind, tmp_path) for kind in ("svg", "png", "pdf")]
    for path in kept:
        studio.new_mission()
        expect(studio.at("first-place")).to_be_visible()
        studio.page.keyboard.press("Control+o")
        studio.at("open-file").set_input_files(path)
        expect(studio.at("tab-store-manager-A")).to_be_visible()
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()


def the_svg_shows_every_vertex_in_words(studio: Studio, tmp_path: Path) -> None:
    text = export(studio, "svg", tmp_path).read_text(encoding="utf-8")
    assert text.count(">On</text>") == 1
    assert text.count(">Wait</text>") == 3
    assert ">Run is true</text>" in text
    assert ">At the same time</text>" in text
    assert "var(" not in text


def a_picture_without_a_mission_is_told_and_changes_nothing(studio: Studio, tmp_path: Path) -> None:
    studio.expect_code("Light.LightOn")
    before = studio.code()
    path = tmp_path / "cat.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', encoding="utf-8")
    studio.page.keyboard.press("Control+o")
    studio.at("open-file").set_input_files(path)
    expect(studio.page.get_by_text("is a picture without a mission inside")).to_be_visible()
    assert studio.code() == before
    studio.faults[:] = [fault for fault in studio.faults if "400" not in fault and "422" not in fault]


def test_an_svg_shows_every_vertex_in_words_and_one_without_a_mission_is_told(
    open_studio: OpenStudio, tmp_path: Path
) -> None:
    studio = open_studio("blink/blink.krt")
    the_svg_shows_every_vertex_in_words(studio, tmp_path)
    a_picture_without_a_mission_is_told_and_changes_nothing(studio, tmp_path)
