"""The rules of constructors, robots and own parts: what can be wrong, each with the page that explains it."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

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

SEARCH_WORD = rule(
    "palette-word",
    Severity.WARNING,
    "A word that finds a part cannot be used",
    "`<word>` holds words that find a part in the palette besides its names, with commas between: 30 of them at most "
    "in one language, of 30 characters at most. The part is there, and is found by the other words.",
)
PALETTE_GROUP = rule(
    "palette-group",
    Severity.WARNING,
    "A part stands in a tab of the palette that is not there",
    '`group="…"` of an actuator, a sensor, a procedure or an operation is the name of a `<group>` of a constructors '
    "file. The part stands where it would without it.",
)
MEANING = rule(
    "robot-meaning",
    Severity.ERROR,
    "What a number means cannot be shown",
    "A `<choice>` has a `<label>` and one picture at most: `icon`, `lights` or `colour`. A number has 64 of them at "
    "most, and the fields `lights` and `colour` need such a picture in each; `choices` needs one choice at least.",
)

BOARD = rule(
    "robot-board",
    Severity.ERROR,
    "A real robot's driver cannot be told this",
    "`<board>` says which driver works an actuator or a sensor on a real robot, and its settings: pins and the like. "
    "They travel to small boards in one short line, so a name or a value has 1 to 60 characters, without spaces, line "
    'breaks, `=` and `"`, and a driver has 24 settings at most.',
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
