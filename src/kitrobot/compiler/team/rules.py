"""The rules of a team's programs: what can be wrong with who does what."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

UNKNOWN_MEMBER = rule(
    "team-unknown-member",
    Severity.ERROR,
    "A set names nobody of the team",
    "A set names roles and groups that the team declares, and agents of the mission.",
)
UNKNOWN_PROGRAM = rule(
    "team-unknown-program",
    Severity.ERROR,
    "PROGRAM names no program that can stand there",
    "`PROGRAM` is followed by the name of a program of the mission: one of a robot, or one of a team whose level is "
    "not wider than that of the program around it.",
)
PROGRAM_KIND = rule(
    "team-program-kind",
    Severity.ERROR,
    "A program is for another kind of robot than those that are to do it",
    "The program of a robot knows the parts of one kind of robot. In a block, every role and agent of its set is of "
    "that kind.",
)
PROGRAM_CIRCLE = rule(
    "team-program-circle",
    Severity.ERROR,
    "Programs stand in each other's place in a circle",
    "`PROGRAM` puts another program in its place. A program in its own place would never end.",
)
BARE_TEST = rule(
    "team-bare-test",
    Severity.ERROR,
    "The robots of a team could answer a test differently",
    "All members go the same way round blocks, so the condition there has one answer for all: it asks with `any`, "
    "`all` or `most`, or looks at shared variables and work only. `Where` is for members that go different ways.",
)
UNPLAYED = rule(
    "team-role-unplayed",
    Severity.ERROR,
    "Nobody can play a role",
    "A role names a kind of robot that is at hand, and the team has as many agents of that kind as are wanted at "
    "least.",
)
GROUP_EMPTY = rule(
    "team-group-empty",
    Severity.WARNING,
    "A group can be left without members",
    "A block whose members have all moved away is passed over. Where the last of them failed, the run ends at that "
    "block and has failed. A `MOVE` takes robots out of a group and out of every group in it, and so out of the groups "
    "around it too, if it does not bring them into one of these.",
)
GROUP_CIRCLE = rule(
    "team-group-circle",
    Severity.ERROR,
    "A group holds itself",
    "A group holds roles, agents and other groups; none of them leads back to it.",
)
SAME_NAME = rule(
    "team-same-name",
    Severity.ERROR,
    "Two declarations of a team have one name",
    "Roles, groups and works are known by their names, so each name is declared once. A role or a group may have the "
    "name of an agent; then the name stands for the role or the group.",
)
NOT_WITHIN = rule(
    "team-not-within",
    Severity.ERROR,
    "Somebody is named who never comes there",
    "Inside a block only its own members are there, so a block or a question in it is for them, or for some of them. "
    "On a side of `Where` stand those for whom its test is so; who that is shows only while it runs, so no block can "
    "stand there.",
)
TWO_PLACES = rule(
    "team-two-places",
    Severity.ERROR,
    "A member would be at two meetings at the same time",
    "The branches of a `//` run side by side. A member that stands in blocks of two of them could be waited for in one "
    "while it waits in the other.",
)
NO_BLOCK = rule(
    "team-no-block",
    Severity.ERROR,
    "Nobody knows which robots do a line",
    "What robots do stands in a block that says which of them do it: SeqOfPar, ParOfSeq or Where. Outside of blocks "
    "stand WAIT and what all go through together: loops, choices, events, parallels with a block in each branch.",
)
ONE_LEAVES = rule(
    "team-break",
    Severity.ERROR,
    "BREAK would take one robot out of what the team does together",
    "A loop around blocks, and one of a SeqOfPar, is gone through by all together, and so is the team's program. What "
    "a robot does on its own, in a ParOfSeq or Where or behind a test of its own, can leave loops of its own only.",
)
DONE_TWICE = rule(
    "team-done-twice",
    Severity.WARNING,
    "A substitute would do an effect a second time",
    "Where a group says `on failure substitute`, the substitute begins the outermost block in which the role was lost "
    "from its start, with shared variables and boxes as they stand. A line that adds to a shared variable, takes away "
    "from it, turns it round, or moves a box, is then done twice. Do it between `Take()` and `Done()` of a work, or "
    "let a `ParOfSeq` ask first whether it is done, as in `[Counted.IsFalse()](Total.Add(1); Counted.Set(1);)`.",
)
