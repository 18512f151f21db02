"""`kitrobot check`."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.cli.conftest import EXAMPLE, MISTAKEN

KEYS = ["file", "line", "column", "end_line", "end_column", "severity", "code", "message", "help"]
ROBOT = (
    '<robot name="mine" version="1"><actuator name="Bell" device="music"><procedure name="Stop"/></actuator></robot>'
)
WORLD = '<world version="1" name="small" width="900" height="900"/>'
CONSTRUCTORS = (
    '<constructors version="1"><group name="G" colour="loop"><constructor name="Forever"><flow name="body" loop="yes"/>'
    "<code>*[Run.IsTrue()]({body})</code></constructor></group></constructors>"
)

TUTORIAL = (
    '<tutorial version="1" start="x.krt"><label>T</label><step><label>S</label>'
    "<contains><code>4*({body})</code></contains></step></tutorial>"
)


@pytest.fixture
def write(here):
    """Writes a file and gives its name."""

    def write(name, content):
        (here / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    return write


def test_the_example_has_no_errors(kitrobot):
    said = kitrobot("check", EXAMPLE)
    assert said.status == 0, said.out
    assert "1 file" in said.err


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("mine.robot.xml", ROBOT),
        ("small.world.xml", WORLD),
        ("c.xml", CONSTRUCTORS),
        ("r.xml", "<!-- x -->" + ROBOT),
        ("mine.tutorial.xml", TUTORIAL),
        ("t.xml", TUTORIAL),
    ],
)
def test_a_good_file_of_each_kind_of_xml_has_no_errors(kitrobot, write, name, content):
    said = kitrobot("check", write(name, content))
    assert (said.status, said.out) == (0, "")


DEVICES = """\
<robot name="mine" version="1">
  <actuator name="Wheel" device="driv" speed="200"><procedure name="Stop"/></actuator>
  <actuator name="Motor"
            device="turn">
    <procedure name="Stop"/>
    <procedure name="Spin"/>
  </actuator>
  <actuator name="Bell" device="gong"><procedure name="Ring"/></actuator>
  <sensor name="Heat" device="thermometer" min="0" max="50"><operation name="Value" value="yes"/></sensor>
  <sensor name="Eye" device="range" reech="5"><operation name="Value" value="yes"/></sensor>
