"""A run is saved as a recording, which is dropped, opened and played in the studio like a run."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

import kitrobot
from tests.studio.conftest import EXAMPLES, LOOKS, Studio
from tests.studio.looks import choose, find_nothing

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
PAUSED, DONE = re.compile("^paused$"), re.compile("^done$")
DROP = """([name, content]) => {
  const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
  const data = new DataTransfer();
  data.items.add(new File([bytes], name));
  const target = document.querySelector('.studio');
  for (const type of ["dragover", "drop"]) {
    target.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
  }
}"""


def drop(studio: Studio, name: str, content: bytes) -> None:
    studio.page.evaluate(DROP, [name, base64.b64encode(content).decode()])


def recorded(folder: Path, seed: int = 4) -> bytes:
    path = folder / "made.krtrace"
    kitrobot.open(EXAMPLES / "transport" / "transport.krt").run(seed=seed, trace=path)
    return path.read_bytes()


def value(studio: Studio, attribute: str) -> int:
    return int(studio.at("event-strip").get_attribute(attribute) or "-1")


def expect_tick(studio: Studio, wanted: int) -> None:
    expect(studio.at("event-strip")).to_have_attribute("aria-valuenow", str(wanted))


def held(studio: Studio) -> int:
    """Pauses the recording, and gives the tick that it stands at."""
    studio.at("pause-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", PAUSED)
    return value(studio, "aria-valuenow")


def test_a_dropped_recording_plays_is_stepped_sought_and_run_live(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = open_studio("blink/blink.krt")
    # So slowly that it does not end before it is paused, however busy the machine is.
    studio.at("speed").press("Home")
    drop(studio, "bug.krtrace", recorded(tmp_path))
    bar = studio.at("recording-bar")
    expect(bar).to_contain_text("bug.krt, seed 4")
    expect(studio.at("tab-carrier")).to_be_visible()
    expect(studio.at("saved-state")).to_have_text("from a recording")
    at = held(studio)
    latest = value(studio, "aria-valuemax")
    assert latest > 2000
    assert at < latest
    expect(studio.page.locator(".vertex.is-active").first).to_be_attached()
    studio.at("event-strip").focus()
    studio.page.keyboard.press("Home")
    expect_tick(studio, 0)
    studio.page.keyboard.press("F10")
    expect_tick(studio, 1)
    studio.page.keyboard.press("End")
    expect_tick(studio, latest)
    expect(studio.at("status")).to_have_attribute("data-status", DONE)
    expect(studio.at("status")).to_contain_text("B holds all 12 boxes")
    find_nothing(studio, "the end of a recording", within=".bottom-bar, [data-testid='recording-bar']")
    studio.full_speed()
    studio.at("run-recorded").click()
    expect(bar).to_contain_text("runs anew")
    studio.wait_until_done()
    assert value(studio, "aria-valuemax") == latest, "the same mission and seed are the same run"


@pytest.mark.thorough(
    "tests/server/test_recordings.py: the run so far is saved with what was done to it, and listed; "
    "web/src/session/recordings.test.ts: by which name; the journey above plays one"
)
def test_the_run_is_saved_with_what_was_done_to_it_and_shows_it_again(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    studio.page.locator(".vertex", has_text="Lamp On").click()
    studio.page.keyboard.press("b")
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", PAUSED)
    studio.at("watch-button").click()
    count = studio.at("watch-Count").get_by_role("textbox")
    count.click()
    count.fill("42")
    studio.page.keyboard.press("Enter")
    expect(count).to_have_value("42")
    expect(studio.page.locator(".strip-events [data-kind=outside]")).to_have_count(1)
    latest = value(studio, "aria-valuemax") + 1
    studio.page.keyboard.press("F10")
    expect_tick(studio, latest)
    studio.page.get_by_role("menuitem", name="Run", exact=True).click()
    with studio.page.expect_download() as saved:
        studio.page.get_by_role("menuitem", name="Save this run").click()
    assert saved.value.suggested_filename == "blink-1.krtrace"
    path = studio.folder / "kept.krtrace"
    saved.value.save_as(path)
    studio.page.keyboard.press("Shift+F5")
    studio.page.keyboard.press("Control+z")
    studio.page.keyboard.press("Control+o")
    studio.page.locator('[data-path="kept.krtrace"]').click()
    expect(studio.at("recording-bar")).to_contain_text("kept.krt, seed 1")
    expect(studio.at("status")).to_contain_text("visit 1")  # its mission brought the breakpoint along
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "end")
    expect(studio.at("status")).to_contain_text("still on")
    expect_tick(studio, latest)
    expect(studio.page.locator(".strip-events [data-kind=outside]")).to_have_count(1)
    expect(studio.at("watch-Count").get_by_role("textbox")).to_have_value("42")


def what_is_no_recording_is_a_sentence_and_nothing_is_lost(studio: Studio, data: bytes) -> None:
    drop(studio, "bad.krtrace", b"no trace at all")
    expect(studio.at("banner")).to_contain_text("not a KitRobot trace")
    expect(studio.at("title")).to_contain_text("blink.krt")
    studio.faults.clear()  # the browser logs the refusal itself
    drop(studio, "cut.krtrace", data[: len(data) * 2 // 3])
    expect(studio.at("recording-bar")).to_contain_text("cut off")


@pytest.mark.thorough(
    "test_a_dropped_recording_plays_is_stepped_sought_and_run_live looks with axe, in the light theme"
)
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_while_a_recording_plays(
    open_studio: OpenStudio, tmp_path: Path, look: tuple[str, ...]
) -> None:
    studio = open_studio("blink/blink.krt")
    choose(studio, *look)
    drop(studio, "bug.krtrace", recorded(tmp_path))
    expect(studio.at("recording-bar")).to_be_visible()
    held(studio)
    find_nothing(studio, "a recording", within=".bottom-bar, [data-testid='recording-bar']")
    studio.at("event-strip").focus()
    studio.page.keyboard.press("End")
    expect(studio.at("play-recording")).to_be_visible()
    find_nothing(studio, "the end of a recording", within=".bottom-bar, [data-testid='recording-bar']")


@pytest.mark.thorough(
    "tests/server/test_recordings.py: what is no recording, and one that is cut off; test_recorded_breakpoints.py "
    "pauses each time; web/src/features/run/bars.test.tsx says so"
)
def test_what_is_no_recording_is_said_and_one_pauses_at_a_part_each_time_it_is_played(
    open_studio: OpenStudio, tmp_path: Path
) -> None:
    studio = open_studio("blink/blink.krt")
    data = recorded(tmp_path)
    what_is_no_recording_is_a_sentence_and_nothing_is_lost(studio, data)
    drop(studio, "bug.krtrace", data)
    expect(studio.at("recording-bar")).not_to_contain_text("cut off")
    expect(studio.at("recording-bar")).not_to_contain_text("Pause here")
    held(studio)
    # The condition in its middle is selected: what pauses is the part that waits for it.
    studio.page.locator(".vertex", has_text="Sign = Dock or Run is false").click()
    studio.page.keyboard.press("b")
    expect(studio.at("recording-bar")).to_contain_text("Pause here")
    studio.full_speed()
    studio.at("run-button").click()
    expect(studio.at("status")).to_contain_text("visit 1")
    first = value(studio, "aria-valuenow")
    studio.at("run-button").click()
    expect(studio.at("event-strip")).not_to_have_attribute("aria-valuenow", str(first))
    expect(studio.at("status")).to_have_attribute("data-status", PAUSED)
    studio.at("stop-button").click()
    studio.at("play-recording").click()
    expect(studio.at("status")).to_contain_text("visit 1")
    expect(studio.at("status")).to_have_attribute("data-status", PAUSED)
