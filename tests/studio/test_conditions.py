"""The conditions of a mission in the tab Team: the radio, and robots that fail on a road."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.studio.test_team import OpenStudio, undo_all

pytestmark = pytest.mark.browser


@pytest.mark.thorough(
    "web/src/features/team/tab.test.tsx: the conditions, wrong ones and undone; in the file: tests/forms/test_pairs.py"
)
def test_radio_and_breakdown_are_set_saved_undone_and_refused_when_wrong(open_studio: OpenStudio) -> None:
    studio = open_studio("transport/transport.krt")
    studio.at("tab-of-team").click()
    studio.at("radio-on").check()
    studio.at("radio-range").fill("1500")
    studio.at("radio-range").press("Enter")
    studio.at("radio-loss").fill("a lot")
    expect(studio.at("radio-loss")).to_have_attribute("aria-invalid", "true")
    studio.at("radio-loss").press("Enter")
    expect(studio.at("radio-loss")).to_have_value("0")
    studio.at("radio-delay").fill("20")
    studio.at("breakdown-rule").select_option("tow")
    studio.at("breakdown-after").fill("2,5")
    studio.at("breakdown-after").press("Enter")
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("saved")
    text = (studio.folder / "transport.krt").read_text(encoding="utf-8")
    assert '<radio range="1500" delay="20"/>' in text
    assert '<breakdown rule="tow" after="2.5"/>' in text
    undo_all(studio)
    expect(studio.at("radio-on")).not_to_be_checked()
    expect(studio.at("breakdown-rule")).to_have_value("stay")
