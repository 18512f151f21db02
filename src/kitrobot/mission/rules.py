"""The rules of missions: what can be wrong with one beyond its XML and its programs."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

NO_PROGRAM = rule(
    "mission-no-program",
    Severity.ERROR,
    "An agent has no program",
    "Every agent of the team names one of the mission's programs.",
)
AGENT_ROBOT = rule(
    "mission-agent-robot",
    Severity.ERROR,
    "It is not clear which kind of robot an agent is",
    "A program of one robot says for which kind it is. One of the level social is run by robots of several kinds, so"
    ' each agent that runs it says its own with `robot="…"`. Agents of one mission run at most one such program.',
)
WORLD = rule(
    "mission-world",
    Severity.ERROR,
    "A mission has more than one world",
    "A mission takes place in one world: that of a file, which `href` names, or one of its own, inside `<world>`.",
)
GOAL = rule(
    "mission-goal",
    Severity.ERROR,
    "A goal cannot be understood",
    'A goal says how many boxes a storehouse holds in the end: a whole number, or "all".',
)
BREAKPOINT = rule(
    "mission-breakpoint",
    Severity.ERROR,
    "A breakpoint cannot be understood",
    "A breakpoint names a vertex of a program. Its condition is LLL such as Count.GreaterThan(3).",
)
PROPERTY = rule(
    "mission-property",
    Severity.WARNING,
    "A property cannot be checked",
    "A property has a name of its own and one of the forms of the Check page of the documents, such as never A, or"
    " after A always eventually B within so many seconds. A and B are LLL in which each test says whose it is:"
    " any carrier-1 (Cargo.IsPressed()). It names agents of the team, or a program for all agents that run it, and what"
    " their robots sense or keep.",
)
PROPERTY_FORM = rule(
    "mission-property-form",
    Severity.ERROR,
    "A property has none of its forms",
    "A property says never (and while), eventually, after and eventually, stays and until, holds and for, at-most and"
    " times, first and before, again, or visit (and order). Some may say within. What it says is kept as it is.",
)
FAILURE = rule(
    "mission-failure",
    Severity.WARNING,
    "A failure cannot happen",
    "A failure on schedule names an agent of the team. Cut off from others (apart) are robots with a radio.",
)
RADIO = rule(
    "mission-radio",
    Severity.ERROR,
    "A mission has two radios",
    "How robots hear each other is said once, for all of them.",
)
BREAKDOWN = rule(
    "mission-breakdown",
    Severity.ERROR,
    "What becomes of a robot that fails on a road cannot be understood",
    "A mission says it once: `stay`, `tow` with the seconds until then in `after`, or `pass`, so that others drive"
    " round it.",
)
