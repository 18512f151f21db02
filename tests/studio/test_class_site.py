"""A class with a static site: programs run in the pupils' pages, which go on without the teacher's machine.

One test of the thorough profile, because a page with Python in it takes seconds to begin.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.sites import made_site
from tests.studio.test_class import Class, add_part, expect_kept

pytestmark = [
    pytest.mark.browser,
    pytest.mark.site,
    pytest.mark.thorough(
        "test_class.py with studios at the teacher's; what pages get: server/classes/test_class_site.py; Python in a "
        "page: test_site.py; what one pupil leaves for another: web/src/features/class/left.test.ts"
    ),
]

OWN = "mine.exercise.xml"
HOMES = "async () => (await indexedDB.databases()).map(({ name }) => name).filter((name) => name.startsWith('/home'))"


@pytest.fixture
def school(browser: Browser, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Class]:
    site = made_site(tmp_path_factory.getbasetemp())
    folder = tmp_path / "Class 5b"
    folder.mkdir()
    (folder / "mine.krt").write_text((Path("examples") / "exercises" / "03-square.krt").read_text())
    (folder / OWN).write_text(
        '<exercise version="1" start="mine.krt"><label>My own</label><done><label>It ends</label></done></exercise>'
    )
    made = Class(browser, folder, tmp_path / "state", "--site", str(site))
    yield made
    made.close()
    assert made.faults == [], "the page reported errors of its own"


def run(page: Page) -> None:
    page.get_by_test_id("run-button").click()
    expect(page.get_by_test_id("status")).to_have_attribute("data-status", "done")


def test_pupils_run_in_their_own_pages_without_the_teachers_machine_and_nothing_of_one_is_left_for_another(
    school: Class,
) -> None:
    teacher = school.page(school.teacher)
    pupil = school.join("Ada")
    pupil.get_by_test_id("new-name").press("Escape")
    teacher.get_by_test_id("change-exercise").click()
    teacher.locator(f"[data-path='{OWN}']").click()
    # The exercise of the teacher's own came with its mission into the studio of the page, which nobody else asks.
    expect(pupil.get_by_test_id("exercise")).to_contain_text("My own")
    add_part(pupil, "stop")
    expect_kept(pupil)
    run(pupil)
    expect(teacher.get_by_test_id("card-Ada").locator('.class-box[data-met="true"]')).to_have_count(1)
    assert not (school.folder / ".studios").exists()
    # Without the teacher's machine everything goes on, and is handed in when it is back.
    school.kill()
    expect_kept(pupil, "here")
    add_part(pupil, "stop")
    run(pupil)
    school.start()
    expect_kept(pupil)
    (kept,) = (school.folder / "Ada").glob("*.krt")
    assert kept.read_text().count("Motor.Stop") == 2
    # Who comes next at this computer finds nothing of this one.
    (first,) = pupil.evaluate(HOMES)
    pupil.get_by_test_id("class-me").click()
    pupil.get_by_test_id("menu-class-leave").click()
    pupil.get_by_test_id("join-code").fill(school.code)
    pupil.get_by_test_id("join-name").fill("Ben")
    pupil.get_by_test_id("join-go").click()
    expect(pupil.get_by_test_id("exercise")).to_contain_text("My own")
    expect(pupil.locator(".vertex", has_text="Stop turning")).to_have_count(0)
    assert first not in pupil.evaluate(HOMES)
