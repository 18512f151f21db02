"""`<board>` of a robot's actuator or sensor, and the parts of a kit → `Board`: the settings of a real robot's driver.

They travel to small boards in a line whose words are separated by spaces, so characters that would break such a line
are refused. Left to others: which drivers there are, and which settings one understands (drivers).
"""

from __future__ import annotations

import re

from kitrobot.primitives import rules
from kitrobot.primitives.robot import LONGEST_SETTING, MOST_SETTINGS, Board
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import Kind, optional
from kitrobot.xml.element import Element, Tag

_DRIVER = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_BREAKING = frozenset(' ="')


def _fits(text: str) -> bool:
    return 0 < len(text) <= LONGEST_SETTING and text.isprintable() and not _BREAKING & set(text)


def read_board(element: Element, ours: frozenset[str] = frozenset({"driver"})) -> Board:
    """What an element tells a driver: its `driver`, and every attribute that is none of `ours` as a setting."""
    driver = element.attributes.get("driver")
    if driver is not None and not (_DRIVER.fullmatch(driver) and len(driver) <= LONGEST_SETTING):
        expected = Sentence("1 to {longest} of the letters a to z, digits, _ and -, a letter first", LONGEST_SETTING)
        element.bad_value("driver", expected, Sentence("without it, the driver is the one with the name of the device"))
    settings = {name: value for name, value in element.attributes.items() if name not in ours}
    if len(settings) > MOST_SETTINGS:
        message = Sentence(
            "expected at most {most} settings on <{element}>, found {count}", MOST_SETTINGS, element.name, len(settings)
        )
        element.report(rules.BOARD, message)
    for name, value in settings.items():
        if not _fits(name):
            message = Sentence(
                "expected at most {longest} characters in the name of a setting, found {found}",
                LONGEST_SETTING,
                shown(name),
            )
            element.report(rules.BOARD, message, name)
        elif not _fits(value):
            expected = Sentence("1 to {longest} characters without spaces, = and quotation marks", LONGEST_SETTING)
            help = Sentence("they travel to small boards in one short line; put a comma where a space would be")
            element.report(
                rules.BOARD,
                Sentence("expected {expected} in {attribute}, found {found}", expected, name, shown(value)),
                name,
                help,
            )
    return Board(driver or "", settings)


_DRIVER_NAME = Kind(longest=LONGEST_SETTING, pattern=r"[A-Za-z][A-Za-z0-9_\-]*")
BOARD = Tag(
    read_board,
    {"driver": optional(_DRIVER_NAME, about="The driver; without it the device.")},
    free_attributes=True,
    about="At most one: what the real robot's driver is told, pins and the like. Attributes beside driver are its "
    f'settings: 1 to {LONGEST_SETTING} characters without spaces, = and ". The simulator does not look at it.',
)
"""What the real robot's driver of an actuator or a sensor is told."""
