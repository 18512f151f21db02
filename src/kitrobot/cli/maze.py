"""`kitrobot maze`: a world with a maze from a seed."""

from __future__ import annotations

from typing import Annotated

import typer

from kitrobot.cli.output import print_data


def give_maze(
    seed: Annotated[int, typer.Option("--seed", min=0, max=2**32 - 1, help="The same seed makes the same maze.")] = 0,
    columns: Annotated[int, typer.Option("--columns", min=2, max=40, help="How many cells it is wide.")] = 8,
    rows: Annotated[int, typer.Option("--rows", min=2, max=40, help="How many cells it is high.")] = 5,
) -> None:
    """Make a world with a maze, for `kitrobot maze --seed 7 > my-maze.world.xml`.

    There is one way between any two of its cells. The robot starts at the lower left; the green field is farthest
    from there.
    """
    from kitrobot.world.maze import make_maze
    from kitrobot.world.xml_writer import write_world

    print_data(write_world(make_maze(seed, columns, rows)).decode())
