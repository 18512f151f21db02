"""The rules of runs: why a mission that reads and compiles cannot be run in its world, or does nothing there."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

TOO_MANY = rule(
    "run-too-many-agents",
    Severity.ERROR,
    "More agents than can be simulated",
    "A run holds a limited number of agents; the message says how many.",
)
NO_AGENT = rule(
    "run-no-agent",
    Severity.ERROR,
    "The team is empty",
    "A run needs at least one agent: a name, and the program it runs.",
)
NO_PROGRAM = rule(
    "run-no-program",
    Severity.ERROR,
    "A program cannot run",
    "Every agent's program must be there, be without errors, and be for a robot that is at hand.",
)
START = rule(
    "run-start",
    Severity.ERROR,
    "An agent cannot start",
    "An agent starts at the world's `<start>` of its name, or the one its `start` names. What its devices need must be "
    'there: wheels with guide="road" a road, arm and presence sensor a dock, a store sensor a storehouse. Robots start '
    "apart from one another and from the walls.",
)
DEVICE = rule(
    "run-device",
    Severity.ERROR,
    "A device cannot be simulated",
    "`device` in a robot's XML names a device of the simulator; its settings are attributes with units and bounds, and "
    "its procedures have the names the device understands.",
)
SHARED = rule(
    "run-shared",
    Severity.ERROR,
    "A shared variable has two meanings",
    "A shared variable is one for the whole team, so every robot that has it defines it alike: type, range, initial.",
)
GOAL = rule(
    "run-goal",
    Severity.ERROR,
    "A goal names no storehouse",
    "The storehouse of a goal must be in the mission's world.",
)
ROLE = rule(
    "run-role",
    Severity.ERROR,
    "Too few robots for the roles of a team",
    "Before a run begins, each role takes as many robots of its kind as it wants at least, of those that run "
    "the team's program.",
)
AT_ONCE = rule(
    "run-at-once",
    Severity.HINT,
    "A program ends before time passes",
    "A part that gives a command takes no time: the command holds until another takes its place, and the program goes "
    "on. When the program ends, nothing takes back what devices were told; the simulation ends when all programs have. "
    "A part that takes time, put behind it, shows what the command does.",
)
SLOW = rule(
    "run-slow",
    Severity.HINT,
    "A long run would be much faster with Numba",
    "Numba compiles the steps of a simulation; the numbers stay the same. It is large, so it is only installed where "
    'it is wanted: `pip install "kitrobot[fast]"`.',
)
