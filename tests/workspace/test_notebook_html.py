"""What a notebook shows of missions and runs."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import kitrobot
from kitrobot import Agent, Mission, Pose, Start, Team, World

SVG = "{http://www.w3.org/2000/svg}"


def shown(html: str) -> ElementTree.Element:
    """The figure, which is well-formed whatever names are in it."""
    return ElementTree.fromstring(html)


def test_a_run_shows_where_its_robots_stand_what_they_drew_and_how_it_ended() -> None:
    run = kitrobot.open_mission("draw-square").run(seed=1)
    figure = shown(run._repr_html_())
    picture = figure.find(f"{SVG}svg")
    assert picture is not None
    strokes = [one for one in picture.findall(f"{SVG}path") if one.get("stroke") == "#e07a1f"]
    assert len(strokes) == 1
    assert float(strokes[0].get("stroke-width", "0")) * 420 / 4000 >= 2
    assert [one.findtext(f"{SVG}title") for one in picture.findall(f"{SVG}g")] == ["robot-1"]
    words = "".join(figure.itertext())
    assert run.sentence in words
    assert "delivered" not in words
    assert "strokes" not in repr(run)


def test_what_carriers_brought_is_said() -> None:
    assert "12 of 12" in kitrobot.open_mission("transport").run(seed=1)._repr_html_()


def test_a_mission_shows_its_world_its_programs_and_its_mistakes(tmp_path: Path) -> None:
    figure = shown(kitrobot.open_mission("transport")._repr_html_())
    assert len(figure.findall(f"{SVG}svg/{SVG}g")) == 7
    words = "".join(figure.itertext())
    assert "transport.krt" in words
    assert str(Path.cwd()) not in words
    assert "carrier, 29 parts, in 3 agents" in words
    broken = tmp_path / "broken.krt"
    broken.write_text('<kitrobot version="1"><team><agent name="a" program="gone"/></team></kitrobot>')
    figure = shown(kitrobot.open_mission(broken)._repr_html_())
    assert figure.find(f"{SVG}svg") is None
    assert "error" in "".join(figure.itertext())


def test_names_of_files_are_words_and_no_html() -> None:
    program = kitrobot.read_program("WAIT(1);", robot="mini-robot", name="<b>&")
    world = World('"><script>', width_mm=1000, height_mm=600, starts=(Start("</title>", pose=Pose(200, 300, 0.0)),))
    mission = Mission(programs=[program], team=Team([Agent("</title>", program="<b>&")]), own_world=world)
    opened = kitrobot.open_mission(mission)
    for html in (opened._repr_html_(), opened.run()._repr_html_()):
        assert "<script>" not in html
        assert "<b>" not in html
        shown(html)
