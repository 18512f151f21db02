"""`kitrobot exec`."""

from __future__ import annotations

import json

import pytest

from tests.cli.conftest import EXAMPLE

ROBOT = ("--robot", "mini-robot")


@pytest.fixture
def write(here):
    """Writes a file and gives its name."""

    def write(name, text):
        (here / name).write_text(text, encoding="utf-8")
        return name

    return write


@pytest.fixture
def execute(kitrobot, write):
    """Executes an LLL text: the lines of JSON."""

    def execute(text, ticks=5, inputs=None):
        options = ["--inputs", write("inputs.csv", inputs)] if inputs is not None else []
        said = kitrobot("exec", write("p.lll", text), *ROBOT, *options, "--ticks", ticks, "--json")
        assert said.status == 0, said.err
        return said.lines

    return execute


def test_each_line_is_one_compact_object_in_the_published_shape(kitrobot, write):
    said = kitrobot("exec", write("p.lll", "Wheel.Advance(50);"), *ROBOT, "--ticks", 1, "--json")
    assert said.out == (
        '{"tick":0,"commands":[["Wheel.Advance",[50]]],"variables":{"Count":0,"Level":50,"Run":1,"Flag":0},'
        '"fault":0,"ended":true}\n'
    )
    assert said.err == ""


@pytest.mark.parametrize("ticks", [0, 1, 7, 1200])
def test_there_are_always_as_many_lines_as_ticks(execute, ticks):
    assert [line["tick"] for line in execute("WAIT(1);", ticks)] == list(range(ticks))


def test_ended_is_said_from_the_tick_in_which_the_programs_own_thread_ends(execute):
    assert [line["ended"] for line in execute("WAIT(0); Light.LightOn();", 4)] == [False, True, True, True]


def test_variables_are_after_the_tick_in_file_order_and_booleans_are_0_or_1(execute):
    line = execute("Count.Add(3); Run.Set(0); Flag.Set(1);", 1)[0]
    assert list(line["variables"].items()) == [("Count", 3), ("Level", 50), ("Run", 0), ("Flag", 1)]
    assert all(type(value) is int for value in line["variables"].values())


def test_commands_are_in_the_order_of_the_actuators(execute):
    line = execute("Light.LightOn(); Wheel.Advance(1); Motor.Turn(2);", 1)[0]
    assert line["commands"] == [["Motor.Turn", [2]], ["Wheel.Advance", [1]], ["Light.LightOn", []]]


def test_a_clamped_value_raises_the_fault(execute):
    assert [line["fault"] for line in execute("WAIT(0); Count.Sub(1);", 3)] == [0, 1, 1]


def test_before_any_row_sensors_are_0_and_devices_are_done(execute):
    assert execute("<Captor.EqualTo(0)>(Count.Set(1);); Motor.AbsoluteTurn(1, 1); Count.Set(2);", 2)[1]["ended"]


def test_a_row_holds_from_its_tick_on(execute):
    lines = execute("*[Run.IsTrue()](Count.Set(Captor.Value()); )", 5, "tick,Captor\n1,7\n3,9\n")
    assert [line["variables"]["Count"] for line in lines] == [0, 7, 7, 9, 9]


def test_an_empty_cell_changes_nothing(execute):
    lines = execute("*[Run.IsTrue()](Count.Set(Captor.Value()); )", 3, "tick,Captor,Button\n0,7,\n1,,1\n")
    assert [line["variables"]["Count"] for line in lines] == [7, 7, 7]


def test_only_the_file_moves_done(execute):
    text = "Motor.AbsoluteTurn(1, 1); Count.Set(1);"
    lines = execute(text, 6, "tick,done:Motor\n0,0\n4,1\n")
    assert [line["ended"] for line in lines] == [False, False, False, False, True, True]
    assert all(not line["ended"] for line in execute(text, 6, "tick,done:Motor\n0,0\n"))


def test_a_value_outside_the_sensors_range_is_clamped_without_a_fault(execute):
    line = execute("Level.Set(Captor.Value());", 1, "tick,Captor\n0,99999\n")[0]
    assert (line["variables"]["Level"], line["fault"]) == (100, 0)


def test_rows_after_the_last_tick_do_not_matter(execute):
    assert len(execute("WAIT(1);", 2, "tick,Captor\n1000000,1\n")) == 2


def test_the_forms_of_a_program_execute_alike(kitrobot, program):
    for form in ("krt", "kri"):
        kitrobot("convert", program, f"drive.{form}", *ROBOT)
    outs = {kitrobot("exec", f"drive.{form}", *ROBOT, "--ticks", 30, "--json").out for form in ("lll", "krt", "kri")}
    assert len(outs) == 1


def test_a_mission_names_its_own_robot(kitrobot, program):
    kitrobot("convert", program, "drive.krt", *ROBOT)
    assert kitrobot("exec", "drive.krt", "--ticks", 3, "--json").status == 0


def test_a_program_of_a_mission_is_chosen(kitrobot, here):
    mission = EXAMPLE
    said = kitrobot("exec", mission, "--ticks", 1)
    assert said.status == 1
    assert "--program" in said.err
    assert "`loader`" in said.err
    assert kitrobot("exec", mission, "--program", "loader", "--ticks", 1).status == 0


