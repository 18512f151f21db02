"""The examples of the gallery: their topics, how hard each is, and the inputs by hand in its preview.

The list is read from `shipped/examples.xml`. An example that is not in it is shown without a topic. Left to others: the
title and help of an example, which are in its mission.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.workspace.previews import Hand
from kitrobot.xml.attributes import NAME, TEXT_VALUE, Kind, decimal, needed, version, whole
from kitrobot.xml.element import LONGEST_NAME, Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

VERSION = 1
"""The newest version of the list that is read."""

LEVELS = 3
"""Levels are 1, the easiest, to this."""

EXAMPLES_XML = Path(__file__).parent / "shipped" / "examples.xml"


@dataclass(frozen=True)
class Topic:
    """What examples can be about."""

    name: str
    label: Mapping[str, str]


@dataclass(frozen=True)
class ListedExample:
    """An example in the list: its path among the examples, its level, what it is about."""

    mission: str
    level: int
    topics: tuple[str, ...]
    hands: tuple[Hand, ...] = ()


@dataclass(frozen=True)
class ExampleList:
    """All of them; topics in the order in which they are shown."""

    topics: tuple[Topic, ...] = ()
    examples: Mapping[str, ListedExample] = field(default_factory=dict)


_MISSION = Kind(
    longest=LONGEST_NAME,
    fits=re.compile(r"[\w-][\w.-]*(/[\w-][\w.-]*)*\.krt").fullmatch,
    words=Sentence("the path of a .krt"),
)


def _topic(element: Element) -> Topic:
    return Topic(element.matching("name"), element.texts.get("label", {}))


def _hand(element: Element) -> Hand:
    return Hand(
        element.matching("agent"),
        element.matching("sensor"),
        element.integer("value"),
        element.decimal("at"),
        element.decimal("seconds"),
    )


def _example(element: Element) -> ListedExample:
    return ListedExample(
        element.matching("mission"),
        element.integer("level"),
        tuple(element.required("topics").split()),
        tuple(element.found(Hand)),
    )


EXAMPLES = {
    "examples": Tag(
        None,
        {"version": version(VERSION)},
        {
            "topic": Tag(_topic, {"name": needed(NAME)}, TEXTS),
            "example": Tag(
                _example,
                {"mission": needed(_MISSION), "level": needed(whole(1, LEVELS)), "topics": needed(TEXT_VALUE)},
                {
                    "hand": Tag(
                        _hand,
                        {
                            "agent": needed(NAME),
                            "sensor": needed(NAME),
                            "value": needed(whole(0, 65_535)),
                            "at": needed(decimal(0, 60)),
                            "seconds": needed(decimal(0.1, 60)),
                        },
                    )
                },
            ),
        },
        open=lambda root: root.version(VERSION),
    )
}


def read_examples(data: bytes, name: str) -> tuple[ExampleList | None, list[Diagnostic]]:
    """Reads a list of examples; None when it has an error, which the diagnostics tell."""
    reader = Reader(data, name)
    root = reader.read(EXAMPLES)
    if root is None:
        return None, reader.diagnostics
    topics = tuple(root.found(Topic))
    known = [topic.name for topic in topics]
    for example, element in root.found_at(ListedExample):
        strange = [topic for topic in example.topics if topic not in known]
        if strange:
            wanted = Sentence("topics of this list ({topics})", Series(COMMA, known))
            element.bad_value("topics", wanted, element.did_you_mean(strange[0], known))
    if root.faulty:
        return None, reader.diagnostics
    return ExampleList(topics, {one.mission: one for one in root.found(ListedExample)}), reader.diagnostics


@cache
def shipped_examples() -> ExampleList:
    """The list that comes with KitRobot."""
    made, problems = read_examples(EXAMPLES_XML.read_bytes(), EXAMPLES_XML.name)
    assert made is not None, problems
    return made
