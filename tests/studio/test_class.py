"""A class in the browser: a pupil joins, works and is seen; a kill in the middle loses nothing.

What each press does on either page: `web/src/features/class`; what the class answers: `tests/server/classes`.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.patience import PATIENCE_S, STATE_MS
from tests.studio.conftest import HEIGHT, WIDTH
from tests.studio.looks import find_nothing
from tests.studio.studio_page import place_of
from tests.studio.tabs import KEEP_TEXT

pytestmark = pytest.mark.browser

SQUARE = "example:exercises/03-square.exercise.xml"


class Class:
    """The process of a class on a folder, started again at the same port after a kill."""

    def __init__(self, browser: Browser, folder: Path, state: Path, *options: str) -> None:
        self._browser = browser
        self.folder = folder
        self._state = state
        self._options = options
        self._port = "0"
        self.faults: list[str] = []
        self.pages: list[Page] = []
        self.start()

    def start(self) -> None:
        command = [sys.executable, "-m", "kitrobot", "class", str(self.folder), "--no-browser", "--port", self._port]
        command += self._options
        environment = {**os.environ, "KITROBOT_STATE": str(self._state)}
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment
        )
        assert self.process.stdout is not None
        self.teacher = self.process.stdout.readline().strip()
        found = re.match(r"http://127\.0\.0\.1:(\d+)/", self.teacher)
        assert found is not None
        self.address, self._port = found.group(0), found.group(1)

    @property
    def code(self) -> str:
        return str(tomllib.loads((self.folder / "class.toml").read_text())["code"])

    def kill(self) -> None:
        """Ends it as a power cut would."""
        self.process.kill()
        self.process.wait(PATIENCE_S)
        assert self.process.stdout is not None
        self.process.stdout.close()

    def page(self, address: str, language: str = "en") -> Page:
        """A page of a browser that was never here."""
        context = self._browser.new_context(
            viewport={"width": WIDTH, "height": HEIGHT}, reduced_motion="reduce", locale=language
        )
        context.add_init_script(KEEP_TEXT)
        context.set_default_timeout(STATE_MS)
        page = context.new_page()
        page.on("pageerror", lambda error: self.faults.append(str(error)))
        page.goto(address)
        self.pages.append(page)
        return page

    def join(self, name: str, language: str = "en") -> Page:
        """A pupil's page, with the studio open."""
        page = self.page(self.address, language)
        page.get_by_test_id("join-code").fill(self.code.lower())
        page.get_by_test_id("join-name").fill(name)
        page.get_by_test_id("join-go").click()
        expect(page.get_by_test_id("class-hand")).to_be_visible()
        return page

    def close(self) -> None:
        for page in self.pages:
            page.context.close()
        self.kill()


@pytest.fixture
def school(browser: Browser, tmp_path: Path) -> Iterator[Class]:
    made = Class(browser, tmp_path / "Class 5b", tmp_path / "state")
    yield made
    made.close()
    assert made.faults == [], "the page reported errors of its own"


def add_part(page: Page, words: str) -> None:
    """Puts a part into the program with the keyboard."""
    expect(page.locator(".studio")).to_have_attribute("aria-busy", "false")
    page.get_by_test_id("canvas").click()
    page.keyboard.press("/")
    page.keyboard.type(words)
    page.keyboard.press("Enter")


def expect_kept(page: Page, how: str = "yes") -> None:
    expect(page.get_by_test_id("class-kept")).to_have_attribute("data-kept", how)


def a_class_without_pupils_fits_a_narrow_page(teacher: Page, code: str) -> None:
    expect(teacher.get_by_test_id("class-empty")).to_contain_text("Nobody is here yet")
    expect(teacher.get_by_test_id("class-code")).to_have_text(f"{code[:3]} {code[3:]}")
    teacher.set_viewport_size({"width": 390, "height": HEIGHT})
    assert teacher.evaluate("document.querySelector('.class-main').scrollWidth") <= 390
    box = place_of(teacher.get_by_test_id("class-join"))
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= 390
    teacher.set_viewport_size({"width": WIDTH, "height": HEIGHT})
    find_nothing(teacher, "a class without pupils")


