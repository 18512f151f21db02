"""Axes: values and designs from text, and the points that come of them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.experiments.addresses import Address, ExperimentError
from kitrobot.experiments.axes import all_points, count_points, point_at, read_axes, read_axis, read_table
from kitrobot.experiments.sampling import MOST_DIMENSIONS, latin_hypercube, sobol
from kitrobot.experiments.seeds import read_seeds, seeds_of


def _nowhere(variant, value):
    raise AssertionError("nothing is put anywhere")


KNOWN = {
    "speed": Address("speed", 50, _nowhere, 0, 100, True),
    "loss": Address("loss", 0, _nowhere, 0, 100),
    "rule": Address("rule", "stay", _nowhere, 1, 0, words=("stay", "tow")),
}


def _values(text):
    (group,) = read_axes([read_axis(text)], KNOWN, "")
    return [value for (value,) in group.rows]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("speed=30", [30]),
        ("speed=0, 5 ,10", [0, 5, 10]),
        ("speed=30:60:10", [30, 40, 50, 60]),
        ("speed=60:30:-15", [60, 45, 30]),
        ("speed=2..5", [2, 3, 4, 5]),
        ("speed=5..3", [5, 4, 3]),
        ("loss=0:0.3:0.1", [0, 0.1, 0.2, 0.3]),
        ("rule=tow,stay", ["tow", "stay"]),
    ],
)
def test_lists_and_ranges_are_values(text, values):
    assert _values(text) == values


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("speed", "expected ADDRESS=VALUES"),
        ("speed=", "expected ADDRESS=VALUES"),
        ("sped=1", "no `sped` that could vary"),
        ("speed=0:10:0", "is no range"),
        ("speed=0:10:-1", "is no range"),
        ("speed=0:10:x", "is no range"),
        ("speed=0:nan:1", "found `nan`"),
        ("speed=0:101", "found `101`"),
        ("loss=0:100:1e-9", "from 1 to 1000000 points"),
        ("loss=lhs(0)", "from 1 to 1000000 points"),
        ("loss=lhs(3, 50, 20)", "is no range"),
        ("rule=lhs(3)", "has words"),
        ("rule=push", "expected stay or tow"),
    ],
)
def test_an_axis_that_makes_no_sense_is_refused_in_a_sentence(text, words):
    with pytest.raises(ExperimentError, match=words.replace("(", r"\(")):
        _values(text)


def test_axes_are_multiplied_the_last_one_fastest_and_side_by_side_when_asked():
    groups = read_axes([("speed", "1,2"), ("loss", "5,6")], KNOWN, "")
    assert list(all_points(groups, False)) == [
        {"speed": 1, "loss": 5},
        {"speed": 1, "loss": 6},
        {"speed": 2, "loss": 5},
        {"speed": 2, "loss": 6},
    ]
    assert list(all_points(groups, True)) == [{"speed": 1, "loss": 5}, {"speed": 2, "loss": 6}]
    for is_zip in (False, True):
        count = count_points(groups, is_zip)
        assert [point_at(groups, is_zip, n) for n in range(count)] == list(all_points(groups, is_zip))
    with pytest.raises(ExperimentError, match="these have 2, 3"):
        count_points(read_axes([("speed", "1,2"), ("loss", "5,6,7")], KNOWN, ""), True)
    with pytest.raises(ExperimentError, match="`speed` varies twice"):
        read_axes([("speed", "1,2"), ("speed", "5")], KNOWN, "")


def test_designs_of_one_kind_are_drawn_together_and_always_the_same():
    groups = read_axes([("speed", "lhs(10)"), ("rule", "stay,tow"), ("loss", "lhs(10, 20, 40)")], KNOWN, "chance")
    assert [group.addresses for group in groups] == [("speed", "loss"), ("rule",)]
    assert groups == read_axes(
        [("speed", "lhs(10)"), ("rule", "stay,tow"), ("loss", "lhs(10, 20, 40)")], KNOWN, "chance"
    )
    losses = [float(loss) for _, loss in groups[0].rows]
    assert all(20 <= loss <= 40 for loss in losses)
    assert len({int((loss - 20) // 2) for loss in losses}) == 10


@given(st.integers(1, 60), st.integers(1, 5), st.text(max_size=5))
def test_a_latin_hypercube_has_each_part_of_each_axis_once(count, dimensions, chance):
    points = latin_hypercube(count, dimensions, chance)
    for axis in range(dimensions):
        assert sorted(int(point[axis] * count) for point in points) == list(range(count))


def test_the_sobol_sequence_is_that_of_scipy():
    qmc = pytest.importorskip("scipy.stats.qmc")
    theirs = qmc.Sobol(MOST_DIMENSIONS, scramble=False).random(256)
    assert sobol(256, MOST_DIMENSIONS) == theirs.tolist()


def test_a_table_has_a_row_for_each_point_and_a_wrong_cell_is_told_with_its_line():
    group = read_table("speed,rule\n10,stay\n20, tow\n\n", "points.csv", KNOWN)
    assert (group.addresses, group.rows) == (("speed", "rule"), ((10, "stay"), (20, "tow")))
    for text, words in (
        ("", "expected a line of addresses"),
        ("speed\n", "expected a line of addresses"),
        ("speed\n1,2\n", "line 2: expected 1 cells"),
        ("speed\n1\n200\n", "line 3: `speed`: expected a whole number"),
        ("speed,speed\n1,2\n", "stands there twice"),
        ("sped\n1\n", "no `sped`"),
    ):
        with pytest.raises(ExperimentError, match=words):
            read_table(text, "points.csv", KNOWN)


@given(st.lists(st.integers(0, 300), min_size=1, max_size=40, unique=True))
def test_seeds_are_what_they_were_made_of_in_their_order(numbers):
    seeds = seeds_of(numbers)
    assert [seeds[n] for n in range(len(seeds))] == numbers
    assert read_seeds(seeds.text) == seeds


@pytest.mark.parametrize("text", ["", "x", "3-1", "1,,2", "-1", "1-9007199254740993", "1-5,3", "٣"])
def test_seeds_that_make_no_sense_are_refused(text):
    if text == "٣":
        assert list(read_seeds(text).ranges) == [range(3, 4)]  # an Urdu keyboard
        return
    with pytest.raises(ExperimentError, match="seed"):
        read_seeds(text)
