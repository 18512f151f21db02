"""Names, numbers and line ends as keyboards and systems differ in them: one name, one number, one line end."""

from __future__ import annotations

import unicodedata
from pathlib import Path

import pytest

ROBOT = "mini-robot"
FORMS = ["Étage", "réel", "آدم", "tầng"]


def apart(name: str) -> str:
    made = unicodedata.normalize("NFD", name)
    assert made != name
    return made


def mission(declared: str, used: str, agent: str = "ada", more: str = "") -> str:
    return f"""<kitrobot version="1">
  <variable robot="{ROBOT}" name="{declared}" min="0" max="9" initial="5"/>{more}
  <program name="{declared}" robot="{ROBOT}">
    <vertex id="start" element="Start"/>
    <vertex id="{declared}" element="{used}.Add"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="{used}"/>
    <arc from="{used}" to="stop"/>
  </program>
  <team><agent name="{agent}" program="{used}" start="robot-1"/></team>
  <breakpoint program="{used}" vertex="{used}"/>
</kitrobot>
"""


@pytest.mark.parametrize("name", FORMS)
def test_a_name_is_one_name_in_either_form(kitrobot, here: Path, name: str):
    for declared, used in ((name, apart(name)), (apart(name), name)):
        (here / "m.krt").write_text(mission(declared, used), encoding="utf-8")
        assert kitrobot("check", "m.krt").status == 0
        for given in (name, apart(name)):
            assert kitrobot("convert", "m.krt", "p.lll", "--program", given).status == 0
    assert name in (here / "p.lll").read_text(encoding="utf-8")


def test_a_property_is_named_on_the_command_line_in_either_form(kitrobot, here: Path):
    asked = f'<property name="{apart("Étage")}" never="any ada (Count.EqualTo(9))"/>'
    (here / "m.krt").write_text(mission("réel", "réel", more=asked), encoding="utf-8")
    said = [kitrobot("verify", "m.krt", "--property", given) for given in ("Étage", apart("Étage"))]
    assert [one.status for one in said] == [said[0].status] * 2
    assert all("Étage" in one.out for one in said)


@pytest.mark.parametrize("name", FORMS)
def test_two_declarations_of_one_name_are_a_duplicate(kitrobot, here: Path, name: str):
    other = f'<variable robot="{ROBOT}" name="{apart(name)}" min="0" max="9" initial="5"/>'
    (here / "m.krt").write_text(mission(name, name, more=other), encoding="utf-8")
    said = kitrobot("check", "m.krt")
    assert said.status == 1
    assert "is there already" in said.err + said.out


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_a_line_ends_as_on_any_system(kitrobot, here: Path, end: str):
    lines = ["# a comment", "Wheel.Advance(50); # fast", "Wheel.Advence(50);"]
    (here / "p.lll").write_bytes(end.join(lines).encode())
    said = kitrobot("check", "p.lll", "--robot", ROBOT)
    assert "p.lll:3:7:" in said.err + said.out
    (here / "q.lll").write_bytes(end.join(lines[:2]).encode())
    assert "Wheel.Advance(50)" in kitrobot("exec", "q.lll", "--robot", ROBOT, "--ticks", "2").out
    assert kitrobot("format", "q.lll").out == "# a comment\nWheel.Advance(50);  # fast\n"
    (here / "i.csv").write_bytes(end.join(["tick,Captor", "0,40", "1,x"]).encode())
    said = kitrobot("exec", "q.lll", "--robot", ROBOT, "--inputs", "i.csv")
    assert "i.csv:3:3:" in said.err + said.out
    assert kitrobot("convert", "q.lll", "q.kra", "--robot", ROBOT).status == 0
    listing = (here / "q.kra").read_bytes().replace(b"\n", end.encode())
    (here / "r.kra").write_bytes(listing)
    assert kitrobot("convert", "r.kra", "r.kri").status == 0


@pytest.mark.parametrize("digits", ["٤٠", "۴۰"])
def test_digits_of_another_keyboard_are_read_where_they_are_typed_and_told_in_files(kitrobot, here: Path, digits: str):
    (here / "p.lll").write_text("[Captor.LessThan(41)](Wheel.Advance(50););")
    (here / "i.csv").write_text("tick,Captor\n0,40\n", encoding="utf-8")
    asked = ("exec", "p.lll", "--robot", ROBOT, "--inputs", "i.csv", "--ticks")
    assert kitrobot(*asked, digits).out == kitrobot(*asked, "40").out
    (here / "i.csv").write_text(f"tick,Captor\n0,{digits}\n", encoding="utf-8")
    said = kitrobot(*asked, "2")
    assert said.status == 1
    assert "write 40" in said.err + said.out


def test_the_decimal_sign_of_an_urdu_keyboard_is_read(kitrobot, here: Path):
    (here / "m.krt").write_text(mission("Étage", "Étage"), encoding="utf-8")
    assert kitrobot("run", "m.krt", "--seconds", "۲٫۵").status == 0