def a_wrong_code_is_said_in_the_pupils_language_and_the_right_one_lets_in(school: Class) -> Page:
    pupil = school.page(school.address, "fr")
    pupil.get_by_test_id("join-code").fill("AAAAAA")
    pupil.get_by_test_id("join-name").fill("Zoé")
    pupil.get_by_test_id("join-go").click()
    expect(pupil.get_by_test_id("join-failure")).to_contain_text("Ce n'est pas le code de cette classe.")
    find_nothing(pupil, "coming in")
    pupil.get_by_test_id("join-code").fill(school.code.lower())
    pupil.get_by_test_id("join-go").click()
    expect(pupil.get_by_test_id("class-hand")).to_be_visible()
    return pupil


def the_exercise_is_chosen(teacher: Page) -> None:
    teacher.get_by_test_id("change-exercise").click()
    teacher.locator(f"[data-path='{SQUARE}']").click()


def the_exercise_opens_and_what_is_made_of_it_comes_in(school: Class, teacher: Page, pupil: Page) -> None:
    card = teacher.get_by_test_id("card-Zoé")
    expect(pupil.get_by_test_id("exercise")).to_be_visible()
    add_part(pupil, "stop")
    expect_kept(pupil)
    assert (school.folder / "Zoé" / "03-square.krt").is_file()
    expect(card.locator(".class-picture .picture-node")).to_have_count(1)
    pupil.get_by_test_id("run-button").click()
    expect(card.locator('.class-box[data-met="true"]').first).to_be_visible()


def a_pupil_asks_for_help_and_gets_a_few_words(teacher: Page, pupil: Page) -> None:
    card = teacher.get_by_test_id("card-Zoé")
    pupil.get_by_test_id("class-hand").click()
    expect(card).to_have_attribute("data-state", "asks")
    card.focus()
    teacher.keyboard.press("Enter")
    teacher.get_by_test_id("write").fill("Look at the turn")
    teacher.get_by_test_id("write").press("Enter")
    expect(pupil.get_by_test_id("class-note")).to_contain_text("Look at the turn")
    expect(pupil.get_by_test_id("class-looked")).to_be_visible()
    # The arena of the pupil's page is seen, with the robot where it is.
    expect(teacher.get_by_test_id("look-arena").locator(".picture-robot")).to_have_count(1)
    find_nothing(teacher, "a class, looking at one")


def what_is_written_on_the_exercise_stands_beside_it_and_who_was_there_takes_the_hand_down(
    teacher: Page, pupil: Page
) -> None:
    teacher.get_by_test_id("comment").fill("A fine square")
    teacher.get_by_test_id("comment").press("Enter")
    expect(pupil.get_by_test_id("exercise-comment")).to_contain_text("A fine square")
    find_nothing(pupil, "a pupil with a word of the teacher's")
    teacher.get_by_test_id("look").get_by_role("button", name="I was there").click()
    expect(pupil.get_by_test_id("class-hand")).to_have_attribute("aria-pressed", "false")
    teacher.get_by_test_id("look-freeze").click()
    expect(pupil.get_by_test_id("class-frozen")).to_be_visible()
    find_nothing(pupil, "a frozen pupil")
    expect(teacher.get_by_test_id("card-Zoé")).to_have_attribute("data-frozen", "true")
    teacher.get_by_test_id("look-freeze").click()
    expect(pupil.get_by_test_id("class-frozen")).to_have_count(0)


def the_teacher_edits_once_the_pupil_lets_in(school: Class, teacher: Page, pupil: Page) -> None:
    teacher.get_by_test_id("ask-to-edit").click()
    pupil.get_by_test_id("class-let-edit").click()
    expect(pupil.get_by_test_id("class-take-back")).to_be_visible()
    assert pupil.locator(".middle").evaluate("(one) => one.inert")
    edit = teacher.get_by_test_id("edit").get_attribute("href")
    studio = school.page(f"{school.address}{edit}")
    add_part(studio, "stop")
    studio.keyboard.press("Control+s")
    expect(studio.get_by_test_id("saved-state")).to_have_text("saved")
    studio.close()
    # What was saved comes back as one step, and is handed in.
    teacher.get_by_test_id("give-back").click()
    expect(pupil.get_by_test_id("class-take-back")).to_have_count(0)
    expect(teacher.get_by_test_id("card-Zoé").locator(".class-picture .picture-node")).to_have_count(2)
    assert [path.name for path in (school.folder / "Zoé").glob("*.krt")] == ["03-square.krt"]


