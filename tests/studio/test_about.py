"""*About* says what is inside and under which licence; the canvas carries no mark of it."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser


def test_about_names_what_is_inside_and_leads_to_the_licences(open_studio: Callable[..., Studio]) -> None:
    studio = open_studio("blink/blink.krt")
    studio.at("menu-Help").click()
    studio.at("menu-help-about").click()
    about = studio.at("about-dialog")
    expect(about).to_contain_text("Apache License 2.0")
    find_nothing(studio, "about")
    with studio.page.expect_popup() as opened:
        about.get_by_role("link", name="Licences").click()
    assert "@codemirror/view" in opened.value.content()
    assert opened.value.url.endswith("/licenses.md")
