"""A program as a file for a board's drive, on the wire."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic import BaseModel

from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Clause, Spoken


class BoardFileAskShape(BaseModel):
    """Which program of a mission is to become a file, on which kit, "" as its robot's own file says."""

    mission: MissionShape
    path: str
    program: str
    kit: str


class BoardFileShape(BaseModel):
    """The bytes of the `.hex` in base64, the boards that it is for, and why it is not for another one."""

    file: str
    boards: Clause
    reasons: Sequence[Spoken]
