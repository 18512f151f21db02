"""What can be opened, as a list: the missions of the folder by path, then the examples, the easiest first.

An example has its title, what happens in it, its difficulty and its topics; what it does is fetched for each
picture that is seen. An example is read again only when its file changed. A mission of the folder is known by its
file's name alone: what was copied from an example keeps the example's title inside, which would mislead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.folder import EXAMPLE, MissionFolder
from kitrobot.files.listing import MissionEntry
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.wire.files import MissionEntryShape
from kitrobot.wire.gallery import ExampleShape, RunPreviewShape, TopicShape, run_preview_shape
from kitrobot.workspace.example_list import shipped_examples
from kitrobot.workspace.exercises import Exercises
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.previews import Previews
from kitrobot.workspace.tutorials import Tutorials


class GallerySource(Protocol):
    """A studio, as far as the list of its missions needs it."""

    folder: MissionFolder
    tutorials: Tutorials
    exercises: Exercises
    previews: Previews

    def read(self, data: bytes, name: str, path: str) -> OpenMission:
        """A mission that was read from bytes, with the parts beside it."""


@dataclass(frozen=True)
class CachedEntry:
    """The entry of an example, of one revision of its file."""

    revision: str
    shape: MissionEntryShape


class Gallery:
    """The list of a studio. Safe to use from many threads: what two make at once is the same."""

    def __init__(self) -> None:
        self._cache: dict[str, CachedEntry] = {}

    def entries(self, source: GallerySource) -> list[MissionEntryShape]:
        """Every mission that can be opened; what a tutorial or an exercise begins with is no example."""
        found = source.folder.missions()
        starts = source.tutorials.starts() | source.exercises.starts()
        own = [_plain_entry(entry) for entry in found if not entry.example]
        examples = [self._example(source, entry) for entry in found if entry.example and entry.path not in starts]
        return own + sorted(examples, key=_difficulty)

    def _example(self, source: GallerySource, entry: MissionEntry) -> MissionEntryShape:
        try:
            data, revision = source.folder.read(entry.path)
        except KitRobotError:
            return _plain_entry(entry)  # opening it says what is wrong
        kept = self._cache.get(entry.path)
        if kept is None or kept.revision != revision:
            mission, _ = read_mission(data, entry.path)
            kept = self._cache[entry.path] = CachedEntry(
                revision, _plain_entry(entry) if mission is None else _described_entry(entry, mission)
            )
        return kept.shape

    def preview(self, source: GallerySource, path: str) -> RunPreviewShape:
        """What an example does in its first seconds.

        Raises:
            KitRobotError: there is no such example, or it cannot be opened.
        """
        data, _ = source.folder.read(path)
        opened = source.read(data, path, path)
        listed = shipped_examples().examples.get(path.removeprefix(EXAMPLE))
        preview = source.previews.of(opened, hands=listed.hands if listed is not None else ())
        return run_preview_shape(opened, preview)


def _plain_entry(entry: MissionEntry) -> MissionEntryShape:
    return MissionEntryShape(
        path=entry.path,
        name=entry.name,
        title=entry.title,
        modified=entry.modified,
        label={},
        help={},
        example=None if not entry.example else _example_shape(entry, None),
        problem=entry.problem,
    )


def _described_entry(entry: MissionEntry, mission: Mission) -> MissionEntryShape:
    plain = _plain_entry(entry)
    plain.label, plain.help = dict(mission.label), dict(mission.help)
    plain.title = plain.label.get("", plain.title)
    plain.example = _example_shape(entry, mission)
    return plain


def _example_shape(entry: MissionEntry, mission: Mission | None) -> ExampleShape:
    known = shipped_examples()
    listed = known.examples.get(entry.path.removeprefix(EXAMPLE))
    topics = [topic for topic in known.topics if listed is not None and topic.name in listed.topics]
    programs = mission.programs if mission is not None else []
    agents = mission.team.agents if mission is not None else []
    targets = [one.target for one in programs if one.target] + [one.robot for one in agents if one.robot]
    return ExampleShape(
        level=listed.level if listed is not None else 0,
        topics=[TopicShape(name=topic.name, label=dict(topic.label)) for topic in topics],
        robots=list(dict.fromkeys(targets)),
        agents=len(agents),
        # Start and Stop are in every program.
        parts=max(0, len(programs[0].vertices) - 2) if programs else 0,
    )


def _difficulty(entry: MissionEntryShape) -> tuple[int, int, str]:
    """Fewer robots first, then fewer parts; what cannot be opened last."""
    made = entry.example
    if made is None or made.agents == 0:
        return 10**9, 0, entry.path
    return made.agents, made.parts, entry.path
