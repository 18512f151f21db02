"""A program's image, on the wire."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.wire.mission import MissionShape


class ImageAskShape(BaseModel):
    """Which program of a mission is to become an image; `path` is where the mission lies, "" for nowhere."""

    mission: MissionShape
    path: str
    program: str


class ImageShape(BaseModel):
    """A program without errors, compiled: the bytes of its `.kri` in base64, and the text of its `.kra`."""

    image: str
    listing: str
