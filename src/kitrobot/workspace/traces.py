"""Recordings: the parts that a mission needs to be viewed anywhere, and a recording opened again.

A `.krtrace` contains its mission, its world and the XML files that are not shipped with KitRobot. `unpack` writes them
side by side into a folder, where the mission opens like any other. A recording may come from anywhere: its mission and
world are read as carefully as files, and file names are accepted only if they stay in that folder.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from kitrobot.files.disk import FileError, read_bytes, write_atomic
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.primitives.catalogue import SHIPPED
from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING
from kitrobot.trace.model import TraceError, TraceHeader, TracePart
from kitrobot.trace.reader import TraceReader
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.world.lookup import EMPTY
from kitrobot.world.model import World
from kitrobot.world.xml_reader import read_world

_DECLARATION = re.compile(r"\A\s*<\?xml[^>]*\?>\s*")
_NAME = re.compile(r"[^\\/:*?\"<>|\x00-\x1f\x7f]{1,200}\.xml", re.IGNORECASE)


@dataclass(frozen=True)
class OpenTrace:
    """A recording that can be played: the file, what it holds, and the mission and world in it.

    Whoever opened it closes `reader`; one reader is for one thread at a time.
    """

    reader: TraceReader
    mission: Mission
    world: World

    @property
    def stem(self) -> str:
        """Its file's name without the ending."""
        name = self.reader.path.name
        return name[: -len(ENDING)] if name.lower().endswith(ENDING) else name


def is_trace(name: str) -> bool:
    """Whether a file's name says that it is a recording."""
    return name.lower().endswith(ENDING)


def open_trace(path: Path) -> OpenTrace:
    """Opens a recording.

    Raises:
        TraceError: it cannot be read, is damaged, or its mission or world cannot be used.
    """
    reader = TraceReader(path)
    try:
        mission, problems = read_mission(reader.header.mission.encode(), path.name)
        if mission is None:
            raise TraceError(Sentence("the mission in the trace {path} cannot be used", path.name), "", tuple(problems))
        world, found = read_world(reader.header.world.encode(), path.name)
        if world is None:
            raise TraceError(Sentence("the world in the trace {path} cannot be used", path.name), "", tuple(found))
        # What is damaged is told now, not in the middle of playing.
        assert reader.events is not None
        if reader.last_tick < 0:
            raise TraceError(
                Sentence("the trace {path} holds no ticks", path.name),
                Sentence("it was cut before the first of them was written"),
            )
    except BaseException:
        reader.close()
        raise
    return OpenTrace(reader, mission, world)


def parts_of(opened: OpenMission) -> tuple[TracePart, ...]:
    """The XML files of robots and constructors that a mission uses and that do not come with KitRobot."""
    catalogue, programs = opened.catalogue, opened.mission.programs
    elements = {vertex.element for program in programs for vertex in program.vertices}
    robots = {*(program.target for program in programs), *(agent.robot for agent in opened.mission.team.agents)}
    wanted = [catalogue.robot_files.get(name) for name in sorted(robots)]
    wanted += [path for name, path in catalogue.constructor_files.items() if name in elements]
    paths = {path.resolve() for path in wanted if path is not None}
    parts = {}
    for path in sorted(paths):
        if SHIPPED.resolve() not in path.parents and path.name not in parts:
            text = _text_of(path)
            if text is not None:
                parts[path.name] = TracePart(path.name, text)
    return tuple(parts.values())


def _text_of(path: Path) -> str | None:
    """An XML file without its declaration: it is written in UTF-8 again. None for one that went away."""
    try:
        data = read_bytes(path)
        text = data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except (FileError, UnicodeError):
        return None
    return _DECLARATION.sub("", text)


def unpack(trace: OpenTrace, folder: Path) -> Path:
    """Lays what a recording brings along into a folder of its own, and gives the mission's file there.

    Raises:
        FileError: it cannot be written.
    """
    return lay_out(trace.reader.header, trace.mission.world_href, trace.stem, folder)


def lay_out(header: TraceHeader, world_href: str, stem: str, folder: Path) -> Path:
    """Lays the mission of a run, its world and its XML files into a folder of its own, and gives the mission's file.

    Raises:
        FileError: it cannot be written.
    """
    stem = re.sub(r"[\\/:*?\"<>|\x00-\x1f\x7f]", "-", stem).strip(". ")[:100] or "recording"
    href = world_href or EMPTY
    pieces = href.split("/")
    if all(_NAME.fullmatch(f"{one}.xml") for one in pieces) and not {".", ".."} & set(pieces):
        _write(folder / PurePosixPath(href), header.world)
    for part in _sensible(header.parts):
        _write(folder / part.file, part.text)
    path = folder / f"{stem}.krt"
    _write(path, header.mission)
    return path


def _sensible(parts: Iterable[TracePart]) -> Iterable[TracePart]:
    return (part for part in parts if _NAME.fullmatch(part.file) and not part.file.startswith("."))


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomic(path, text.encode())
