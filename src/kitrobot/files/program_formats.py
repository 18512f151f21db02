"""The forms a program has on disk, told apart by the ending of the file's name."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence


class Form(StrEnum):
    """A form of a program; the value is the ending of its files' names."""

    MISSION = ".krt"
    TEXT = ".lll"
    IMAGE = ".kri"
    LISTING = ".kra"
    TREE = ".xml"

    @property
    def words(self) -> str:
        """What people call it."""
        return _WORDS[self]


_WORDS = {
    Form.MISSION: Sentence("mission (graphs)"),
    Form.TEXT: Sentence("LLL text"),
    Form.IMAGE: Sentence("image for a robot"),
    Form.LISTING: Sentence("three-address listing"),
    Form.TREE: Sentence("behaviour tree (BehaviorTree.CPP 4)"),
}


class FormError(KitRobotError):
    """A file's name does not say which form it has, or that form does not serve here."""


def form_of(path: Path, allowed: tuple[Form, ...] = tuple(Form)) -> Form:
    """The form that a file's name tells.

    Raises:
        FormError: the ending is none of the `allowed` ones; the message lists them.
    """
    ending = path.suffix.lower()
    for form in allowed:
        if form.value == ending:
            return form
    endings = ", ".join(f"`{form.value}` ({form.words})" for form in allowed)
    told = Sentence("the ending `{suffix}`", path.suffix) if path.suffix else Sentence("no ending")
    raise FormError(
        Sentence("`{path}` has {told}, so its form is not known", path, told),
        Sentence("known here: {endings}", endings),
    )
