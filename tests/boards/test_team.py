"""A team of two micro:bits of 2016 in QEMU and a board with a current MicroPython: they share a variable, meet, and one
takes the place of another whose line is cut.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.boards.bench import STORES
from tests.boards.modern import ModernBoard
from tests.boards.qemu import Emulated, running
from tests.boards.watching import called
from tests.fleet.test_processes import started

pytestmark = pytest.mark.boards

ROBOT = """<robot name="crewbot" version="1" tick="20" wait-unit="100">
  <actuator name="Panel" device="display"><board driver="stores"/>
    <procedure name="Image" stop="Clear"><parameter name="number" min="0" max="9" default="0"/></procedure>
    <procedure name="Clear"/>
  </actuator>
  <variable name="Told" type="integer" min="0" max="100" initial="0" shared="yes"/>
</robot>
"""
CREW = """<kitrobot version="1">
  <program name="crew" level="social">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Repetition"><set name="count">3</set></vertex>
    <vertex id="v2" element="SeqOfPar"><set name="members">crew</set></vertex>
    <vertex id="v3" element="Panel.Image"><set name="number">1</set></vertex>
    <vertex id="v4" element="Wait"><set name="duration">15</set></vertex>
    <vertex id="v5" element="ParOfSeq"><set name="members">chief</set></vertex>
    <vertex id="v6" element="Told.Add"><set name="value">1</set></vertex>
    <vertex id="v7" element="ParOfSeq"><set name="members">crew</set></vertex>
    <vertex id="v8" element="While"/>
    <vertex id="v9" element="Told.LessThan"><set name="value">3</set></vertex>
    <vertex id="v10" element="Wait"><set name="duration">1</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" out="body" to="v2"/>
    <arc from="v2" out="body" to="v3"/>
    <arc from="v3" to="v4"/>
    <arc from="v4" to="v2" at="return"/>
    <arc from="v2" to="v5"/>
    <arc from="v5" out="body" to="v6"/>
    <arc from="v6" to="v5" at="return"/>
    <arc from="v5" to="v1" at="return"/>
    <arc from="v1" to="v7"/>
    <arc from="v7" out="body" to="v8"/>
    <arc from="v9" to="v8" at="condition"/>
    <arc from="v8" out="body" to="v10"/>
    <arc from="v10" to="v8" at="return"/>
    <arc from="v8" to="v7" at="return"/>
    <arc from="v7" to="stop"/>
  </program>
  <team>
    <agent name="bit-1" program="crew" robot="crewbot"/>
    <agent name="bit-2" program="crew" robot="crewbot"/>
    <agent name="modern" program="crew" robot="crewbot"/>
    <role name="chief" robot="crewbot"/>
    <role name="hand" robot="crewbot"/>
    <group name="crew" members="chief hand" failure="substitute"/>
  </team>
  <world href="crew.world.xml"/>
</kitrobot>
"""
"""Who is chief counts; nobody comes to the end who has not heard of it."""
WORLD = """<world version="1" name="crew" width="2000" height="1000">
  <help>A room.</help>
  <start name="bit-1" x="300" y="500" heading="0"/>
  <start name="bit-2" x="800" y="500" heading="0"/>
  <start name="modern" x="1300" y="500" heading="0"/>
</world>
"""


def write_crew(folder: Path) -> Path:
    """The mission and what belongs to it, as files; the mission's."""
    (folder / "crewbot.robot.xml").write_text(ROBOT, encoding="utf-8")
    (folder / "crew.world.xml").write_text(WORLD, encoding="utf-8")
    (folder / "stores.driver.py").write_text(STORES.format(mark=0), encoding="utf-8")
    (folder / "crew.krt").write_text(CREW, encoding="utf-8")
    return folder / "crew.krt"


@pytest.fixture
def bits() -> Iterator[tuple[Emulated, Emulated]]:
    with running() as one, running() as other:
        yield one, other


@pytest.mark.thorough(
    "test_microbit.py does the ticks of a member; in fleet/test_board_processes.py a board takes over"
)
def test_a_team_of_boards_shares_meets_and_goes_on_without_one(
    bits: tuple[Emulated, Emulated], board: ModernBoard, tmp_path: Path
) -> None:
    mission = write_crew(tmp_path)
    ports = {"bit-1": bits[0].address, "bit-2": bits[1].address, "modern": board.address}
    words = [word for name, port in ports.items() for word in ("--board", f"{name}={port}")]
    sending = called("deploy", str(mission), "--team", *words, "--json")
    assert sending.returncode == 0, sending.stderr
    sent = json.loads(sending.stdout)
    assert [one["agent"] for one in sent] == list(ports)
    assert all(one["free"] > 2200 for one in sent)
    with started("team", str(mission), *words, "--lease", "6000", "--json") as team:
        team.until("bit-1: Told = ")
        bits[0].process.kill()
        team.until("bit-1: its board is lost")
        status, out, said = team.end()
    assert (status, json.loads(out)["outcome"]) == (0, "done"), said
    assert "modern: takes over for bit-1" in said
    assert "modern: its program has ended" in said
    assert "bit-2: its program has ended" in said
    again = called("deploy", str(mission), "--team", *words[:2], *words[4:])
    said = " ".join(again.stderr.split())
    assert again.returncode == 1
    assert "no robot of the team is started; mend what is said above of bit-1" in said
    assert "the new program is already on the boards of these, where it waits: modern" in said
