"""The journal on the wire: records are texts that only the page understands."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Spoken
from kitrobot.wire.values import View

MOST_RECORDS = 100_000

Records = Annotated[list[str], Field(max_length=MOST_RECORDS)]


class ClaimShape(BaseModel):
    """The page opened a mission; `journal` is the one it had before, or chose, "" for any that was left on it."""

    tab: str
    path: str
    journal: str


class JournalShape(BaseModel):
    """A whole journal, to take the place of the one that the page writes; without records there is none any more."""

    tab: str
    path: str
    name: str
    records: Records
    unsaved: bool


class JournalAppendShape(BaseModel):
    """Records to be written behind the others; `first` is the number of the first of them."""

    tab: str
    first: int
    records: Records
    unsaved: bool


class JournalSizeShape(BaseModel):
    """How large the journal is now."""

    bytes: int


class OrphanedJournalShape(View):
    """Unsaved work that was left behind; `problem` is why it cannot be opened, "" where it can."""

    journal: str
    path: str
    name: str
    modified: str
    problem: Spoken


class ForgetShape(BaseModel):
    """Unsaved work that nobody wants."""

    journal: str


class DifferenceAskShape(BaseModel):
    """A mission to be held against its file."""

    path: str
    mission: MissionShape


class DifferenceShape(BaseModel):
    """What is different in the mission from its file, a sentence each; `revision` is the file's."""

    revision: str
    changes: list[str]


class MergeAskShape(BaseModel):
    """A mission to be merged with its file: both were made of `base`. `taken` are the conflicts that the file wins."""

    path: str
    base: MissionShape
    mission: MissionShape
    taken: list[str]


class ConflictedShape(BaseModel):
    """What both changed differently: what it is, what became of it, and both values in words, "" where they are long.

    `taken`: the file's is taken. `open`: there is something to decide.
    """

    name: str
    what: str
    sentence: str
    ours: str
    theirs: str
    taken: bool
    open: bool


class MergedShape(BaseModel):
    """A mission with the edits of its file, and what both changed differently. `theirs` is that revision."""

    revision: str
    mission: MissionShape
    theirs: MissionShape
    conflicts: list[ConflictedShape]


class _Message(BaseModel):
    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


class HelloMessage(_Message):
    """The first message of `WS /api/watch`: the name of the page's tab."""

    type: Literal["hello"] = "hello"
    tab: str


class HereMessage(_Message):
    """The answer to whatever the page says: the studio answers questions."""

    type: Literal["here"] = "here"


class NewsMessage(_Message):
    """What is on disk for the page's mission ("" when nothing is), and how many other pages have it open.

    `parts` names the state of the XML files that the mission depends on: robots, constructors, its world. `runs` are
    the runs of the mission that are on, on this page or another.
    """

    type: Literal["news"] = "news"
    path: str
    revision: str
    others: int
    parts: str
    runs: list[str] = []


WATCH_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (HelloMessage, HereMessage, NewsMessage)
