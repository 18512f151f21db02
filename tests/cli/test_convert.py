"""`kitrobot convert`: every way between the forms, and every way that is closed."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

from tests.cli.conftest import EXAMPLE, LLL, MISTAKEN

FORMS = ("krt", "lll", "kri", "kra", "xml")
OPEN = {
    ("krt", "lll"),
    ("krt", "kri"),
    ("krt", "kra"),
    ("lll", "krt"),
    ("lll", "kri"),
    ("lll", "kra"),
    ("kri", "kra"),
    ("kra", "kri"),
    ("krt", "xml"),
    ("lll", "xml"),
    *(("xml", form) for form in ("krt", "lll", "kri", "kra")),
}


@pytest.fixture
def all_forms(kitrobot, program, here):
    """`drive` in all forms."""
    for form in ("krt", "kri", "kra", "xml"):
        assert kitrobot("convert", program, f"drive.{form}", "--robot", "mini-robot").status == 0
    return here


@pytest.mark.parametrize(("source", "target"), [*itertools.product(FORMS, FORMS)])
def test_each_form_goes_to_the_forms_it_can_go_to(kitrobot, all_forms, source, target):
    said = kitrobot("convert", f"drive.{source}", f"new.{target}", "--robot", "mini-robot")
    assert said.status == (0 if (source, target) in OPEN else 1)
    assert (all_forms / f"new.{target}").exists() == ((source, target) in OPEN)
    assert said.out == ""


def test_text_to_graph_to_text_is_the_same(kitrobot, all_forms, program):
    assert kitrobot("convert", "drive.krt", "again.lll").status == 0
    assert (all_forms / "again.lll").read_text() == kitrobot("format", program).out


def test_an_image_is_the_same_from_text_and_from_the_graph(kitrobot, all_forms):
    kitrobot("convert", "drive.krt", "graph.kri")
    assert (all_forms / "graph.kri").read_bytes() == (all_forms / "drive.kri").read_bytes()


def test_assembling_a_listing_gives_the_image_back_byte_for_byte(kitrobot, all_forms):
    kitrobot("convert", "drive.kri", "listing.kra")
    kitrobot("convert", "listing.kra", "back.kri")
    assert (all_forms / "back.kri").read_bytes() == (all_forms / "drive.kri").read_bytes()


@pytest.mark.parametrize("target", ["x.lll", "x.krt"])
def test_an_image_keeps_no_names(kitrobot, all_forms, target):
    said = kitrobot("convert", "drive.kri", target)
    assert said.status == 1
    assert "An image keeps no names" in said.err
    assert "help: convert the `.krt` or `.lll`" in said.err
    assert not (all_forms / target).exists()


def test_an_lll_text_needs_a_robot(kitrobot, program):
    said = kitrobot("convert", program, "x.kri")
    assert said.status == 1
    assert "--robot" in said.err


def test_a_robot_may_be_a_file(kitrobot, program, here):
    (here / "mine.robot.xml").write_text(
        '<robot name="mine" version="1"><actuator name="Arm"><procedure name="Up"/></actuator></robot>'
    )
    (here / "arm.lll").write_text("Arm.Up();")
    assert kitrobot("convert", "arm.lll", "arm.kri", "--robot", "mine.robot.xml").status == 0
    assert kitrobot("convert", "arm.lll", "arm.krt", "--robot", "./mine.robot.xml").status == 0
    # The robot lies beside the mission, so the mission finds it.
    assert kitrobot("convert", "arm.krt", "back.lll").status == 0


def test_a_robot_that_is_not_beside_the_mission_is_warned_of(kitrobot, here):
    (here / "far").mkdir()
    (here / "far" / "mine.robot.xml").write_text(
        '<robot name="mine" version="1"><actuator name="Arm"><procedure name="Up"/></actuator></robot>'
    )
    (here / "arm.lll").write_text("Arm.Up();")
    said = kitrobot("convert", "arm.lll", "arm.krt", "--robot", "far/mine.robot.xml")
    assert said.status == 0
    assert "warning" in said.err
    assert "robot-elsewhere" in said.err


@pytest.mark.parametrize("robot", ["mini-robo", "none.robot.xml", "", "/", "drive.lll/"])
def test_a_robot_that_is_not_there_is_a_sentence(kitrobot, program, here, robot):
    said = kitrobot("convert", program, "x.kri", "--robot", robot)
    assert said.status == 1
    assert not (here / "x.kri").exists()


def test_a_robots_file_with_mistakes_is_shown(kitrobot, program, here):
    (here / "bad.robot.xml").write_text('<robot name="bad">\n  <actuator/>\n</robot>')
    said = kitrobot("convert", program, "x.kri", "--robot", "bad.robot.xml")
    assert said.status == 1
    assert "bad.robot.xml:2:3: error" in said.err
    assert "^" in said.err


def test_a_mission_with_several_programs_asks_which_and_lists_them(kitrobot, here):
    mission = EXAMPLE
    said = kitrobot("convert", mission, "x.lll")
    assert said.status == 1
    assert "`carrier`" in said.err
    assert "--program" in said.err
    assert kitrobot("convert", mission, "x.lll", "--program", "carrier").status == 0
    assert kitrobot("check", "x.lll", "--robot", "carrier").status == 0


def test_a_program_that_is_not_in_the_mission_is_a_sentence(kitrobot, all_forms):
    said = kitrobot("convert", "drive.krt", "x.lll", "--program", "dive")
    assert said.status == 1
    assert "`drive`" in said.err


def test_the_program_of_a_new_mission_is_called_like_its_file_or_as_asked(kitrobot, all_forms, program):
    assert '<program name="drive" robot="mini-robot">' in (all_forms / "drive.krt").read_text()
    kitrobot("convert", program, "x.krt", "--robot", "mini-robot", "--program", "mine")
    assert '<program name="mine" robot="mini-robot">' in (all_forms / "x.krt").read_text()


def test_a_new_mission_can_be_checked_and_run(kitrobot, all_forms):
    assert kitrobot("check", "drive.krt").status == 0
    assert kitrobot("run", "drive.krt", "--seconds", "1", "--json").json["outcome"] == "time"


@pytest.mark.parametrize("form", ["krt", "kri", "kra"])
def test_a_text_with_mistakes_is_told_and_nothing_is_written(kitrobot, here, form):
    (here / "bad.lll").write_text(MISTAKEN)
    said = kitrobot("convert", "bad.lll", f"x.{form}", "--robot", "mini-robot")
    assert said.status == 1
    assert "bad.lll:1:" in said.err
    assert not (here / f"x.{form}").exists()


@pytest.mark.parametrize("form", ["krt", "kri", "kra"])
def test_names_the_robot_does_not_know_are_told_and_nothing_is_written(kitrobot, here, form):
    (here / "bad.lll").write_text("Weel.Advance(5);")
    said = kitrobot("convert", "bad.lll", f"x.{form}", "--robot", "mini-robot")
    assert said.status == 1
    assert "bad.lll:1:1: error" in said.err
    assert "did you mean" in said.err
    assert not (here / f"x.{form}").exists()


def test_what_was_there_stays_when_there_are_mistakes(kitrobot, here):
    (here / "bad.lll").write_text(MISTAKEN)
    (here / "x.kri").write_bytes(b"old")
    kitrobot("convert", "bad.lll", "x.kri", "--robot", "mini-robot")
    assert (here / "x.kri").read_bytes() == b"old"


@pytest.mark.parametrize(
    ("source", "target"), [("drive.txt", "x.kri"), ("drive.lll", "x.txt"), ("drive", "x"), ("drive.lll", "x")]
)
def test_an_ending_that_is_not_known_is_told_with_those_that_are(kitrobot, program, here, source, target):
    (here / source).write_text(LLL)
    said = kitrobot("convert", source, target, "--robot", "mini-robot")
    assert said.status == 1
    for ending in ("`.krt`", "`.lll`", "`.kri`", "`.kra`"):
        assert ending in said.err


def test_the_endings_may_be_in_capitals(kitrobot, program, here):
    program.rename(here / "DRIVE.LLL")
    assert kitrobot("convert", "DRIVE.LLL", "X.KRI", "--robot", "mini-robot").status == 0


def test_the_input_is_never_written_to_by_whatever_name(kitrobot, all_forms):
    (all_forms / "same.kri").symlink_to(all_forms / "drive.lll")
    before = (all_forms / "drive.lll").read_bytes()
    said = kitrobot("convert", "drive.lll", "same.kri", "--robot", "mini-robot")
    assert said.status == 1
    assert (all_forms / "drive.lll").read_bytes() == before


def test_converting_over_an_older_result_replaces_it_whole(kitrobot, all_forms):
    (all_forms / "drive.kra").write_bytes(b"x" * 100_000)
    assert kitrobot("convert", "drive.kri", "drive.kra").status == 0
    assert "xxx" not in (all_forms / "drive.kra").read_text()
    assert not [entry for entry in all_forms.iterdir() if entry.name.startswith(".")]


def test_a_mission_that_is_replaced_is_kept_beside_it(kitrobot, all_forms, program):
    before = (all_forms / "drive.krt").read_bytes()
    (all_forms / "two.lll").write_text("WAIT(1);")
    assert kitrobot("convert", "two.lll", "drive.krt", "--robot", "mini-robot").status == 0
    assert (all_forms / "drive.krt~").read_bytes() == before


@pytest.mark.parametrize("target", ["none/x.kri", "folder.kri"])
def test_a_place_that_cannot_be_written_to_is_a_sentence(kitrobot, program, here, target):
    (here / "folder.kri").mkdir()
    said = kitrobot("convert", program, target, "--robot", "mini-robot")
    assert said.status == 1
    assert "folder" in said.err


@pytest.mark.parametrize("bit", range(0, 2000, 37))
def test_an_image_with_a_flipped_bit_is_refused(kitrobot, all_forms, bit):
    data = bytearray((all_forms / "drive.kri").read_bytes())
    data[bit // 8 % len(data)] ^= 1 << bit % 8
    (all_forms / "bad.kri").write_bytes(data)
    said = kitrobot("convert", "bad.kri", "x.kra")
    assert said.status == 1
    assert "`bad.kri`" in said.err
    assert not (all_forms / "x.kra").exists()


@pytest.mark.parametrize("data", [b"", b"KRI\0", b"\0" * 1000, b"not an image"])
def test_what_is_no_image_is_refused(kitrobot, here, data):
    (here / "bad.kri").write_bytes(data)
    assert kitrobot("convert", "bad.kri", "x.kra").status == 1


def test_an_image_that_was_cut_off_is_refused(kitrobot, all_forms):
    (all_forms / "cut.kri").write_bytes((all_forms / "drive.kri").read_bytes()[:-7])
    assert kitrobot("convert", "cut.kri", "x.kra").status == 1


def test_a_mistake_in_a_listing_is_told_with_its_line(kitrobot, all_forms):
    text = (all_forms / "drive.kra").read_text().replace(".code", ".kode")
    line = text[: text.index(".kode")].count("\n") + 1
    (all_forms / "bad.kra").write_text(text)
    said = kitrobot("convert", "bad.kra", "x.kri")
    assert said.status == 1
    assert f"bad.kra:{line}: " in said.err


def test_a_listing_that_no_host_would_run_is_warned_of_and_assembled(kitrobot, all_forms):
    text = (all_forms / "drive.kra").read_text()
    (all_forms / "bad.kra").write_text(text[: text.index(".code") + 6] + "    JMP 0\n")
    said = kitrobot("convert", "bad.kra", "x.kri")
    assert said.status == 0
    assert "image-unsafe" in said.err
    assert kitrobot("exec", "x.kri", "--robot", "mini-robot").status == 1


def test_a_damaged_mission_is_told_with_its_place(kitrobot, all_forms):
    text = (all_forms / "drive.krt").read_text()
    (all_forms / "cut.krt").write_text(text[: len(text) // 2])
    said = kitrobot("convert", "cut.krt", "x.lll")
    assert said.status == 1
    assert "cut.krt:" in said.err
    assert not (all_forms / "x.lll").exists()


def test_a_recording_becomes_an_mcap_file_and_nothing_else(kitrobot, here):
    assert kitrobot("run", str(EXAMPLE), "--seconds", "2", "--trace", "run.krtrace").status == 1
    said = kitrobot("convert", "run.krtrace", "run.mcap")
    assert (said.status, said.out) == (0, "")
    assert "run.mcap: written" in said.err
    assert (here / "run.mcap").read_bytes().startswith(b"\x89MCAP0\r\n")
    (here / "cut.krtrace").write_bytes((here / "run.krtrace").read_bytes()[:-20])
    assert "which is cut off" in kitrobot("convert", "cut.krtrace", "cut.mcap").err
    for source, target, words in (
        ("run.krtrace", "run.lll", "a recording becomes a `.mcap` file"),
        (str(EXAMPLE), "x.mcap", "only recordings become `.mcap` files"),
        ("run.mcap", "x.mcap", "only recordings become `.mcap` files"),
        ("none.krtrace", "x.mcap", "cannot be read"),
        ("run.krtrace", "none/x.mcap", "there is no folder"),
    ):
        said = kitrobot("convert", source, target)
        assert (said.status, said.out) == (1, "")
        assert words in said.err
        assert "Traceback" not in said.err
        assert not (here / target).exists()
    (here / "run.krtrace").write_bytes(b"KRTRACE\n" + b"x" * 100)
    assert "run.krtrace" in kitrobot("convert", "run.krtrace", "y.mcap").err
    assert not (here / "y.mcap").exists()


TREES = Path(__file__).parents[1] / "behaviour_trees" / "trees"


@pytest.mark.parametrize("name", ["gate", "rounds", "supply"])
def test_a_behaviour_tree_becomes_a_mission_that_runs_is_proved_and_goes_back(kitrobot, here, name):
    tree = TREES / f"{name}.xml"
    assert kitrobot("check", tree, "--robot", "mini-robot").status == 0
    assert kitrobot("convert", tree, "m.krt", "--robot", "mini-robot").status == 0
    assert kitrobot("run", "m.krt", "--seconds", "20", "--json").json["outcome"] == "done"
    assert kitrobot("verify", "m.krt", "--property", "deadlock").status == 0
    assert kitrobot("convert", "m.krt", "again.xml").status == 0
    for source, target in ((tree, "first.kri"), ("again.xml", "second.kri")):
        assert kitrobot("convert", source, target, "--robot", "mini-robot").status == 0
    assert (here / "first.kri").read_bytes() == (here / "second.kri").read_bytes()


def test_a_behaviour_tree_needs_a_robot(kitrobot, here):
    said = kitrobot("convert", TREES / "gate.xml", "x.krt")
    assert said.status == 1
    assert "a behaviour tree does not say which robot it is for" in said.err
    assert "only the syntax was checked" in kitrobot("check", TREES / "gate.xml").err


def test_a_tree_that_no_program_says_is_told_at_its_line_and_nothing_is_written(kitrobot, here):
    text = (TREES / "gate.xml").read_text().replace("Fallback", "ReactiveFallback")
    (here / "bad.xml").write_text(text)
    for command in (("convert", "bad.xml", "x.krt"), ("check", "bad.xml")):
        said = kitrobot(*command, "--robot", "mini-robot")
        assert said.status == 1
        assert "bad.xml:6:7: error: <ReactiveFallback> stops what is under way" in said.err + said.out
    assert not (here / "x.krt").exists()


def test_a_part_of_a_program_that_no_tree_says_is_told_with_its_vertex(kitrobot, here):
    (here / "race.lll").write_text("//(<Button.IsPressed()>();, °Wheel.Advance(50)°;);")
    said = kitrobot("convert", "race.lll", "x.xml", "--robot", "mini-robot")
    assert (said.status, "race.lll:1:29: error: a marked action" in said.err) == (1, True)
    kitrobot("convert", "race.lll", "race.krt", "--robot", "mini-robot")
    said = kitrobot("convert", "race.krt", "x.xml")
    assert (said.status, "a marked action" in said.err, "race.krt" in said.err) == (1, True, True), said
    assert not (here / "x.xml").exists()


def test_the_program_of_a_team_becomes_no_tree(kitrobot, here):
    said = kitrobot("convert", EXAMPLE.parents[1] / "convoy" / "convoy.krt", "x.xml", "--program", "convoy")
    assert said.status == 1
