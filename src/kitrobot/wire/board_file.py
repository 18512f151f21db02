"""A program as a file for a board's drive, on the wire."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from pydantic import Base64Bytes, BaseModel, Field

from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Clause, Spoken


class BoardFileAskShape(BaseModel):
    """Which program of a mission is to become a file, on which kit, "" as its robot's own file says.

    `firmware`: the bytes of the UF2 file that comes along in base64, "" for a micro:bit; `firmware_name`: of that file.
    """

    mission: MissionShape
    path: str
    program: str
    kit: str
    firmware: Base64Bytes
    firmware_name: str = Field(max_length=200)


class BoardFileShape(BaseModel):
    """The bytes of the file in base64, the ending of its name, the boards that it is for, what is done with it, and why
    it is not for another board.
    """

    file: str
    ending: Literal[".hex", ".uf2"]
    boards: Clause
    steps: Spoken
    reasons: Sequence[Spoken]
