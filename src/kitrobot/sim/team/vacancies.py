"""Places of a team in a step: who stands in one, and who takes one whose role is vacant.

Every robot that had a role at first has a place, which keeps its number: whoever stands there is who is meant by that
robot's name. A role that was to be taken over and was not is vacant. As long as somebody else plays it, the next robot
of its kind, and for its place, that is back plays it too, in the groups of that place, and is led to where that one is.
It goes only where its place goes: while the other one is in a block or a branch whose set does not hold the place, or
has passed one by whose set does, it waits until both have gone the same way again.
"""

from __future__ import annotations

from kitrobot.sim.tables.columns import A_DONE, ENDED, PROGRAM, TAKEN_OVER, record_event
from kitrobot.sim.tables.rows import copy_row
from kitrobot.sim.tables.state import State, Team
from kitrobot.sim.tables.team_columns import (
    AGENT,
    BLOCK,
    BRANCH,
    N_WHAT,
    N_WHICH,
    P_FIRST,
    P_KIND,
    P_LAST,
    P_MEMBERS,
    ROLE,
    T_ACTUATOR,
    T_ANCHOR,
    T_ANCHOR_ANSWER,
    T_ANCHORED,
    T_BRANCH,
    T_HOLDER,
    T_LED,
    T_LEFT,
    T_PLACE,
    T_REPLAYED,
    T_ROLE,
    T_SEAT,
    T_SILENT,
    T_SINCE,
    T_TO_REPLAY,
)
from kitrobot.sim.team.meetings import find_members


def occupy_place(i: int, seat: int, like: int, state: State) -> None:
    """Robot i, which begins its program, stands in a place, with the role of another robot; it is led to where that one
    was last.
    """
    team = state.team
    robots = team.robots
    robots[T_HOLDER][seat] = i
    robots[T_SEAT][i] = seat
    robots[T_ROLE][i] = robots[T_ROLE][like]
    robots[T_BRANCH][i] = robots[T_BRANCH][like]
    robots[T_ANCHOR][i] = robots[T_ANCHOR][like]
    robots[T_ANCHORED][i] = robots[T_ANCHORED][like]
    robots[T_ANCHOR_ANSWER][i] = robots[T_ANCHOR_ANSWER][like]
    robots[T_SINCE][i] = robots[T_SINCE][like]
    copy_row(team.since[i], team.since[like])
    robots[T_LED][i] = robots[T_ANCHOR][like]
    robots[T_REPLAYED][i] = 0
    robots[T_TO_REPLAY][i] = robots[T_SINCE][like]
    state.actuators.ints[A_DONE][robots[T_ACTUATOR][i]] = 1


def is_place_in(seat: int, chosen: int, team: Team) -> bool:
    """Whether who took the vacant role of a place would be in a set."""
    if chosen == 0:
        return True
    for n in range(team.set_first[chosen], team.set_first[chosen + 1]):
        what = team.names[N_WHAT][n]
        which = team.names[N_WHICH][n]
        if what == ROLE:
            if team.robots[T_LEFT][seat] == 1 + which:
                return True
        elif what == AGENT:
            if which == seat:
                return True
        else:
            inner = team.within[which]
            for g in range(len(inner)):
                if inner[g] and team.vacated[g][seat]:
                    return True
    return False


def fill_vacancies(state: State) -> None:
    """Spare robots play roles that are vacant, as soon as they can be led to where others who play them are."""
    left = state.team.robots[T_LEFT]
    k = 0
    while k < len(left) and left[k] == 0:
        k += 1
    if k < len(left):
        for i in range(len(left)):
            if state.team.robots[T_SILENT][i] < 0:
                fill_vacancy(i, state)


