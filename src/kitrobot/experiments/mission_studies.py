"""The studies that lie beside a mission: listed, found by name, and a folder for another one.

A study of `NAME.krt` that is begun without a name is `NAME-study`, as on the command line, or `NAME-study-2` and so on
where that folder holds something else. Only folders that are listed are ever found, so no name leads elsewhere.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.plan import PLAN_FILE, Plan
from kitrobot.experiments.study_folder import is_study, open_study
from kitrobot.files.disk import read_text
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean

MOST_LISTED = 50
"""Studies of a mission that are listed: the newest."""


@dataclass(frozen=True)
class MissionStudy:
    """A study beside a mission: the name of its folder, and how many runs it has when it is complete."""

    name: str
    runs: int


def study_names(folder: Path) -> list[str]:
    """The folders in a folder that hold a study, the newest first; links are none."""
    found = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.is_dir(follow_symlinks=False) and is_study(Path(entry.path)):
                    found.append(((Path(entry.path) / PLAN_FILE).stat().st_mtime_ns, entry.name))
    except OSError:
        return []
    return [name for _, name in sorted(found, reverse=True)]


def studies_of(folder: Path, mission: str) -> list[MissionStudy]:
    """The studies in a folder of the mission of that stem, the newest first; what is no plan is left out."""
    found: list[MissionStudy] = []
    for name in study_names(folder):
        try:
            plan = open_study(folder / name)
        except KitRobotError:
            continue
        if plan.name == mission:
            found.append(MissionStudy(name, plan.rows))
            if len(found) == MOST_LISTED:
                break
    return found


def find_study(folder: Path, name: str) -> Path:
    """The folder of the study of that name.

    Raises:
        ExperimentError: none of that name is in the folder.
    """
    names = study_names(folder)
    if name not in names:
        raise ExperimentError(Sentence("there is no study `{name}` here", name[:80]), did_you_mean(name[:80], names))
    return folder / name


def choose_study_folder(folder: Path, plan: Plan) -> Path:
    """Where a study goes: the folder that holds the very same one already, else the first that is free."""
    text = plan.to_toml()
    for number in count(1):
        place = folder / (f"{plan.name}-study" if number == 1 else f"{plan.name}-study-{number}")
        if not os.path.lexists(place) or (is_study(place) and read_text(place / PLAN_FILE) == text):
            return place
    raise AssertionError("numbers do not end")
