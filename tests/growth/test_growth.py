"""Whatever a file holds, reading and checking it takes work in proportion to its size.

Work is counted in calls of functions, Python's own among them: no clock decides. From `N` things to twice as many the
number of calls may double; a reader that looks at all others for each of them comes near to four times as many.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.layout import lay_out_file
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.text.suggestions import MOST_COMPARISONS, Suggestions
from kitrobot.versions.file_comparison import compare_files
from kitrobot.workspace.conversion import convert
from kitrobot.workspace.file_check import check_file
from kitrobot.workspace.file_merge import merge_files
from kitrobot.workspace.inputs import read_inputs
from tests.counting import MOST, growth
from tests.effort import THOROUGH
from tests.growth.shapes import SHAPES, content

N = 110 if THOROUGH else 40

DEEP = 110 if THOROUGH else 70
"""Of texts: twice as many blocks are more than the 100 that may stand in one another, up to which work may be dear."""


def grows(work: Callable[[int], Callable[[], object]], n: int = N) -> float:
    """How many times as many calls twice as much takes; a refusal is work too."""

    def unless_refused(n: int) -> Callable[[], object]:
        act = work(n)

        def tried() -> None:
            with contextlib.suppress(KitRobotError):
                act()

        return tried

    return growth(unless_refused, n)


@pytest.fixture(scope="module")
def robot() -> Robot:
    """The robot that texts and inputs are for."""
    return load_catalogue([]).robot("mini-robot")


@cache
def _catalogue() -> Catalogue:
    return load_catalogue([])


@pytest.fixture(autouse=True)
def small_limits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing of the user's own is read, and what is done up to a limit only comes to its limit early."""
    monkeypatch.setenv("KITROBOT_CONFIG", str(tmp_path / "no-config"))
    monkeypatch.setattr("kitrobot.text.suggestions._COMPARED", 10)
    monkeypatch.setattr("kitrobot.xml.reader.MAX_PROBLEMS", 20)
    # What is the same for every file would only hide how the rest grows.
    for module in ("search_path", "conversion"):
        monkeypatch.setattr(f"kitrobot.workspace.{module}.load_catalogue", lambda folders=(): _catalogue())


def made(folder: Path, name: str, n: int, stem: str = "x") -> Path:
    """A file of a shape."""
    place = folder / str(n)
    place.mkdir(exist_ok=True)
    file = place / f"{stem}.{name.partition(' ')[0]}"
    file.write_bytes(content(SHAPES[name](n)))
    return file


@pytest.mark.parametrize("name", [name for name in SHAPES if not name.startswith(("lll", "csv"))])
def test_twice_as_much_in_a_file_is_no_more_than_twice_the_work_of_checking_it(tmp_path, name):
    def work(n: int) -> Callable[[], object]:
        file = made(tmp_path, name, n)
        return lambda: check_file(file)

    assert grows(work) < MOST


@pytest.mark.parametrize("name", [name for name in SHAPES if name.startswith("lll")])
def test_twice_as_much_text_is_no_more_than_twice_the_work_of_laying_it_out_and_checking_it(tmp_path, robot, name):
    def work(n: int) -> Callable[[], object]:
        file = made(tmp_path, name, n)
        return lambda: (lay_out_file(file), check_file(file, robot))

    assert grows(work, DEEP) < MOST


@pytest.mark.parametrize("name", [name for name in SHAPES if name.startswith("csv")])
def test_twice_as_many_inputs_are_no_more_than_twice_the_work(tmp_path, robot, name):
    def work(n: int) -> Callable[[], object]:
        text = made(tmp_path, name, n).read_text()
        return lambda: read_inputs(text, "x.csv", robot)

    assert grows(work) < MOST


@pytest.mark.parametrize("name", [name for name in SHAPES if name.startswith("krt")])
def test_twice_as_much_is_no_more_than_twice_the_work_of_comparing_merging_and_converting_it(tmp_path, name):
    def work(n: int) -> Callable[[], object]:
        one, half = made(tmp_path, name, n), made(tmp_path, name, n // 2, "half")
        other = one.with_stem("other")
        other.write_bytes(one.read_bytes().replace(b"Wheel.Stop", b"Lamp.LightOn").replace(b'"q', b'"z'))
        out = one.with_name("out.lll")

        def all_of_it() -> None:
            with contextlib.suppress(KitRobotError):  # what cannot be compared cannot be merged
                compare_files(half, one)
                compare_files(one, other)
                merge_files(half, one, other, one.with_name("merged.krt"))
            convert(one, out)

        return all_of_it

    assert grows(work) < MOST


def test_ten_thousand_columns_of_one_name_and_as_many_rows_of_one_tick_are_read(robot):
    inputs, problems = read_inputs("tick" + ",Captor" * 10_000 + "\n0" + ",1" * 10_000, "x.csv", robot)
    assert len(problems) == 9_999
    assert len(inputs.at(0)) == 10_000
    inputs, problems = read_inputs("tick,Captor\n" + "5,1\n" * 10_000, "x.csv", robot)
    assert len(problems) == 9_999
    assert len(inputs.at(5)) == 10_000


def test_of_very_many_misspelt_words_the_first_ones_get_a_suggestion(monkeypatch):
    monkeypatch.setattr("kitrobot.text.suggestions._COMPARED", 1000)
    words = [f"word-{number}" for number in range(1000)]
    suggestions = Suggestions()
    found = [suggestions.did_you_mean(f"wort-{number}", words) for number in range(1000)]
    some = MOST_COMPARISONS // len(words)
    assert all(found[:some])
    assert not any(found[some:])