</robot>
"""


def test_every_device_of_a_robot_that_the_simulator_or_a_board_lacks_is_told_at_its_line(kitrobot, write, here):
    write("gong.driver.py", 'PROCEDURES = "Ring"\n')
    said = kitrobot("check", write("mine.robot.xml", DEVICES), "--json")
    assert said.status == 1
    assert [(one["line"], one["column"], one["code"]) for one in said.json] == [
        (2, 34, "run-device"),
        (6, 22, "run-device"),
        (8, 33, "robot-not-simulated"),
        (9, 31, "run-device"),
        (10, 30, "robot-no-driver"),
        (10, 30, "run-device"),
    ]
    assert [one["help"] for one in said.json if "did you mean" in one["help"]] == [
        "did you mean drive?",
        "did you mean reach?",
    ]


def test_a_device_that_nobody_knows_is_told_at_its_line_also_where_a_mission_needs_it(kitrobot, write, here):
    assert kitrobot("convert", write("p.lll", "Wheel.Stop();"), "p.krt", "--robot", "mini-robot").status == 0
    (here / "p.krt").write_text((here / "p.krt").read_text().replace('robot="mini-robot"', 'robot="mine"'))
    write("mine.robot.xml", DEVICES)
    found = kitrobot("check", "p.krt", "--json").json
    assert [(Path(one["file"]).name, one["line"]) for one in found] == [
        ("mine.robot.xml", line) for line in (2, 6, 8, 9, 10)
    ]


def test_the_robot_of_the_documentation_runs_as_it_says(kitrobot, here):
    page = (Path(__file__).parents[2] / "docs" / "xml.md").read_text(encoding="utf-8")
    robot = re.search(r"```xml\n(<robot .*?)```", page, re.DOTALL)
    assert robot is not None
    told = re.search(r"```lll\n(.*?)```.*?```\n(.*?)```", page[robot.end() :], re.DOTALL)
    assert told is not None
    program, commands = told.groups()
    (here / "digger.robot.xml").write_text(robot[1], encoding="utf-8")
    (here / "digger.lll").write_text(program, encoding="utf-8")
    checked = kitrobot("check", "digger.robot.xml", "--json")
    assert (checked.status, {one["code"] for one in checked.json}) == (0, {"robot-no-driver"})
    for command in commands.splitlines():
        said = kitrobot(*command.split()[1:])
        assert said.status == 0, said.err
    assert "every program has ended" in said.out


def test_a_mistake_in_the_code_of_a_tutorial_is_shown_at_its_place(kitrobot, write):
    said = kitrobot("check", write("t.tutorial.xml", TUTORIAL.replace("{body}", "{body")))
    assert said.status == 1
    assert said.out.startswith(f"t.tutorial.xml:1:{TUTORIAL.index('{body') + 1}: error: ")


def test_a_problem_has_its_place_the_line_a_caret_and_help(kitrobot, write):
    said = kitrobot("check", write("p.lll", "WAIT(1);\nWheel.Advanse(5);\n"), "--robot", "mini-robot")
    lines = said.out.splitlines()
    assert said.status == 1
    assert lines[0].startswith("p.lll:2:7: error: ")
    assert lines[1] == "  2 | Wheel.Advanse(5);"
    assert lines[2].startswith("            ^")
    assert lines[3].startswith("  help: ")
    assert "1 error" in said.err


def test_every_problem_has_help(kitrobot, write):
    for problem in kitrobot("check", write("p.lll", MISTAKEN), "--robot", "mini-robot", "--json").json:
        assert problem["help"]


def test_json_is_a_list_in_the_published_shape(kitrobot, write):
    said = kitrobot("check", write("p.lll", "WAIT(1);\nWheel.Advanse(5);\n"), "--robot", "mini-robot", "--json")
    assert said.status == 1
    problem = said.json[0]
    assert list(problem) == KEYS
    assert (problem["file"], problem["line"], problem["column"]) == ("p.lll", 2, 7)
    assert (problem["end_line"], problem["severity"]) == (2, "error")


def test_json_without_problems_is_an_empty_list(kitrobot, program):
    said = kitrobot("check", program, "--robot", "mini-robot", "--json")
    assert (said.status, said.json, said.err) == (0, [], "")


def test_only_an_error_makes_the_status_1(kitrobot, write):
    said = kitrobot("check", write("p.lll", "BREAK;"), "--robot", "mini-robot", "--json")
    assert [problem["severity"] for problem in said.json] == ["hint"]
    assert said.status == 0


def test_without_a_robot_only_the_syntax_of_a_text_is_checked_and_that_is_said(kitrobot, write):
    said = kitrobot("check", write("p.lll", "Nobody.Knows();"))
    assert said.status == 0
    assert "only the syntax" in said.err
    assert kitrobot("check", write("q.lll", "Nobody.Knows(;")).status == 1


def test_a_text_with_ten_mistakes_shows_them_all(kitrobot, write):
    problems = kitrobot("check", write("p.lll", "WAIT(;\n" * 10), "--json").json
    assert {problem["line"] for problem in problems} >= set(range(1, 11))


def test_a_vertex_with_a_mistake_is_shown_in_its_mission(kitrobot, program, here):
    kitrobot("convert", program, "drive.krt", "--robot", "mini-robot")
    text = (here / "drive.krt").read_text().replace('element="Wheel.Advance"', 'element="Wheel.Advanse"')
    (here / "drive.krt").write_text(text)
    line = text[: text.index("Advanse")].count("\n") + 1
    said = kitrobot("check", "drive.krt")
    assert said.status == 1
    assert f"drive.krt:{line}:5: error: " in said.out
    assert 'Wheel.Advanse"><set' in said.out


def test_an_arc_with_a_mistake_is_shown_in_its_mission(kitrobot, program, here):
    kitrobot("convert", program, "drive.krt", "--robot", "mini-robot")
    text = (here / "drive.krt").read_text().replace('<arc from="v1" to="stop"/>', '<arc from="v1" to="nowhere"/>')
    (here / "drive.krt").write_text(text)
    line = text[: text.index("nowhere")].count("\n") + 1
    assert f"drive.krt:{line}:5: error: " in kitrobot("check", "drive.krt").out


TEAM = """<kitrobot version="1">
  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="stop"/>
  </program>
  <program name="q" robot="mini-robo">
    <vertex id="start" element="Start"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="stop"/>
  </program>
  <team>
    <agent name="a" program="p" start="robot-11"/>
    <agent name="b" program="none" start="robot-1"/>
    <goal storehouse="Z" stock="all"/>
  </team>
