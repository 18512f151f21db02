"""A link to an exercise in the browser: copied by the teacher, it lets a pupil in, opens the exercise, and hands in.

What a link opens in which state: `web/src/features/class/linked.test.ts`; who gets one: `tests/server/classes`.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from kitrobot.classroom.record import read_record
from tests.studio.looks import find_nothing
from tests.studio.test_class import SQUARE, Class, add_part, expect_kept

pytestmark = pytest.mark.browser


@pytest.fixture
def school(browser: Browser, tmp_path: Path) -> Iterator[Class]:
    made = Class(browser, tmp_path / "Class 5b", tmp_path / "state")
    yield made
    made.close()
    assert made.faults == [], "the page reported errors of its own"


def copied_link(teacher: Page) -> str:
    """The link to the square, as it is on the clipboard and on the teacher's page."""
    teacher.context.grant_permissions(["clipboard-read", "clipboard-write"])
    teacher.get_by_test_id("change-exercise").click()
    teacher.locator(f"[data-link='{SQUARE}']").click()
    place = teacher.get_by_test_id("exercise-link")
    expect(place).to_contain_text("The link to A square is copied")
    find_nothing(teacher, "a link to an exercise")
    link = str(teacher.evaluate("navigator.clipboard.readText()"))
    expect(place.locator("code")).to_have_text(link)
    return link


def joined_by(school: Class, link: str, name: str) -> Page:
    pupil = school.page(link)
    expect(pupil.get_by_test_id("join-code")).to_have_value(school.code)
    expect(pupil.get_by_test_id("join-name")).to_be_focused()
    pupil.keyboard.type(name)
    pupil.keyboard.press("Enter")
    return pupil


def expect_square(pupil: Page) -> None:
    expect(pupil.get_by_test_id("exercise")).to_be_visible()
    expect(pupil.locator(".studio")).to_have_attribute("aria-busy", "false")
    assert "#" not in pupil.url


def test_a_link_lets_a_pupil_in_opens_the_exercise_and_hands_in_what_is_opened_again(school: Class) -> None:
    link = copied_link(school.page(school.teacher))
    pupil = joined_by(school, link, "Ada")
    expect_square(pupil)
    add_part(pupil, "stop")
    pupil.get_by_test_id("exercise-hand-in").click()
    expect(pupil.get_by_test_id("banner")).to_contain_text("Handed in to Class 5b: 03-square.krt.")
    expect_kept(pupil)
    record = read_record(school.folder)
    assert record is not None
    assert record.pupils[0].works == {SQUARE: "03-square.krt"}
    handed = (school.folder / "Ada" / "03-square.krt").read_text()
    assert "Motor.Stop" in handed
    # Somewhere else the link opens what was handed in, and leaves it as it is.
    other = joined_by(school, link, "Ada")
    other.get_by_test_id("join-word").fill(record.pupils[0].word)
    other.get_by_test_id("join-go").click()
    expect_square(other)
    expect(other.get_by_test_id("canvas")).to_contain_text("Stop")
    # A link of another class opens nothing, whatever is open stays.
    other.goto(link.replace("Class%205b", "Class%206a"))
    expect(other.get_by_test_id("banner")).to_contain_text("This link is for Class 6a, and this is Class 5b.")
    expect_square(other)
    assert [one.name for one in (school.folder / "Ada").glob("*.krt")] == ["03-square.krt"]
    assert (school.folder / "Ada" / "03-square.krt").read_text() == handed
