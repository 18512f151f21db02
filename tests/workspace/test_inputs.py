"""The table of scripted inputs."""

from __future__ import annotations

import pytest

from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.workspace.inputs import Change, read_inputs

ROBOT = load_catalogue().robot("mini-robot")


def read(text):
    return read_inputs(text, "inputs.csv", ROBOT)


def told(text):
    """(code, line, column) of each problem."""
    return [(item.code, item.place.line, item.place.column) for item in read(text)[1]]


def test_a_row_changes_what_its_cells_say_in_its_tick():
    inputs, problems = read("tick,Captor,done:Motor\n0,40,\n12,,0\n")
    assert problems == []
    assert inputs.at(0) == (Change("Captor", False, 40),)
    assert inputs.at(12) == (Change("Motor", True, 0),)
    assert inputs.at(1) == ()


def test_an_empty_cell_changes_nothing():
    assert read("tick,Captor,Button\n5,,\n")[0].at(5) == ()


def test_a_name_of_a_sensor_and_an_actuator_means_the_sensor_without_done():
    inputs, _ = read("tick,Light,done:Light\n0,2,0\n")
    assert inputs.at(0) == (Change("Light", False, 2), Change("Light", True, 0))


@pytest.mark.parametrize(
    "text",
    [
        "\ufefftick,Captor\n3,7\n".removeprefix("\ufeff"),
        "tick,Captor\r\n3,7\r\n",
        "tick,Captor\r3,7\r",
        'tick,"Captor"\n"3","7"\n',
        " tick , Captor \n\n 3 , 7 \n\n",
        "tick,Captor\n3,+7",
    ],
)
def test_line_ends_quotes_spaces_and_blank_lines_do_not_matter(text):
    inputs, problems = read(text)
    assert problems == []
    assert inputs.at(3) == (Change("Captor", False, 7),)


def test_values_outside_the_sensors_range_are_left_to_the_machine():
    assert read("tick,Captor\n0,-5\n1,99999\n")[1] == []


@pytest.mark.parametrize("text", ["", "\n\n", "Captor,tick\n0,1\n", "0,1\n", "tick;Captor\n0;1\n", "Tick,Captor\n"])
def test_a_table_without_its_header_is_refused_at_its_first_line(text):
    assert [code for code, _, _ in told(text)] == ["inputs-header"]


def test_semicolons_are_recognised():
    assert "semicolons" in read("tick;Captor\n0;1\n")[1][0].help


def test_an_unknown_name_is_told_with_its_place_and_the_nearest_one():
    _, problems = read("tick,Capter,done:Moter\n0,1,1\n")
    assert [(item.place.line, item.place.column) for item in problems] == [(1, 6), (1, 13)]
    assert "`Captor`" in problems[0].help
    assert "`done:Motor`" in problems[1].help


def test_an_actuator_without_done_is_no_input():
    assert told("tick,Wheel\n") == [("inputs-unknown-name", 1, 6)]


def test_an_empty_name_is_unknown():
    assert told("tick,\n") == [("inputs-unknown-name", 1, 6)]


def test_a_column_may_not_come_twice():
    assert told("tick,Captor,Button,Captor\n") == [("inputs-column-twice", 1, 20)]


@pytest.mark.parametrize("row", ["1", "1,2,3", "1,2,", "1,,"])
def test_a_row_with_another_number_of_cells_is_told(row):
    assert told(f"tick,Captor\n0,1\n{row}\n") == [("inputs-cells", 3, 1)]


@pytest.mark.parametrize("cell", ["x", "1.5", "1e3", "0x10", "1_000", "٣", "--1", "true", "9" * 40])
def test_a_cell_that_is_no_whole_number_is_told(cell):
    assert told(f"tick,Captor\n0,{cell}\n") == [("inputs-number", 2, 3)]


@pytest.mark.parametrize("tick", ["", "-1", "x", "1.0"])
def test_a_tick_that_is_no_number_from_zero_is_told(tick):
    assert told(f"tick,Captor\n{tick},5\n") == [("inputs-number", 2, 1)]


@pytest.mark.parametrize("cell", ["2", "-1", "yes"])
def test_done_takes_only_0_and_1(cell):
    assert told(f"tick,done:Motor\n0,{cell}\n") == [("inputs-number", 2, 3)]


def test_ticks_out_of_order_are_told_with_their_line():
    assert told("tick,Captor\n5,1\n3,2\n4,3\n6,4\n") == [("inputs-tick-order", 3, 1), ("inputs-tick-order", 4, 1)]


def test_a_tick_twice_is_a_warning_and_the_later_row_wins():
    inputs, problems = read("tick,Captor\n5,1\n5,2\n")
    assert [item.severity for item in problems] == ["warning"]
    assert inputs.at(5)[-1] == Change("Captor", False, 2)


def test_every_mistake_of_a_table_is_told():
    text = "tick,Nobody,Captor\n0,1,x\n1,2\n4,0,0\n"
    assert [code for code, _, _ in told(text)] == [
        "inputs-unknown-name",
        "inputs-number",
        "inputs-cells",
    ]


def test_a_table_of_a_hundred_thousand_rows_is_read():
    rows = "\n".join(f"{tick},{tick % 100}" for tick in range(100_000))
    inputs, problems = read(f"tick,Captor\n{rows}\n")
    assert problems == []
    assert inputs.at(99_999) == (Change("Captor", False, 99),)
