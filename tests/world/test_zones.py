"""Zones in world files: read, written, wrong, limited; and worlds that people begin with."""

from __future__ import annotations

import random
from collections import deque

import pytest
import xmlschema

from kitrobot.translation.languages import TEXT_LANGUAGES
from kitrobot.world.floor_svg import floor_svg
from kitrobot.world.maze import CELL_MM, MOST_CELLS, make_maze
from kitrobot.world.model import World, Zone
from kitrobot.world.template import TEMPLATES
from kitrobot.world.xml_reader import MAX_ZONES, read_world
from kitrobot.world.xml_writer import write_world
from tests.world.test_docs import SCHEMA

HEAD = '<world version="1" name="w" width="900" height="900">\n'
CIRCLE = '  <zone kind="warm" x="100" y="200" radius="50" value="35" falloff="0"/>\n'
RECTANGLE = '  <zone kind="loud" x="300" y="400" width="80" height="60.5" value="62.5" falloff="120"/>\n'


def file(*lines: str) -> bytes:
    return "".join((HEAD, *lines, "</world>\n")).encode()


def test_circles_and_rectangles_are_read_and_written_again_to_the_byte_and_the_schema_takes_them() -> None:
    data = file(CIRCLE, RECTANGLE)
    world, problems = read_world(data, "w")
    assert problems == []
    assert world is not None
    assert world.zones == (
        Zone("warm", 100, 200, 50, 0, 0, 35, 0),
        Zone("loud", 300, 400, 0, 80, 60.5, 62.5, 120),
    )
    assert write_world(world) == data
    xmlschema.XMLSchema(SCHEMA).validate(data.decode())


def test_a_zone_that_does_not_say_how_far_is_felt_for_200_mm() -> None:
    world, _ = read_world(file(CIRCLE.replace(' falloff="0"', "")), "w")
    assert world is not None
    assert world.zones[0].falloff_mm == 200


@pytest.mark.parametrize(
    ("right", "wrong", "words"),
    [
        ('kind="warm"', 'kind="wet"', "warm"),
        ('kind="warm" ', "", "kind"),
        ('radius="50" ', "", "a radius, or width and height"),
        ('radius="50"', 'radius="50" width="9" height="9"', "radius and width and height"),
        ('radius="50"', 'width="9"', "a radius, or width and height"),
        ('radius="50"', 'radius="0"', "radius"),
        ('radius="50"', 'radius="1e99"', "radius"),
        ('x="100"', 'x="901"', "outside the world"),
        ('x="100"', 'x="nan"', "x"),
        ('value="35"', 'value="100.1"', "from 0 to 100"),
        ('value="35"', 'value="-1"', "from 0 to 100"),
        ('value="35" ', "", "value"),
        ('falloff="0"', 'falloff="-1"', "falloff"),
    ],
)
def test_a_zone_that_makes_no_sense_is_left_out_and_said_with_its_place(right: str, wrong: str, words: str) -> None:
    assert right in CIRCLE
    world, problems = read_world(file(CIRCLE.replace(right, wrong), RECTANGLE), "w")
    assert world is not None
    assert [zone.kind for zone in world.zones] == ["loud"]
    [problem] = problems
    assert problem.place is not None
    assert problem.place.line == 2
    assert words in problem.message
    assert problem.thing == "zone:0"


def test_a_world_has_at_most_two_hundred_zones() -> None:
    full, problems = read_world(file(*[CIRCLE] * MAX_ZONES), "w")
    assert problems == []
    assert full is not None
    assert len(full.zones) == MAX_ZONES == 200
    more, problems = read_world(file(*[CIRCLE] * (MAX_ZONES + 3)), "w")
    assert more is not None
    assert len(more.zones) == MAX_ZONES
    [problem] = problems
    assert problem.place is not None
    assert (problem.code, problem.place.line) == ("world-zone", 2 + MAX_ZONES)


def test_a_zone_cut_off_anywhere_is_a_mistake_and_no_traceback() -> None:
    data = file(CIRCLE, RECTANGLE)
    for end in range(len(HEAD), len(data) - 10, 7):
        world, problems = read_world(data[:end], "w")
        assert problems, end
        assert world is None or len(world.zones) <= 2


def reachable(world: World) -> int:
    """How many cells the robot of a maze can come to."""
    lines = {(wall.x1_mm, wall.y1_mm, wall.x2_mm, wall.y2_mm) for wall in world.walls}

    def shut(x: float, y: float, upright: bool) -> bool:
        return any(
            (x1 == x2 == x and y1 < y < y2) if upright else (y1 == y2 == y and x1 < x < x2) for x1, y1, x2, y2 in lines
        )

    seen = {(0, 0)}
    waiting = deque(seen)
    while waiting:
        x, y = waiting.popleft()
        middle = (x + 0.5) * CELL_MM, (y + 0.5) * CELL_MM
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            there = x + dx, y + dy
            if there not in seen and not shut(middle[0] + dx * CELL_MM / 2, middle[1] + dy * CELL_MM / 2, dx != 0):
                seen.add(there)
                waiting.append(there)
    return len(seen)


def test_a_maze_is_sound_and_every_cell_can_be_reached_whatever_its_seed_and_size() -> None:
    chance = random.Random(1)
    for seed in range(12):
        columns, rows = chance.randint(2, 12), chance.randint(2, 9)
        made = make_maze(seed, columns, rows)
        assert (made.width_mm, made.height_mm) == (columns * CELL_MM, rows * CELL_MM)
        assert reachable(made) == columns * rows
        # Exactly one way: as many borders are open as there are cells but one.
        shut = sum((abs(one.x2_mm - one.x1_mm) + abs(one.y2_mm - one.y1_mm)) / CELL_MM for one in made.walls)
        assert 2 * columns * rows + columns + rows - shut == columns * rows - 1
        again, problems = read_world(write_world(made), "maze")
        assert (again, problems) == (made, [])


def test_the_same_seed_makes_the_same_maze_and_another_one_another() -> None:
    assert make_maze(7) == make_maze(7)
    assert len({write_world(make_maze(seed)) for seed in range(20)}) == 20
    assert make_maze(-1) == make_maze(2**32 - 1)
    assert make_maze(0, 0, 10**9).height_mm == MOST_CELLS * CELL_MM


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_template_has_no_mistake_a_start_and_words_in_each_language(name: str) -> None:
    world = TEMPLATES[name](3)
    again, problems = read_world(write_world(world), name)
    assert problems == []
    assert again == world
    assert world.starts
    assert set(world.label) == set(world.help) == set(TEXT_LANGUAGES)


def test_a_floor_is_drawn_as_svg_with_y_down() -> None:
    world, _ = read_world(file('<wall x1="0" y1="0" x2="900" y2="300"/>\n', CIRCLE, RECTANGLE), "w")
    assert world is not None
    assert list(floor_svg(world)) == [
        '  <rect width="900" height="900" fill="#eceee9"/>',
        '  <circle cx="100" cy="700" r="50" fill="#c2650f" fill-opacity="0.15" stroke="#c2650f" stroke-width="4"/>',
        '  <rect x="260" y="469.8" width="80" height="60.5" fill="#7549cc" fill-opacity="0.15" stroke="#7549cc" '
        'stroke-width="4"/>',
        '  <path d="M0 900 L900 600" stroke="#5b6472" stroke-width="8"/>',
    ]
