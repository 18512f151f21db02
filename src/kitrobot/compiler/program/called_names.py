"""The callable names of a robot, and suggestions for misspelt ones."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from kitrobot.primitives.robot import Method, Robot
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import Suggestions


class CalledNames:
    """Objects of a robot and their methods, by name."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._suggestions = Suggestions()

    @cached_property
    def methods(self) -> dict[str, list[Method]]:
        """What each name of an object offers, in the order of the robot."""
        table: dict[str, list[Method]] = {}
        for (name, _), (_, method) in self._robot.calls.items():
            table.setdefault(name, []).append(method)
        return table

    @cached_property
    def objects(self) -> list[str]:
        """The names of the robot's objects that can be called, in the order of the alphabet."""
        return sorted(self.methods)

    def suggested(self, name: str, known: Sequence[str]) -> tuple[str, Help]:
        """The most similar known name, and a help sentence with it; without one the sentence lists what there is."""
        near = self._suggestions.nearest(name, known)
        if near:
            return near, Sentence("did you mean {near}?", near)
        return "", Sentence("there is {known}", listed(known)) if known else ""
