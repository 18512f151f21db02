"""What an attribute may be: the facts that both the reading of a file and its schema are made from."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass

from kitrobot.text.sentences import Sentence


@dataclass(frozen=True, slots=True)
class Kind:
    """The values an attribute may have.

    `base` is a type of XML Schema. Numbers lie in `least` … `most`; `options` are all there are; `either` stands for
    the values of several kinds. A text has `shortest` … `longest` characters and is what `pattern` says in the language
    of XML Schema, `fits` in Python and `words` in a message. A kind with a `name` is a type of the schema.
    """

    base: str = "string"
    least: float = -math.inf
    most: float = math.inf
    shortest: int = 0
    longest: int | None = None
    pattern: str = ""
    options: tuple[str, ...] = ()
    either: tuple[Kind, ...] = ()
    fits: Callable[[str], object] | None = None
    words: str = ""
    name: str = ""
    about: str = ""


@dataclass(frozen=True, slots=True)
class Attribute:
    """One attribute of an element: its kind, whether it must be there, what it is without being there."""

    kind: Kind
    needed: bool = False
    default: str | None = None
    about: str = ""


TEXT_VALUE = Kind()
"""Any text."""

NAME = Kind(shortest=1, name="name")
"""Any text but none."""

YES_NO = Kind(options=("yes", "no"), name="yes-no")


def whole(least: int, most: int, name: str = "", about: str = "") -> Kind:
    """Whole numbers `least` … `most`."""
    return Kind("integer", least, most, name=name, about=about)


def decimal(least: float, most: float, name: str = "") -> Kind:
    """Numbers `least` … `most`, with or without a decimal point."""
    return Kind("double", least, most, name=name)


def one(*options: str, name: str = "") -> Kind:
    """One of these words."""
    return Kind(options=options, name=name)


def needed(kind: Kind = NAME, about: str = "") -> Attribute:
    """An attribute that must be there."""
    return Attribute(kind, needed=True, about=about)


def optional(kind: Kind = TEXT_VALUE, default: str | None = None, about: str = "") -> Attribute:
    """An attribute that may be left out."""
    return Attribute(kind, default=default, about=about)


def version(newest: int) -> Attribute:
    """The version of a format: the one that is written."""
    return needed(Kind("integer", options=(str(newest),), name=f"version-{newest}"))


_ICON = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
ICON = Kind(
    pattern=_ICON.pattern,
    fits=_ICON.fullmatch,
    words=Sentence("the name of a Lucide icon, such as arrow-up,"),
    name="icon",
    about="The name of a picture of the Lucide set, such as arrow-up.",
)
"""The name of a picture."""
