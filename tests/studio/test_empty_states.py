"""What is empty says what to do next: the arena, the code, the problems, the inspector, a new program."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]


def open_as(studio: Studio, name: str, text: str) -> None:
    """Puts a mission into the folder and opens it."""
    (studio.folder / name).write_text(text, encoding="utf-8")
    studio.page.keyboard.press("Control+o")
    studio.page.locator(f'[data-path="{name}"]').click()
    expect(studio.page.locator(".title")).to_contain_text(name)


def an_arena_without_robots_or_without_a_world_says_what_to_do(studio: Studio) -> None:
    expect(studio.at("arena-empty")).to_have_count(0)
    text = (studio.folder / "blink.krt").read_text(encoding="utf-8")
    before, _, rest = text.partition("  <team>")
    _, _, after = rest.partition("</team>\n")
    open_as(studio, "nobody.krt", before + after)
    expect(studio.at("arena-empty")).to_contain_text("No robot is here yet.")
    open_as(studio, "nowhere.krt", text.replace("</kitrobot>", '  <world href="moon.world.xml"/>\n</kitrobot>'))
    expect(studio.at("arena-empty")).to_contain_text("There is no world to show.")


def a_new_program_says_what_to_do_in_each_panel(studio: Studio) -> None:
    studio.new_mission()
    expect(studio.page.locator(".teaching")).to_contain_text("Give the robot its first step")
    expect(studio.at("code")).to_contain_text("Your program appears here.")
    expect(studio.page.locator(".side-inspector")).to_contain_text("Click a part to set its speed")
    studio.at("problems").click()
    expect(studio.page.locator("#problem-list")).to_contain_text("Press Run to see the program at work.")


@pytest.mark.thorough(
    "web/src/features/canvas/FirstSteps.test.tsx, features/arena/EmptyArena.test.tsx, "
    "features/problems/ProblemList.test.tsx and features/inspector/Inspector.test.tsx"
)
def test_an_arena_without_robots_or_world_and_a_new_program_say_what_to_do_in_each_panel(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("blink/blink.krt")
    an_arena_without_robots_or_without_a_world_says_what_to_do(studio)
    a_new_program_says_what_to_do_in_each_panel(studio)
