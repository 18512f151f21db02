"""The kinds of attributes that constructors, robots and tutorials share."""

from __future__ import annotations

import re
from dataclasses import replace

from kitrobot.lll.tokens import is_name
from kitrobot.primitives.levels import Level
from kitrobot.primitives.robot import LARGEST_VALUE
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import Kind, one, optional, whole
from kitrobot.xml.element import LONGEST_NAME

COLOURS = ("loop", "choice", "parallel", "action", "test", "team")
"""The categories of the studio's colours."""

COLOUR = one(*COLOURS, name="colour")

FIGURES = (
    "mini-robot",
    "carrier",
    "loader",
    "unloader",
    "store-manager",
    "line-follower",
    "kit-rover",
    "micro-bit",
)
"""How the page can draw a robot."""

FIGURE = one(*FIGURES, name="figure")

IDENTIFIER = Kind(
    longest=LONGEST_NAME,
    pattern=r"[\p{L}_][\p{L}\p{M}\p{N}_]*",
    fits=is_name,
    words=Sentence("a name of letters, digits and _ (not WAIT or BREAK)"),
    name="identifier",
    about="Letters of any script, digits and _; not a digit first.",
)
"""A name of the language."""

ROBOT_NUMBER = whole(
    -LARGEST_VALUE, LARGEST_VALUE, "robot-number", about="A whole number that the smallest board can hold."
)

VALUE_TYPE = one("integer", "boolean", name="value-type")

TRUTH = one("true", "false", "1", "0", name="truth")

VALUE = Kind(options=TRUTH.options, least=ROBOT_NUMBER.least, most=ROBOT_NUMBER.most, either=(ROBOT_NUMBER, TRUTH))
"""A number, or for a boolean whether it is true."""

ROBOT_NAME = Kind(
    longest=LONGEST_NAME,
    pattern=r"\p{L}[\p{L}\p{M}\p{N}_\-]*",
    fits=re.compile(r"[^\W\d_][\w-]*").fullmatch,
    words=Sentence("a name of letters, digits, _ and -"),
)
"""What a robot may be called."""

NAMED_ROBOT = replace(ROBOT_NAME, words=Sentence("the name of a robot"))
"""What a robot is called, where another file names it."""

USUAL_MAXIMUM = 100
"""The top of a range that gives none: the paper's numbers go from 0 to 100."""

RANGE = {
    "min": optional(ROBOT_NUMBER, "0"),
    "max": optional(ROBOT_NUMBER, str(USUAL_MAXIMUM)),
}
"""The ends of a range of numbers."""

HOLDS = one("actuators", "sensors", "values", name="held-parts")
"""Which parts of a robot stand in a tab of the palette: values are variables, and what every robot has."""

LEVEL = one(*Level, name="level")
"""Of whom a program speaks."""
