"""The columns of the tables of a team: its points, its robots, and numbers of the whole (see state.Team, meetings)."""

from __future__ import annotations

# ---- what holds for the team as a whole: state.team.numbers

(
    TEAM_FRESH,  # 1: somebody came to a point, or who is in which set has changed, since all points were looked at
    TEAM_LEASE,  # steps after which a robot that is silent is missed
    TEAM_PENDING,  # robots with a role that are silent and not yet missed
    TEAM_OVER,  # why the team cannot go on: OVER_ABORT, OVER_BLOCK or OVER_NOBODY; 0 while it can
    TEAM_OVER_WHO,  # the robot that was missed, or the block or branch that nobody is left of
    TEAM_OVER_GROUP,  # the group that ends with it
    TEAM_LEASED,  # units that will be free again for robots that wait for one
    TEAM_DUE,  # points at which all are there, and whose messages are on their way
) = range(8)
TEAM_NUMBERS = 8

OVER_ABORT, OVER_BLOCK, OVER_NOBODY = range(1, 4)

# ---- points, as the plan of the program numbers them: state.team.points

(
    P_KIND,
    P_MEMBERS,  # the set that comes there
    P_VOTERS,  # the set whose answers count
    P_QUANTIFIER,
    P_NEGATED,
    P_TIMES,
    P_SOURCE,  # the group that robots leave
    P_TARGET,  # the group that they go over to
    P_PASSES,  # of a count: how many passes there were
    P_WAITING,  # how many robots wait there
    P_FIRST,  # the points to which a yes leads: the first
    P_LAST,  # and the last
    P_BLOCK,  # of the meeting behind a block, its point; -1 elsewhere
    P_DUE,  # 1 + the step in which all who are there know so; 0 while somebody is missing
    P_JOINS,  # of a branch, the meeting of all branches behind it; -1 elsewhere
    P_ENDED,  # of a branch, 1: its robots have come to its end in this pass
) = range(16)
POINT_ROWS = 16

BLOCK, BRANCH, MEET, ASK, COUNT, MOVE = range(6)
"""Kinds of points, in the order of `PointKind`."""

ONE, ANY, EVERY, MOST = range(4)
"""How answers are combined."""

# ---- robots of the run: state.team.robots

(
    T_ACTUATOR,  # the number of its actuator `Team`, or -1 where it is not of the team
    T_ROLE,  # the role that it plays, or -1 while it is spare
    T_SEAT,  # the original holder of its place: itself, unless it took a role over
    T_HOLDER,  # who stands in its place now; NO_PLACE while it has none, NOBODY when whoever had it was missed
    T_AT,  # the point at which it waits, or -1
    T_GIVEN,  # what it answered there
    T_ANSWER,  # what the team answered it last
    T_SILENT,  # the step since which it has failed, stalled or lost its radio, or -1
    T_MISSED,  # 1: the team goes on without it; it begins anew when it is back
    T_ANCHOR,  # where a substitute is led: the point that it last went on from, or the outermost block that it is in
    T_ANCHORED,  # the step in which that was
    T_ANCHOR_ANSWER,  # what was answered there
    T_SINCE,  # how many points it has gone on from since, in that block or past others: the first ones of `since`
    T_LED,  # the point to which it is led, or -1
    T_REPLAYED,  # how many answers of `since` it has received again
    T_TO_REPLAY,  # how many it is to receive
    T_PLACE,  # where it stands for good: at one of the storehouses, or -1 where it can be anywhere
    T_LEFT,  # 1 + the role that is vacant in its place: whoever had it was missed, and no spare robot was left; or 0
    T_BRANCH,  # the innermost branch that it is in and has not come to the end of, or -1
) = range(19)
TEAM_ROWS = 19

NO_PLACE, NOBODY = -1, -2
"""T_HOLDER of a place without a robot."""

MOST_SINCE = 256
"""Points that a robot may go on from in one block and be substituted."""

DROP, SUBSTITUTE, ABORT = range(3)
"""What a group does about a member that is missed, in the order of `FAILURES`."""

KEPT_ROWS = 3
"""Of what is kept to compare with: T_AT, T_GIVEN and T_ANSWER."""

# ---- works: state.team.works; who has a unit: state.team.holds and state.team.until, by work, then by robot

(
    W_LEFT,  # units that are not done
    W_TAKEN,  # of these, units that somebody has
    W_LEASE,  # steps after which a unit is free again, 0 for never
    W_WAITING,  # robots that wait for one
) = range(4)
WORK_ROWS = 4

NO_UNIT, HAS_UNIT, LOST_UNIT, UNHEARD_UNIT = range(4)
"""Whether a robot holds a unit of a job, lost it before it was done, or reported it done while it was silent. A robot
holds at most one unit of a job."""

# ---- names of sets: state.team.names

N_WHAT, N_WHICH = range(2)
NAME_ROWS = 2

ROLE, GROUP, AGENT = range(3)
"""What a name in a set is; WHICH is the number of the role, the group or the robot."""
