"""The docks of the worlds that come along, shipped and of examples, stand where programs expect them."""

from __future__ import annotations

from pathlib import Path

from kitrobot.world.lookup import SHIPPED
from kitrobot.world.xml_reader import read_world

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_no_dock_of_a_ring_reaches_back_into_the_section_before_its_own() -> None:
    # A carrier could stop there, at its dock and yet before the sign that its program waits for.
    files = [*SHIPPED.glob("*.world.xml"), *EXAMPLES.glob("*/*.world.xml")]
    docks = 0
    for path in files:
        world, problems = read_world(path.read_bytes(), path.name)
        assert world is not None, (path, problems)
        roads = {road.name: road for road in world.roads}
        for dock in world.docks:
            road = roads[dock.road]
            if road.closed:
                docks += 1
                start = road.section_at(dock.at_mm - dock.reach_mm)
                assert start == road.section_at(dock.at_mm), (path.name, dock.name)
    assert docks > 6
