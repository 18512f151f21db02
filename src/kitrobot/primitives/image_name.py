"""By what the image that an agent runs is known: the name of its program, and its kind of robot in a team's program."""

from __future__ import annotations

from typing import NamedTuple


class ImageName(NamedTuple):
    r"""What an agent runs; `robot` is "" for a program of one robot.

    >>> ImageName("swap", "carrier").text
    'swap\ncarrier'
    >>> ImageName.parse("drive")
    ImageName(program='drive', robot='')
    """

    program: str
    robot: str = ""

    @property
    def text(self) -> str:
        """The same as one text, as files have it."""
        return f"{self.program}\n{self.robot}" if self.robot else self.program

    @classmethod
    def parse(cls, text: str) -> ImageName:
        """The name that such a text says."""
        program, _, robot = text.partition("\n")
        return cls(program, robot)