def where_all_are_frozen_nothing_can_be_typed_but_stop_is_there(teacher: Page, pupil: Page) -> None:
    teacher.get_by_test_id("freeze").click()
    expect(pupil.get_by_test_id("class-frozen")).to_be_visible()
    expect(teacher.get_by_test_id("freeze")).to_have_attribute("aria-pressed", "true")
    pupil.keyboard.press("Control+z")
    assert pupil.locator(".middle").evaluate("(one) => one.inert")
    pupil.get_by_test_id("team-stop").click()
    teacher.get_by_test_id("freeze").click()
    expect(pupil.get_by_test_id("class-frozen")).to_have_count(0)
    assert not pupil.locator(".middle").evaluate("(one) => one.inert")


def a_mission_for_all_is_offered_and_all_work_is_collected(teacher: Page, pupil: Page) -> None:
    teacher.keyboard.press("Escape")
    expect(teacher.get_by_test_id("look")).to_have_count(0)
    teacher.get_by_test_id("send").click()
    teacher.locator("[data-path='example:blink/blink.krt']").click()
    # Something is unsaved, so it does not open by itself.
    expect(pupil.get_by_test_id("class-handed")).to_contain_text("blink")
    with teacher.expect_download() as downloaded:
        teacher.get_by_test_id("collect").click()
    assert downloaded.value.suggested_filename == "Class 5b.zip"


def a_kill_in_the_middle_loses_nothing(school: Class, pupil: Page) -> None:
    school.kill()
    expect_kept(pupil, "here")
    # The page goes on; what is done meanwhile is handed in when the class is back.
    pupil.get_by_test_id("canvas").click()
    pupil.keyboard.press("Control+z")
    expect_kept(pupil, "here")
    school.start()
    expect_kept(pupil)
    (kept,) = (school.folder / "Zoé").glob("*.krt")
    assert "Motor.Stop" not in kept.read_text()


def a_pupil_comes_back_from_another_computer(school: Class) -> None:
    """The name is taken, the word brings the pupil back to what was made."""
    other = school.page(school.address)
    other.get_by_test_id("join-code").fill(school.code)
    other.get_by_test_id("join-name").fill("zoé")
    other.get_by_test_id("join-go").click()
    expect(other.get_by_test_id("join-taken")).to_be_visible()
    find_nothing(other, "a name that is taken")
    word = tomllib.loads((school.folder / "class.toml").read_text())["pupil"][0]["word"]
    other.get_by_test_id("join-word").fill(word)
    other.get_by_test_id("join-go").click()
    expect(other.get_by_test_id("class-hand")).to_be_visible()
    expect(other.get_by_role("heading", level=1)).to_contain_text("03-square")


def test_a_pupil_joins_works_is_seen_is_frozen_and_loses_nothing_by_a_kill(school: Class) -> None:
    teacher = school.page(school.teacher)
    the_exercise_is_chosen(teacher)
    pupil = school.join("Zoé")
    the_exercise_opens_and_what_is_made_of_it_comes_in(school, teacher, pupil)
    a_pupil_asks_for_help_and_gets_a_few_words(teacher, pupil)
    where_all_are_frozen_nothing_can_be_typed_but_stop_is_there(teacher, pupil)
    a_kill_in_the_middle_loses_nothing(school, pupil)


@pytest.mark.thorough(
    "the test above; web/src/features/class/pupil.test.tsx, Join.test.tsx and teacher/Teacher.test.tsx press the same; "
    "tests/server/classes/test_class.py: what each page is told"
)
def test_a_teacher_comments_edits_hands_out_and_collects_and_a_pupil_comes_back_from_another_computer(
    school: Class,
) -> None:
    teacher = school.page(school.teacher)
    a_class_without_pupils_fits_a_narrow_page(teacher, school.code)
    the_exercise_is_chosen(teacher)
    pupil = a_wrong_code_is_said_in_the_pupils_language_and_the_right_one_lets_in(school)
    the_exercise_opens_and_what_is_made_of_it_comes_in(school, teacher, pupil)
    a_pupil_asks_for_help_and_gets_a_few_words(teacher, pupil)
    what_is_written_on_the_exercise_stands_beside_it_and_who_was_there_takes_the_hand_down(teacher, pupil)
    the_teacher_edits_once_the_pupil_lets_in(school, teacher, pupil)
    a_mission_for_all_is_offered_and_all_work_is_collected(teacher, pupil)
    a_pupil_comes_back_from_another_computer(school)
