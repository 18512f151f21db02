"""Each mission of the gallery is worth watching: robot and trail are large and free, and the card says what was done.

`make gallery` keeps what is measured in `docs/gallery-runs.md`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.effort import cases
from tests.studio.conftest import EXAMPLES, Studio
from tests.studio.gallery_runs import SIZES, SeenRun, run_and_look, table, ways_of

WRITTEN = os.environ.get("KITROBOT_GALLERY", "") != ""
pytestmark = pytest.mark.browser

NAMES = [path.stem for path in sorted(EXAMPLES.glob("*/*.krt")) if path.parent.name != "exercises"]
ALL = [(name, size) for name in NAMES for size in SIZES]
USUAL = [("tidy-up", "1440")]
CASES = ALL if WRITTEN else cases(USUAL, [case for case in ALL if case not in USUAL])
LEAST = {"1440": (15, 180), "390": (10, 120)}
"""The least length of a robot and of a trail, in px, at each width."""


@pytest.fixture(scope="module")
def found() -> Iterator[dict[tuple[str, str], SeenRun]]:
    """What was measured, by mission and size; it becomes the page of the documents where that is asked for."""
    runs: dict[tuple[str, str], SeenRun] = {}
    yield runs
    if WRITTEN:
        page = Path(__file__).resolve().parents[2] / "docs" / "gallery-runs.md"
        page.write_text(table(runs), encoding="utf-8")


@pytest.mark.parametrize(("name", "size"), CASES, ids=str)
def test_a_mission_of_the_gallery_is_seen_and_its_card_says_what_was_done(
    open_studio: Callable[..., Studio], found: dict[tuple[str, str], SeenRun], name: str, size: str
) -> None:
    width, height = SIZES[size]
    studio = open_studio(f"{name}/{name}.krt", first_visit=True, viewport={"width": width, "height": height})
    seen = run_and_look(studio, ways_of(EXAMPLES / name / f"{name}.krt"))
    found[name, size] = seen
    robot, trail = LEAST[size]
    assert seen.robot >= robot
    assert seen.trail == 0 or seen.trail >= trail
    assert seen.covered <= 0.02, seen.by
    assert seen.tone in ("plain", "goal")
    # What a board showed on the way is not seen by a page that gets only the end of a run.
    assert seen.trail == 0 or not seen.words[0].startswith("Done"), seen.words
