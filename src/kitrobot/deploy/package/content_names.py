"""Names of files on a board: by what is in them, so that what is unchanged keeps its name."""

from __future__ import annotations

import hashlib

MODULE, PROGRAM, DIGITS = "kr", "kp", 8
"""What the names of modules and of programs begin with, and how many digits follow."""

TEAM_DRIVER = "team"
"""The driver of what a robot has of its team; the code of a member comes with it."""


def name_of(content: bytes, kind: str = MODULE) -> str:
    """The name of something by its content."""
    return kind + hashlib.sha256(content).hexdigest()[:DIGITS]
