"""Places where robots move: walls, coloured floor, roads, docks, storehouses; reading, writing, geometry."""

from kitrobot.world.finding import EMPTY, SHIPPED, SUFFIX, find_world
from kitrobot.world.geometry import Corner, Polyline, Pose, distance_to_stretch, normalised, polyline
from kitrobot.world.model import (
    COLOURS,
    LEFT,
    LOAD,
    RIGHT,
    UNLOAD,
    ColouredLine,
    Dock,
    Floor,
    Road,
    Section,
    Start,
    Storehouse,
    Wall,
    World,
)
from kitrobot.world.reading import read_world
from kitrobot.world.writing import write_world

__all__ = [
    "COLOURS",
    "EMPTY",
    "LEFT",
    "LOAD",
    "RIGHT",
    "SHIPPED",
    "SUFFIX",
    "UNLOAD",
    "ColouredLine",
    "Corner",
    "Dock",
    "Floor",
    "Polyline",
    "Pose",
    "Road",
    "Section",
    "Start",
    "Storehouse",
    "Wall",
    "World",
    "distance_to_stretch",
    "find_world",
    "normalised",
    "polyline",
    "read_world",
    "write_world",
]
