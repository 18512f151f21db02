"""A program of a whole team in the studio: drawn with its own parts, edited, saved as what it is, and run."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]


@pytest.mark.thorough("test_team_view.py: test_a_team_s_program_is_changed_saved_run_and_its_members_are_followed")
def test_a_team_s_program_is_drawn_edited_saved_and_run(open_studio: OpenStudio) -> None:
    studio = open_studio("convoy/convoy.krt")
    studio.expect_code("SeqOfPar convoy (")
    expect(studio.page.locator(".vertex.is-unknown")).to_have_count(0)
    expect(studio.at("part-SeqOfPar")).to_be_visible()
    studio.page.locator(".vertex", has_text="Each on its own").first.click()
    expect(studio.page.locator(".vertex.is-selected")).to_have_count(1)
    studio.page.keyboard.press("Control+d")
    expect(studio.at("saved-state")).to_have_text("not saved")
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("saved")
    saved = (studio.folder / "convoy.krt").read_text(encoding="utf-8")
    assert '<program name="convoy" level="social">' in saved
    assert saved.count('element="ParOfSeq"') == 3
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(studio.at("status")).to_contain_text("robot-2 failed")


@pytest.mark.thorough(
    "test_team_view.py: what_is_typed_before_the_instructions_is_declared_and_saved; undone: "
    "web/src/session/typing.test.ts"
)
def test_what_is_typed_before_the_instructions_is_declared_and_undone(open_studio: OpenStudio) -> None:
    studio = open_studio("convoy/convoy.krt")
    studio.expect_code("role follower: mini-robot 2;")
    studio.edit_code()
    studio.page.keyboard.press("Control+Home")
    studio.page.keyboard.type("work Stones = 3;\n")
    expect(studio.at("saved-state")).to_have_text("not saved")
    studio.at("canvas").focus()
    studio.expect_code("work Stones = 3;")
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("saved")
    assert '<work name="Stones" units="3"/>' in (studio.folder / "convoy.krt").read_text(encoding="utf-8")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("code")).not_to_contain_text("Stones")
