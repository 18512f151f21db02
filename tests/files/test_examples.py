"""Missions that come with KitRobot are found by their names."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.files.examples import examples_folder, find_mission

EXAMPLES = examples_folder()


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As installed from a wheel, there are no examples in the folder where the user is."""
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", ["heart", "heart.krt", "heart/heart", "heart/heart.krt", "examples/heart/heart.krt"])
def test_an_example_is_found_by_its_name_and_by_its_place(name: str) -> None:
    assert EXAMPLES is not None
    assert find_mission(Path(name)) == EXAMPLES / "heart" / "heart.krt"


def test_a_file_of_that_name_comes_before_the_example() -> None:
    Path("heart.krt").write_bytes(b"mine")
    assert find_mission(Path("heart.krt")) == Path("heart.krt")


@pytest.mark.parametrize(
    "name", ["", ".", "nothing", "../heart", "heart/../heart/heart", "/heart", "heart/other", "examples", "heart.lll"]
)
def test_what_names_no_example_stays_as_it_is(name: str) -> None:
    assert find_mission(Path(name)) == Path(name)