</kitrobot>
"""


def test_what_does_not_fit_together_is_shown_where_it_is_said(kitrobot, write):
    said = kitrobot("check", write("m.krt", TEAM), "--json")
    found = {(problem["code"], problem["line"]) for problem in said.json}
    assert found >= {
        ("mission-no-robot", 7),
        ("mission-no-start", 13),
        ("mission-no-program", 14),
        ("mission-no-storehouse", 15),
    }
    assert len([code for code, _ in found if code == "mission-no-program"]) == 1


def test_a_world_that_is_not_there_is_shown(kitrobot, write):
    text = '<kitrobot version="1">\n  <world href="moon.world.xml"/>\n</kitrobot>'
    problem = kitrobot("check", write("m.krt", text), "--json").json[0]
    assert (problem["code"], problem["line"], problem["column"]) == ("mission-no-world", 2, 3)


def test_two_agents_in_one_place_are_shown(kitrobot, write):
    agents = '<agent name="a" program="p" start="robot-1"/><agent name="b" program="p" start="robot-1"/>'
    text = TEAM[: TEAM.index('  <program name="q"')] + f"  <team>{agents}</team>\n</kitrobot>\n"
    said = kitrobot("check", write("m.krt", text), "--json")
    assert [problem["code"] for problem in said.json] == ["run-start"]
    assert said.json[0]["file"] == "m.krt"


def test_an_image_and_a_listing_are_checked(kitrobot, program, here):
    for form in ("kri", "kra"):
        kitrobot("convert", program, f"drive.{form}", "--robot", "mini-robot")
        assert kitrobot("check", f"drive.{form}").status == 0
    (here / "drive.kri").write_bytes((here / "drive.kri").read_bytes()[:-1])
    (here / "drive.kra").write_text((here / "drive.kra").read_text().replace(".code", ".kode"))
    problems = kitrobot("check", "drive.kri", "drive.kra", "--json").json
    assert [problem["code"] for problem in problems] == ["image-unusable", "image-unusable"]
    assert problems[1]["line"] > 1


HOSTILE = [
    b"",
    b"\0\1\2\3",
    b"\xff\xfe",
    b"<",
    b"plain text",
    b"<robot",
    b'<!DOCTYPE r [<!ENTITY a "x">]><robot name="&a;" version="1"/>',
    b'<!DOCTYPE r [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]><robot name="&b;" version="1"/>',
    b'<!DOCTYPE r SYSTEM "file:///etc/passwd"><robot name="x" version="1"/>',
    b"<a>" * 10_000,
    b"<robot>" * 10_000,
    b'<?xml version="1.0" encoding="latin-1"?><robot name="\xe9" version="1"/>',
    b'<robot name="\xe9" version="1"/>',
    b"<!---->" * 50_000,
    b"<?a?>" * 50_000 + b"<",
    b"<nothing/>",
]


@pytest.mark.parametrize("data", HOSTILE, ids=range(len(HOSTILE)))
@pytest.mark.parametrize(
    "name", ["x.robot.xml", "x.world.xml", "x.tutorial.xml", "x.xml", "x.krt", "x.lll", "x.kri", "x.kra"]
)
def test_a_damaged_or_hostile_file_is_an_error_with_its_place(kitrobot, write, name, data):
    said = kitrobot("check", write(name, data), "--json")
    if name == "x.lll" and data == b"":
        assert (said.status, said.json) == (0, [])
        return
    assert said.status == 1
    errors = [problem for problem in said.json if problem["severity"] == "error"]
    assert errors
    assert all(problem["file"] == name and problem["line"] >= 1 and problem["message"] for problem in errors)


def test_a_missing_file_a_folder_and_another_kind_are_told_and_the_others_still_checked(kitrobot, write, here):
    (here / "folder.krt").mkdir()
    write("p.txt", "text")
    write("p.lll", "WAIT(;")
    said = kitrobot("check", "none.krt", "folder.krt", "p.txt", "p.lll", "--json")
    assert said.status == 1
    assert [problem["file"] for problem in said.json] == ["none.krt", "folder.krt", "p.txt", "p.lll"]
    assert [problem["code"] for problem in said.json[:3]] == [
        "file-unreadable",
        "file-unreadable",
        "file-unknown-kind",
    ]


def test_a_file_that_may_not_be_read_is_told(kitrobot, write, here, monkeypatch):
    write("p.krt", "x")

    def refused(path: Path) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("kitrobot.files.disk.open_regular", refused)
    said = kitrobot("check", "p.krt", "--json")
    assert said.status == 1
    assert "permission denied" in said.json[0]["message"]


def test_a_file_that_is_too_large_is_told(kitrobot, write, monkeypatch):
    from kitrobot.files import disk

    monkeypatch.setattr(disk, "LARGEST_FILE_BYTES", 100)
    assert kitrobot("check", write("p.lll", "#" * 100)).status == 0
    assert "larger" in kitrobot("check", write("p.lll", "#" * 101)).out


def test_a_robot_that_is_not_there_is_a_sentence(kitrobot, program):
    said = kitrobot("check", program, "--robot", "nobody")
    assert said.status == 1
    assert "nobody" in said.err


def test_a_file_is_needed(kitrobot):
    assert kitrobot("check").status == 2


def test_a_constructor_that_adds_itself_to_nothing_is_told(kitrobot, write):
    text = CONSTRUCTORS.replace(
        "</group>", '<constructor name="More"><adds constructor="No" slot="branch"/></constructor></group>'
    )
    said = kitrobot("check", write("c.xml", text), "--json")
    assert said.status == 1
    assert [(problem["file"], problem["code"]) for problem in said.json] == [("c.xml", "constructor-adds")]