@pytest.mark.parametrize("form", ["lll", "kri"])
def test_a_text_or_an_image_needs_a_robot(kitrobot, program, form):
    kitrobot("convert", program, "drive.kri", *ROBOT)
    said = kitrobot("exec", f"drive.{form}")
    assert said.status == 1
    assert "--robot" in said.err


def test_an_image_for_another_robot_is_refused(kitrobot, program):
    kitrobot("convert", program, "drive.kri", *ROBOT)
    said = kitrobot("exec", "drive.kri", "--robot", "carrier")
    assert (said.status, said.out) == (1, "")
    assert "another robot" in said.err


def test_a_damaged_image_is_refused(kitrobot, program, here):
    kitrobot("convert", program, "drive.kri", *ROBOT)
    data = bytearray((here / "drive.kri").read_bytes())
    data[40] ^= 4
    (here / "drive.kri").write_bytes(data)
    said = kitrobot("exec", "drive.kri", *ROBOT)
    assert (said.status, said.out) == (1, "")
    assert "damaged" in said.err


def test_a_listing_is_not_executed(kitrobot, program):
    kitrobot("convert", program, "drive.kra", *ROBOT)
    said = kitrobot("exec", "drive.kra", *ROBOT)
    assert said.status == 1
    assert "`.kri`" in said.err


def test_mistakes_of_the_program_are_on_standard_error_and_nothing_is_executed(kitrobot, write):
    said = kitrobot("exec", write("p.lll", "Wheel.Advance(500);"), *ROBOT, "--json")
    assert (said.status, list(said.json)) == (1, ["error"])
    assert said.err.startswith("p.lll:1:")


def test_hints_are_told_and_the_program_is_executed(kitrobot, write):
    said = kitrobot("exec", write("p.lll", "BREAK; WAIT(1);"), *ROBOT, "--ticks", 1, "--json")
    assert said.status == 0
    assert len(said.lines) == 1
    assert "hint" in said.err


@pytest.mark.parametrize(
    ("table", "place"),
    [
        ("tick,Capter\n0,1\n", "inputs.csv:1:6: error"),
        ("tick,done:Captor\n0,1\n", "inputs.csv:1:6: error"),
        ("tick,Captor\n5,1\n3,1\n", "inputs.csv:3:1: error"),
        ("tick,Captor\n0,x\n", "inputs.csv:2:3: error"),
        ("tick,Captor\n0\n", "inputs.csv:2:1: error"),
        ("Captor\n0\n", "inputs.csv:1:1: error"),
        ("", "inputs.csv:1:1: error"),
    ],
)
def test_mistakes_of_the_inputs_are_told_with_their_line_and_nothing_is_executed(kitrobot, write, table, place):
    program = write("p.lll", "WAIT(1);")
    said = kitrobot("exec", program, *ROBOT, "--inputs", write("inputs.csv", table), "--json")
    assert (said.status, list(said.json)) == (1, ["error"])
    assert place in said.err


def test_a_byte_order_mark_and_other_line_ends_are_fine(execute):
    assert len(execute("WAIT(1);", 2, "\ufefftick,Captor\r\n0,1\r\n")) == 2


@pytest.mark.parametrize("inputs", ["none.csv", "."])
def test_inputs_that_are_not_there_are_a_sentence(kitrobot, program, inputs):
    said = kitrobot("exec", program, *ROBOT, "--inputs", inputs)
    assert (said.status, said.out) == (1, "")
    assert f"`{inputs}`" in said.err


def test_inputs_that_are_no_text_are_told_with_their_place(kitrobot, program, here):
    (here / "inputs.csv").write_bytes(b"tick,Captor\n0,\xff\n")
    assert "inputs.csv:2:3: error" in kitrobot("exec", program, *ROBOT, "--inputs", "inputs.csv").err


@pytest.mark.parametrize("ticks", ["-1", "x", "1.5"])
def test_a_number_of_ticks_that_makes_no_sense_is_refused(kitrobot, program, ticks):
    assert kitrobot("exec", program, *ROBOT, "--ticks", ticks).status == 2


def test_the_table_for_people_has_a_row_a_tick(kitrobot, write):
    out = kitrobot("exec", write("p.lll", "Wheel.Advance(50); WAIT(0);"), *ROBOT, "--ticks", 3).out.splitlines()
    assert out[0].split() == ["tick", "Count", "Level", "Run", "Flag", "fault", "commands"]
    assert out[1].endswith("Wheel.Advance(50)")
    assert out[2].endswith("(ended)")
    assert len(out) == 4


def test_names_of_every_script_are_not_escaped(kitrobot, write):
    robot = write(
        "r.robot.xml",
        '<robot name="r" version="1"><variable name="تعداد" type="integer"/></robot>',
    )
    out = kitrobot("exec", write("p.lll", "تعداد.Add(1);"), "--robot", robot, "--ticks", 1, "--json").out
    assert '"تعداد":1' in out
    assert json.loads(out)["variables"] == {"تعداد": 1}
