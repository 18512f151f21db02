"""`kitrobot maze`."""

from __future__ import annotations

from kitrobot.world.maze import make_maze
from kitrobot.world.xml_reader import read_world
from kitrobot.world.xml_writer import write_world


def test_a_maze_goes_to_standard_output_and_is_the_same_for_the_same_numbers(kitrobot, here):
    said = kitrobot("maze", "--seed", "7", "--columns", "4", "--rows", "3")
    assert (said.status, said.err) == (0, "")
    world, problems = read_world(said.out.encode(), "maze")
    assert problems == []
    assert world == make_maze(7, 4, 3)
    assert kitrobot("maze").out.encode() == write_world(make_maze(0))


def test_numbers_that_no_maze_has_are_refused(kitrobot, here):
    for wrong in (("--rows", "1"), ("--columns", "41"), ("--seed", "-1"), ("--seed", "4294967296"), ("--seed", "x")):
        said = kitrobot("maze", *wrong)
        assert (said.status, said.out) == (2, "")
        assert wrong[0] in said.err
