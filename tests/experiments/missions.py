"""A mission whose runs are short and differ by their seeds, and studies of it."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import kitrobot
from kitrobot.experiments.plan import Plan, StudyRequest, plan_study
from kitrobot.experiments.study_folder import begin_study, row_lines
from kitrobot.workspace.mission_loader import OpenMission

ROBOTS = ("ann", "ben")


def short_mission() -> OpenMission:
    """Two robots that drive for a second, unless they fail."""
    starts = tuple(kitrobot.Start(name, pose=kitrobot.Pose(200, 200 + 200 * at, 0)) for at, name in enumerate(ROBOTS))
    drive = kitrobot.read_program("Wheel.Advance(50); WAIT(10); Wheel.Stop();", "mini-robot", "drive")
    team = kitrobot.Team([kitrobot.Agent(name, "drive") for name in ROBOTS])
    world = kitrobot.World("yard", 1000, 600, starts=starts)
    return kitrobot.open_mission(kitrobot.Mission(programs=[drive], team=team, own_world=world))


def speed_address(opened: OpenMission) -> str:
    """The address of the speed of its robots."""
    (vertex,) = (one for one in opened.mission.programs[0].vertices if one.element == "Wheel.Advance")
    return f"drive.{vertex.id}.speed"


def short_plan(seeds: str = "1-6", **chosen: object) -> Plan:
    """Twice as many rows as seeds."""
    opened = short_mission()
    asked = {"vary": [(speed_address(opened), "30,60")], "fail_rate": 1.0, "measures": ["seconds,distance"]}
    return plan_study(opened, StudyRequest(**{**asked, "seeds": seeds, **chosen}))  # type: ignore[arg-type]


def short_study(folder: Path, seeds: str = "1-6", **chosen: object) -> Plan:
    """The same, begun in a folder."""
    plan = short_plan(seeds, **chosen)
    begin_study(folder, plan)
    return plan


def sorted_rows(folder: Path) -> list[bytes]:
    """The rows of a study, byte for byte."""
    return sorted(row_lines(folder))


def last_tick(trace: object) -> int:
    """A measure in Python."""
    return trace.reader.last_tick  # type: ignore[attr-defined, no-any-return]


def die_at_seed_3(trace: object) -> int:
    """A measure that takes its process along."""
    if trace.reader.header.seed == 3:  # type: ignore[attr-defined]
        os.kill(os.getpid(), signal.SIGKILL)
    return 1


def give_nan(trace: object) -> float:
    """A measure that is no number."""
    return float("nan")
