"""Missions of older formats: one step from each version to the next, so that every file ever written opens.

Version 1 is the first and the newest, so there is no step yet. A step takes a mission as its version's reader gave it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from kitrobot.mission.model import VERSION, Mission

STEPS: Mapping[int, Callable[[Mission], Mission]] = {}
"""Version → what makes a mission of the next version of it."""


def migrate(mission: Mission) -> Mission:
    """The mission in the newest version."""
    while mission.version < VERSION:
        version = mission.version
        mission = STEPS[version](mission)
        assert mission.version == version + 1, f"the step from version {version} must lead to the next"
    return mission
