"""A user edits a graph by hand: clipboard, menus, wrapping, finding, folding — with mouse, keyboard and finger."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"


def vertex(studio: Studio, words: str) -> Locator:
    """The first vertex of the graph that says that."""
    return studio.page.locator(".vertex", has_text=words).first


def allow_clipboard(studio: Studio) -> None:
    studio.page.context.grant_permissions(["clipboard-read", "clipboard-write"])


def clipboard(studio: Studio) -> str:
    return str(studio.page.evaluate("navigator.clipboard.readText()"))


def paste(studio: Studio, text: str) -> None:
    """Puts a text on the clipboard, as another program would, and presses the keys."""
    studio.page.evaluate("text => navigator.clipboard.writeText(text)", text)
    studio.page.keyboard.press("Control+v")


def add_two_parts(studio: Studio) -> None:
    """A Wait and a lamp at the beginning of the program in view, in this order."""
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")


def test_copied_parts_are_lll_text_and_paste_into_another_program(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    allow_clipboard(studio)
    add_two_parts(studio)
    vertex(studio, "Wait").click()
    studio.page.keyboard.press("Control+c")
    assert clipboard(studio) == "WAIT(10);\n"
    studio.at("tab-store-manager-A").click()
    expect(studio.at("code")).not_to_contain_text("WAIT(10);")
    studio.page.get_by_test_id("vertex-start").click()
    studio.page.keyboard.press("Control+v")
    studio.expect_code("WAIT(10);")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("code")).not_to_contain_text("WAIT(10);")


def test_cut_takes_away_and_paste_puts_back(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    allow_clipboard(studio)
    add_two_parts(studio)
    vertex(studio, "Wait").click()
    studio.page.keyboard.press("Control+x")
    expect(studio.at("code")).not_to_contain_text("WAIT(10);")
    studio.page.keyboard.press("Control+v")
    studio.expect_code("WAIT(10);")


def test_lll_typed_elsewhere_pastes_as_parts(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    allow_clipboard(studio)
    studio.at("vertex-start").click()
    paste(studio, "# hello\n3*(WAIT(77););")
    studio.expect_code("# hello")
    studio.expect_code("3*( WAIT(77); );")


def test_pasted_rubbish_is_told_in_a_sentence_and_changes_nothing(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    allow_clipboard(studio)
    before = studio.code()
    studio.at("vertex-start").click()
    paste(studio, "Dear all, please find attached")
    expect(studio.at("said")).to_contain_text("no program text")
    paste(studio, "*[Run.IsTrue()](" * 10_000)
    expect(studio.at("said")).to_be_visible()
    assert studio.code() == before
    expect(studio.at("saved-state")).to_have_text("saved")
