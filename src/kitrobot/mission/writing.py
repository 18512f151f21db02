"""Missions to XML, in one true layout, and safely to disk.

`save` never leaves a half-written file: it writes beside the old one, makes sure the bytes are on the disk, and then
puts the new file in the place of the old, which is kept with a `~` behind its name. Left to others: that nobody else
saves the same file meanwhile.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

from kitrobot.diagnostics import KitRobotError, expect_regular
from kitrobot.graph import write_program
from kitrobot.mission.model import Mission, Team
from kitrobot.mission.trial import write_breakpoint, write_failure
from kitrobot.primitives import Texts, attributes, text_element, write_constructor, write_variable
from kitrobot.world import world_lines

TEMPORARY_ENDING = ".kitrobot-part"
"""Of a file that is being written; who sweeps up after a crash knows it by that."""


def write_mission(mission: Mission) -> bytes:
    """The `.krt` file: one vertex, arc or agent a line. The same mission gives the same bytes."""
    lines = [f"<kitrobot{attributes(('version', mission.version))}>"]
    lines += [*_texts("label", mission.label), *_texts("help", mission.help)]
    for constructor in mission.constructors:
        lines += write_constructor(constructor)
    for variable in mission.variables:
        lines += write_variable(variable)
    for program in mission.programs:
        lines += write_program(program)
    lines += _team(mission.team)
    lines += [f"  {write_breakpoint(breakpoint)}" for breakpoint in mission.breakpoints]
    lines += [f"  {write_failure(failure)}" for failure in mission.failures]
    if mission.own_world is not None:
        lines += [f"  {line}" for line in world_lines(mission.own_world)]
    elif mission.world_href:
        lines.append(f"  <world{attributes(('href', mission.world_href))}/>")
    lines += [f"  {raw}" for raw in mission.unknown]
    lines.append("</kitrobot>")
    return ("\n".join(lines) + "\n").encode()


def _texts(name: str, texts: Texts) -> list[str]:
    """One line a language, English first."""
    return [f"  {text_element(name, language, texts[language])}" for language in sorted(texts)]


def _team(team: Team) -> list[str]:
    if not team.agents and not team.goals:
        return []
    lines = ["  <team>"]
    for agent in team.agents:
        who = attributes(("name", agent.name), ("program", agent.program), ("start", agent.start or None))
        lines.append(f"    <agent{who}/>")
    for goal in team.goals:
        lines.append(f"    <goal{attributes(('storehouse', goal.storehouse), ('stock', goal.stock))}/>")
    return [*lines, "  </team>"]


class SaveError(KitRobotError):
    """A mission could not be saved; what was there before is still there."""


def save(path: Path, mission: Mission) -> bytes:
    """Writes a mission to `path`, keeps what was there as `path~`, and gives the bytes written.

    Raises:
        SaveError: the operating system refused; the old file is untouched.
    """
    data = write_mission(mission)
    try:
        _replace(Path(os.path.realpath(path)), data)
    except OSError as error:
        raise SaveError(f"{path.name} cannot be saved: {error.strerror or error}", "The file is as it was.") from error
    return data


def _replace(path: Path, data: bytes) -> None:
    expect_regular(path)
    handle, name = tempfile.mkstemp(prefix=f".{path.name[:50]}.", suffix=TEMPORARY_ENDING, dir=path.parent)
    fresh = Path(name)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if path.exists():
            shutil.copymode(path, fresh)
            kept = path.with_name(path.name + "~")
            copy = Path(name + "~")
            try:
                shutil.copy2(path, copy)
                os.replace(copy, kept)
            finally:
                copy.unlink(missing_ok=True)
        else:
            mask = os.umask(0)
            os.umask(mask)
            fresh.chmod(0o666 & ~mask)
        os.replace(fresh, path)
    finally:
        fresh.unlink(missing_ok=True)
    _settle(path.parent)


def _settle(folder: Path) -> None:
    """Makes sure the folder itself is on the disk, where the system lets us."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
