"""Missions as files, on the wire."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.wire.catalogue import CatalogueShape
from kitrobot.wire.gallery import ExampleShape
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.sentences import Spoken
from kitrobot.wire.world import WorldShape


class SessionShape(BaseModel):
    """What the page starts with: the mission to open, and the name of the folder that missions are in.

    `secret` is what the page knows the next studio of this folder by; it keeps it in its memory and never sends it.
    """

    version: str
    path: str | None
    workspace: str
    secret: str


class MissionEntryShape(BaseModel):
    """A mission that can be opened; `modified` is a moment in UTC (ISO 8601).

    `problem` is why it cannot be opened, "" where nothing is known against it.
    Examples are read-only and say more: title (`label`) and what happens (`help`) by language, and `example`.
    """

    path: str
    name: str
    title: str
    modified: str
    label: dict[str, str]
    help: dict[str, str]
    example: ExampleShape | None
    problem: Spoken


class MissionFileShape(BaseModel):
    """A mission opened; `revision` names the content that was read, "" when there is no file yet.

    `parts` names the state of the XML files around it, as `NewsMessage` does.
    """

    path: str
    name: str
    revision: str
    mission: MissionShape
    problems: list[ProblemShape]
    world: WorldShape | None
    catalogue: CatalogueShape
    parts: str = ""


class SaveShape(BaseModel):
    """A mission to be written; `revision` is the one that the page last read or wrote, "" for a new file."""

    path: str
    revision: str
    mission: MissionShape


class SavedShape(BaseModel):
    """What was written; `locked`: whether nobody else could save meanwhile; not so where the folder knows no locks."""

    path: str
    revision: str
    locked: bool = True


class ConflictShape(BaseModel):
    """The file is not what the page last saw; `revision` is what it is now."""

    message: Spoken
    help: Spoken
    revision: str


class MissionTextShape(BaseModel):
    """A mission to be written out, unsaved."""

    mission: MissionShape


class TextShape(BaseModel):
    """The canonical text of a `.krt`."""

    text: str
