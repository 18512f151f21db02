"""Templates: worlds that people begin a world of their own with."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from kitrobot.world.lookup import SHIPPED, SUFFIX
from kitrobot.world.maze import make_maze
from kitrobot.world.model import World
from kitrobot.world.xml_reader import read_world

_OWN = Path(__file__).parent / "templates"


def _file_template(folder: Path, name: str) -> Callable[[int], World]:
    def read(seed: int) -> World:
        path = folder / f"{name}{SUFFIX}"
        world, problems = read_world(path.read_bytes(), path.name)
        assert world is not None, f"{path.name}: {problems}"
        return world

    return read


def _maze(seed: int) -> World:
    shipped = _file_template(SHIPPED, "maze")(seed)
    made = make_maze(seed)
    return replace(made, label=shipped.label, help=shipped.help)


TEMPLATES: Mapping[str, Callable[[int], World]] = {
    "maze": _maze,
    "ring": _file_template(SHIPPED, "ring"),
    "crossing": _file_template(_OWN, "crossing"),
    "football": _file_template(_OWN, "football"),
    "warehouse": _file_template(_OWN, "warehouse"),
    "table": _file_template(_OWN, "table"),
}
"""What makes each of a seed, by name, in the order in which they are offered; only the maze asks for the seed."""
