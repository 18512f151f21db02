"""What can be opened, as a list: the missions of the folder by path, then the examples, the easiest first.

An example says its title, what happens in it, and what its picture is drawn from; the page draws the picture itself, so
there is none to keep up to date. Examples are read again only when their file changed. A mission of the folder is known
by its file's name alone: what was copied from an example keeps the example's title inside, which would mislead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from kitrobot.diagnostics import KitRobotError
from kitrobot.files import MissionEntry
from kitrobot.server.shapes import MissionEntryShape, PictureShape, mission_shape, world_shape
from kitrobot.workspace import OpenMission

if TYPE_CHECKING:
    from kitrobot.server.studio import Studio


@dataclass(frozen=True)
class _Kept:
    revision: str
    shape: MissionEntryShape


class Gallery:
    """The list of a studio. Safe to use from many threads: what two make at once is the same."""

    def __init__(self) -> None:
        self._kept: dict[str, _Kept] = {}

    def entries(self, studio: Studio) -> list[MissionEntryShape]:
        """Every mission that can be opened; what a tutorial or an exercise begins with is no example."""
        found = studio.folder.missions()
        starts = studio.tutorials.starts() | studio.exercises.starts()
        own = [_plain(entry) for entry in found if not entry.example]
        examples = [self._example(studio, entry) for entry in found if entry.example and entry.path not in starts]
        return own + sorted(examples, key=_difficulty)

    def _example(self, studio: Studio, entry: MissionEntry) -> MissionEntryShape:
        try:
            data, revision = studio.folder.read(entry.path)
            kept = self._kept.get(entry.path)
            if kept is None or kept.revision != revision:
                opened = studio.read(data, entry.path, entry.path)
                kept = self._kept[entry.path] = _Kept(revision, _told(entry, opened))
        except KitRobotError:
            return _plain(entry)  # opening it says what is wrong
        return kept.shape


def _plain(entry: MissionEntry) -> MissionEntryShape:
    return MissionEntryShape(
        path=entry.path,
        name=entry.name,
        title=entry.title,
        example=entry.example,
        modified=entry.modified,
        label={},
        help={},
        picture=None,
        problem=entry.problem,
    )


def _told(entry: MissionEntry, opened: OpenMission) -> MissionEntryShape:
    shape = mission_shape(opened.mission)
    plain = _plain(entry)
    plain.title = shape.label.get("", plain.title)
    plain.label, plain.help = shape.label, shape.help
    if shape.programs:
        world = world_shape(opened.world) if opened.world is not None else None
        agents = [agent.start or agent.name for agent in shape.agents]
        plain.picture = PictureShape(program=shape.programs[0], world=world, agents=agents)
    return plain


def _difficulty(entry: MissionEntryShape) -> tuple[int, int, str]:
    """Fewer robots first, then fewer parts."""
    if entry.picture is None:
        return 10**9, 0, entry.path
    return len(entry.picture.agents), len(entry.picture.program.vertices), entry.path
