"""Submissions made from text: the mission of an exercise with these programs in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from kitrobot.compiler.target import read_for, target_of
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.mission.model import Mission
from kitrobot.mission.writer import write_mission
from kitrobot.workspace.mission_loader import OpenMission, open_mission

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "examples" / "exercises"


def exercise_file(name: str) -> Path:
    return FOLDER / f"{name}.exercise.xml"


def submission(name: str, programs: Mapping[str, str]) -> Mission:
    """The mission that the exercise `name` begins with, with these programs in the place of its own."""
    opened = open_mission(FOLDER / f"{name}.krt")
    return with_programs(opened, opened.mission, programs)


def with_programs(opened: OpenMission, mission: Mission, programs: Mapping[str, str]) -> Mission:
    """A mission with these programs in the place of those of their names; `opened` has the parts."""
    made = []
    for program in mission.programs:
        text = programs.get(program.name)
        if text is None:
            made.append(program)
            continue
        target = target_of(program, opened.catalogue)
        read = read_for(text, target, program.name)
        assert read.ok, read.diagnostics
        made.append(lll_to_graph(read.seq, target, opened.catalogue, program.name))
    return replace(mission, programs=made)


def handed_in_file(name: str, programs: Mapping[str, str], path: Path) -> Path:
    """The same as a file."""
    path.write_bytes(write_mission(submission(name, programs)))
    return path