def fill_vacancy(i: int, state: State) -> None:
    """A spare robot plays a role that is vacant for its kind and place, the first one that somebody else plays who is
    where its place would be too; that of its own place before others.
    """
    team = state.team
    robots = team.robots
    programs = state.robots.ints[PROGRAM]
    if robots[T_ACTUATOR][i] < 0 or robots[T_ROLE][i] >= 0 or state.robots.ints[ENDED][i]:
        return
    seat = -1
    beside = -1
    for k in range(len(robots[T_LEFT])):
        left = robots[T_LEFT][k]
        if (
            left > 0
            and (seat < 0 or left < robots[T_LEFT][seat] or (left == robots[T_LEFT][seat] and k == i))
            and programs[k] == programs[i]
            and robots[T_PLACE][k] == robots[T_PLACE][i]
        ):
            player = find_player(k, state)
            if player >= 0:
                seat = k
                beside = player
    if seat < 0:
        return
    robots[T_LEFT][seat] = 0
    for g in range(len(team.groups)):
        team.groups[g][i] = team.vacated[g][seat]
        team.vacated[g][seat] = 0
    occupy_place(i, seat, beside, state)
    find_members(team)
    record_event(state.events, state.clock, TAKEN_OVER, i, seat, 1 if seat == i else 0)


def find_player(seat: int, state: State) -> int:
    """The first robot that plays the vacant role of a place, is well, and is where that place would be too; or -1."""
    robots = state.team.robots
    ended = state.robots.ints[ENDED]
    for i in range(len(robots[T_ROLE])):
        if (
            1 + robots[T_ROLE][i] == robots[T_LEFT][seat]
            and robots[T_SILENT][i] < 0
            and ended[i] == 0
            and goes_along(seat, i, state.team)
        ):
            return i
    return -1


def goes_along(seat: int, i: int, team: Team) -> bool:
    """Whether a vacant place is in all blocks and branches in which robot i is, and in none that this one has passed by
    since the point to which another one would be led; and nobody is further in one of them than it is.
    """
    robots = team.robots
    points = team.points
    anchor = robots[T_ANCHOR][i]
    past = robots[T_SINCE][i]
    if past > len(team.since[i]):
        return False
    for p in range(anchor + 1):
        around = p == anchor or points[P_FIRST][p] <= anchor <= points[P_LAST][p]
        if around and is_set(p, team) and not is_place_in(seat, points[P_MEMBERS][p], team):
            return False
    for n in range(past):
        p = team.since[i][n] // 2
        if is_set(p, team) and is_place_in(seat, points[P_MEMBERS][p], team) != (team.since[i][n] % 2 != 0):
            return False
    for k in range(len(robots[T_ROLE])):
        if robots[T_ROLE][k] < 0 or robots[T_SILENT][k] >= 0 or k == i:
            continue
        if robots[T_ANCHOR][k] == anchor:
            if count_entered(k, i, seat, team) > count_entered(i, k, seat, team):
                return False
        elif is_inside(k, team) and count_entered(k, i, seat, team) > 0:
            return False
    return True


def is_set(p: int, team: Team) -> bool:
    """Whether a point is that of a block or a branch."""
    return team.points[P_KIND][p] == BLOCK or team.points[P_KIND][p] == BRANCH


def is_inside(i: int, team: Team) -> bool:
    """Whether robot i is still in the block to which another one would be led."""
    anchor = team.robots[T_ANCHOR][i]
    past = min(team.robots[T_SINCE][i], len(team.since[i]))
    if anchor < 0 or team.points[P_KIND][anchor] != BLOCK:
        return False
    return past == 0 or team.points[P_FIRST][anchor] <= team.since[i][past - 1] // 2 <= team.points[P_LAST][anchor]


def count_entered(i: int, other: int, seat: int, team: Team) -> int:
    """How many blocks and branches robot i has gone into, since the point to which another one would be led, that
    another robot and a vacant place are in too.
    """
    anchor = team.robots[T_ANCHOR][i]
    count = 0
    if anchor >= 0 and is_set(anchor, team) and is_common(anchor, other, seat, team):
        count += 1
    for n in range(min(team.robots[T_SINCE][i], len(team.since[i]))):
        p = team.since[i][n] // 2
        if team.since[i][n] % 2 != 0 and is_set(p, team) and is_common(p, other, seat, team):
            count += 1
    return count


def is_common(p: int, i: int, seat: int, team: Team) -> bool:
    """Whether robot i and a vacant place are both in the set that comes to a point."""
    chosen = team.points[P_MEMBERS][p]
    return team.members[chosen][i] != 0 and is_place_in(seat, chosen, team)
