"""`kitrobot check --board`, and what `kitrobot deploy --board` says before anything is sent."""

from __future__ import annotations

from tests.cli.conftest import EXAMPLE

EXAMPLES = EXAMPLE.parents[1]
DOOR, DRAWING, SQUARE = (EXAMPLES / name / f"{name}.krt" for name in ("door", "draw-square", "square"))
KIT = """<board name="mine" version="1" pins="0..9">
  <actuator device="drive turn" left-forward="2" left-backward="3" right-forward="4" right-backward="{pin}"/>
</board>
"""


def test_each_part_of_each_program_is_told_and_the_status_is_that_of_what_is_missing(kitrobot):
    said = kitrobot("check", DOOR, "--board", "pico")
    assert (said.status, said.err) == (0, "")
    assert "Door    used      servo pin=22" in said.out
    assert "it can be sent" in said.out
    said = kitrobot("check", DRAWING, SQUARE, "--board", "maqueen", "--json")
    assert said.status == 1
    drawing, square = said.json
    assert (drawing["ok"], square["ok"]) == (False, True)
    assert "`Pen`" in drawing["error"]["message"]
    assert [part["part"] for part in drawing["parts"] if part["used"] and part["missing"]] == ["Pen"]
    assert square["error"] is None


def test_why_a_part_is_missing_is_told_in_the_language_that_is_asked_for(kitrobot):
    wall = EXAMPLES / "wall" / "wall.krt"
    told = {"en": "It has no range finder.", "fr": "Il n’a pas de télémètre.", "ur": "اس میں فاصلہ پیما نہیں ہے۔"}
    for language, why in told.items():
        said = kitrobot("check", wall, "--board", "pololu-3pi", "--language", language)
        assert (said.status, f"missing: {why}" in said.out, f"help: {why}" in said.err) == (1, True, True)
        (row,) = kitrobot("check", wall, "--board", "pololu-3pi", "--language", language, "--json").json
        assert row["error"]["help"] == why
        assert why in [part["why"] for part in row["parts"]]
    assert "il manque au kit" in kitrobot("check", wall, "--board", "pololu-3pi", "--language", "fr").err
    assert "It has no range finder." in kitrobot("check", wall, "--board", "pololu-3pi").out
    for wrong in (["--board", "pico", "--language", "tlh"], ["--language", "fr"]):
        said = kitrobot("check", wall, *wrong)
        assert (said.status, "--language" in said.err) == (2, True)


def test_a_whole_teams_program_is_told_for_each_kind_of_its_robots(kitrobot):
    said = kitrobot("check", EXAMPLES / "convoy" / "convoy.krt", "--board", "pico", "--json")
    assert said.status == 0
    assert {one["robot"] for one in said.json} == {"mini-robot"}


def test_a_kit_that_is_not_there_and_one_whose_wiring_is_wrong_are_sentences(kitrobot, here):
    said = kitrobot("check", SQUARE, "--board", "pcio")
    assert said.status == 1
    assert "did you mean pico?" in said.err
    (here / "mine.board.xml").write_text(KIT.format(pin=4), encoding="utf-8")
    said = kitrobot("deploy", SQUARE, "--board", "mine.board.xml", "--to", "socket://127.0.0.1:1")
    assert said.status == 1
    assert "the pin `4` for two different things" in said.err
    said = kitrobot("check", "mine.board.xml", "--json")
    assert [(one["code"], one["line"]) for one in said.json] == [("board-wiring", 2)]
    (here / "mine.board.xml").write_text(KIT.format(pin=5), encoding="utf-8")
    assert kitrobot("check", "mine.board.xml").status == 0
    said = kitrobot("deploy", DOOR, "--board", "mine.board.xml", "--to", "socket://127.0.0.1:1")
    assert "lacks what the program uses" in said.err


def test_an_agents_port_without_a_team_and_two_kits_are_told(kitrobot):
    for boards in (["a=COM3"], ["pico", "esp32"]):
        said = kitrobot("deploy", SQUARE, *(word for board in boards for word in ("--board", board)))
        assert said.status == 2
        assert "--team" in said.err
