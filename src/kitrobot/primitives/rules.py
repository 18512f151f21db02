"""The rules of XML files: what can be wrong with one, each with the page that explains it.

The rules named `xml-…` belong to every kind of file (constructors, robot, mission, world); the others to one kind.
"""

from __future__ import annotations

from kitrobot.diagnostics import Severity, rule

NOT_WELL_FORMED = rule(
    "xml-not-well-formed",
    Severity.ERROR,
    "The file is not XML",
    "Every element that is opened is closed again, in the opposite order; attribute values stand in quotes; in text, "
    "`<` and `&` are written `&lt;` and `&amp;`. A file that was cut off while it was copied shows up here as well.",
)
ENCODING = rule(
    "xml-encoding",
    Severity.ERROR,
    "The file is not UTF-8",
    "Files are read as UTF-8, or as UTF-16 when they begin with a byte order mark. Save the file again as UTF-8.",
)
FORBIDDEN = rule(
    "xml-forbidden",
    Severity.ERROR,
    "The file holds a DTD",
    "A document type or an entity of one's own (`<!DOCTYPE …>`, `<!ENTITY …>`) is never read: entities can make a "
    "small file explode or pull in other files, and nothing here needs them.",
)
TOO_DEEP = rule(
    "xml-too-deep",
    Severity.ERROR,
    "Elements are nested too deep",
    "No file of ours needs more than a handful of levels. Deeper ones are damaged or made to hurt.",
)
TOO_LARGE = rule(
    "xml-too-large",
    Severity.ERROR,
    "The file is too large",
    "A file above the limit is not read at all.",
)
WRONG_ROOT = rule(
    "xml-wrong-root",
    Severity.ERROR,
    "The file is of another kind",
    "The first element says what a file is: `<constructors>`, `<robot>`, `<kitrobot>` for a mission, `<world>`.",
)
NEWER_VERSION = rule(
    "xml-newer-version",
    Severity.ERROR,
    "The file was made by a newer KitRobot",
    "`version` in the first element counts the changes of the format. A file of a version this KitRobot does not know "
    "is not touched, so that nothing in it is lost.",
)
UNKNOWN_ELEMENT = rule(
    "xml-unknown-element",
    Severity.WARNING,
    "An element is not known here",
    "The element is left out, or kept word for word where the message says so; everything else is used.",
)
UNKNOWN_ATTRIBUTE = rule(
    "xml-unknown-attribute",
    Severity.WARNING,
    "An attribute is not known here",
    "The attribute is left out; everything else is used.",
)
STRAY_TEXT = rule(
    "xml-stray-text",
    Severity.WARNING,
    "Text stands where none belongs",
    "The text is left out; everything else is used.",
)
MISSING = rule(
    "xml-missing",
    Severity.ERROR,
    "Something that must be there is missing",
    "An element lacks an attribute or a part that it cannot do without.",
)
BAD_VALUE = rule(
    "xml-bad-value",
    Severity.ERROR,
    "An attribute's value cannot be used",
    "The message says what was expected: a number in a range, one of a few words, a name.",
)
DUPLICATE = rule(
    "xml-duplicate",
    Severity.ERROR,
    "A name is used twice",
    "Things of one kind need different names, else nobody can say which one is meant.",
)
TOO_MANY = rule(
    "xml-too-many-problems",
    Severity.WARNING,
    "More problems than are shown",
    "Only the first problems of a file are listed. Mend those and look again.",
)

TEMPLATE = rule(
    "constructor-template",
    Severity.ERROR,
    "A constructor's code does not fit its slots",
    "`<code>` is LLL with a hole `{name}` for every slot. Each slot has one hole and each hole one slot, of a kind "
    "that fits the place: `flow` where a body stands, `condition` where a test stands, `number` for counts and "
    "waits, `number`, `value` or `text` for a parameter, `action` between `°` and `°`, and a repeated `flow` as a "
    "branch of `//( )`.",
)
SLOT = rule(
    "constructor-slot",
    Severity.ERROR,
    "A slot cannot be used",
    "Slots take part in the names of ports, so `in`, `next` and `return` are taken, and only a `flow` may repeat.",
)
ADDS = rule(
    "constructor-adds",
    Severity.ERROR,
    "A constructor adds to a slot that is not there",
    '`<adds constructor="…" slot="…"/>` names a constructor and its slot with `repeat="yes"`.',
)

RANGE = rule(
    "robot-range",
    Severity.ERROR,
    "Numbers contradict one another",
    "`min` is at most `max`, and what lies between them (`default`, `initial`, `to`) really does.",
)
STOP = rule(
    "robot-stop",
    Severity.ERROR,
    "`stop` names no procedure that can stop",
    "`stop` names a procedure of the same actuator that has no parameters, because it is done without asking.",
)
METHOD = rule(
    "robot-method",
    Severity.ERROR,
    "An operation does not say what it tests",
    'An operation is a value (`value="yes"`) or a test (`test="equal"`, `less`, `greater`) with either `to` or one '
    "parameter.",
)
PHRASE = rule(
    "robot-phrase",
    Severity.WARNING,
    "A phrase has a hole that nothing fills",
    "A phrase may hold `{object}` and `{NAME}` for each parameter.",
)

BOARD = rule(
    "robot-board",
    Severity.ERROR,
    "A real robot's driver cannot be told this",
    "`<board>` says which driver works an actuator or a sensor on a real robot, and its settings: pins and the like. "
    "They travel to small boards in one short line, so a name or a value has 1 to 60 characters, without spaces, line "
    'breaks, `=` and `"`, and a driver has 16 settings at most.',
)

TOO_MANY_OWN = rule(
    "own-too-many",
    Severity.ERROR,
    "A mission brings along more parts than can be used",
    "Constructors and variables of a mission's own have a limit each. What is too much is kept in the file.",
)
OWN_VARIABLE = rule(
    "own-variable",
    Severity.ERROR,
    "A variable of the mission has the name of something that the robot has already",
    "A mission may add variables to a robot. Its programs call them by name, so the name must be free.",
)

UNREADABLE = rule(
    "catalogue-unreadable",
    Severity.ERROR,
    "A file or folder cannot be read",
    "The operating system refused. The file is left out; all others are used.",
)
SAME_FOLDER = rule(
    "catalogue-twice",
    Severity.WARNING,
    "One folder holds the same thing twice",
    "A later folder may replace what an earlier one brought, but two files of one folder should not: the later file "
    "name wins.",
)
