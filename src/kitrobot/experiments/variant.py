"""A mission while values are put into it: the parts that addresses change, as a copy of their own.

Left to others: which addresses there are (`addresses`), and running the result (`point_runner`).
"""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from kitrobot.mission.model import Mission
from kitrobot.primitives.robot import Robot
from kitrobot.workspace.mission_loader import OpenMission, with_mission
from kitrobot.workspace.search_path import SearchPath
from kitrobot.world.model import World

Value = int | float | str
"""What an address holds: a number, or a word."""


@dataclass
class Variant:
    """A mission that values are put into; `fail_rate` is that of its runs (0…1)."""

    mission: Mission
    world: World
    robots: dict[str, Robot]
    fail_rate: float

    def change_part(self, robot: str, category: str, part: str, **changes: Any) -> None:
        """Puts other values into an object of a robot; `category` is "actuators", "sensors" or "variables"."""
        whole = self.robots[robot]
        parts = tuple(replace(one, **changes) if one.name == part else one for one in getattr(whole, category))
        changed: dict[str, Any] = {category: parts}
        self.robots[robot] = replace(whole, **changed)


def variant_of(opened: OpenMission, fail_rate: float) -> Variant:
    """A copy of an opened mission, which must have no errors, to put values into."""
    assert opened.world is not None, "a mission without its world has an error"
    assert opened.common is not None, "it was opened with its files"
    return Variant(deepcopy(opened.mission), opened.world, dict(opened.common.robots), fail_rate)


def open_variant(variant: Variant, opened: OpenMission) -> OpenMission:
    """The mission with the values in it; `opened` is the one without."""
    assert opened.common is not None, "it was opened with its files"
    known = replace(opened.common, robots=variant.robots)
    mission = replace(variant.mission, own_world=variant.world, world_href="")
    return with_mission(mission, opened.name, SearchPath(Path(), known=known))
