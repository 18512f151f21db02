"""What the robots of a team agree on in a step: who is in which set, and who goes on from which point.

The meaning of points is in `compiler.team.points`. A robot comes to a point by a command of its program to the device
`team`, and waits until all who come there are there; then all of them go on with the same answer. Points are looked at
in their order, once in a step in which somebody came or a set has changed.

A branch whose robots were all missed before they came to its end is done by nobody, so the team cannot go on.

Of the tables (`state.team`): set s holds the names from `set_first[s]` on; set 0 is the whole team. `members` says of
each set who is in it, and is worked out anew when a role or a group changes. `groups` says who is in a group itself,
`within` which groups are in which, each in itself too;
`vacated` which groups belong to a place whose role is vacant.
"""

from __future__ import annotations

from kitrobot.sim.tables.columns import A_DONE, MOVED_OVER, TICK, record_event
from kitrobot.sim.tables.rows import copy_row, same
from kitrobot.sim.tables.state import State, Team
from kitrobot.sim.tables.team_columns import (
    AGENT,
    ANY,
    ASK,
    BLOCK,
    BRANCH,
    COUNT,
    EVERY,
    MEET,
    MOST,
    MOVE,
    N_WHAT,
    N_WHICH,
    NO_PLACE,
    OVER_BLOCK,
    P_BLOCK,
    P_DUE,
    P_ENDED,
    P_FIRST,
    P_JOINS,
    P_KIND,
    P_LAST,
    P_MEMBERS,
    P_NEGATED,
    P_PASSES,
    P_QUANTIFIER,
    P_SOURCE,
    P_TARGET,
    P_TIMES,
    P_VOTERS,
    P_WAITING,
    ROLE,
    T_ACTUATOR,
    T_ANCHOR,
    T_ANCHOR_ANSWER,
    T_ANCHORED,
    T_ANSWER,
    T_AT,
    T_BRANCH,
    T_GIVEN,
    T_HOLDER,
    T_LED,
    T_REPLAYED,
    T_ROLE,
    T_SILENT,
    T_SINCE,
    T_TO_REPLAY,
    TEAM_DUE,
    TEAM_FRESH,
    TEAM_OVER,
    TEAM_OVER_WHO,
)
from kitrobot.sim.team.radio import has_radio, latency


def in_group(i: int, group: int, team: Team) -> bool:
    """Whether robot i is in a group, or in one of those in it."""
    inner = team.within[group]
    g = 0
    while g < len(inner) and not (inner[g] and team.groups[g][i]):
        g += 1
    return g < len(inner)


def is_member(i: int, chosen: int, team: Team) -> bool:
    """Whether robot i is in a set, by the roles and groups as they are."""
    if team.robots[T_ROLE][i] < 0:
        return False
    if chosen == 0:
        return True
    for n in range(team.set_first[chosen], team.set_first[chosen + 1]):
        what = team.names[N_WHAT][n]
        which = team.names[N_WHICH][n]
        if what == ROLE:
            if team.robots[T_ROLE][i] == which:
                return True
        elif what == AGENT:
            holder = team.robots[T_HOLDER][which]
            if holder == i or (holder == NO_PLACE and which == i):
                return True
        elif in_group(i, which, team):
            return True
    return False


def find_members(team: Team) -> None:
    """Works out who is in which set."""
    count = len(team.robots[T_ROLE])
    for chosen in range(len(team.members)):
        row = team.members[chosen]
        for i in range(count):
            row[i] = 1 if is_member(i, chosen, team) else 0
    team.numbers[TEAM_FRESH] = 1


def arrive(i: int, p: int, given: int, state: State) -> None:
    """Robot i comes to point p with an answer; it goes on at once where nobody waits for anybody.

    A substitute that is led, or told again what was agreed, goes on at once with the answer that leads it.
    """
    team = state.team
    robots = team.robots
    led = robots[T_LED][i]
    if led >= 0:
        answer = 1 if team.points[P_FIRST][p] <= led <= team.points[P_LAST][p] else 0
        if p == led:
            robots[T_LED][i] = -1
            answer = robots[T_ANCHOR_ANSWER][i]
        deliver_answer(i, answer, state)
    elif robots[T_REPLAYED][i] < robots[T_TO_REPLAY][i]:
        answer = team.since[i][robots[T_REPLAYED][i]] % 2
        robots[T_REPLAYED][i] += 1
        deliver_answer(i, answer, state)
    elif team.points[P_KIND][p] <= BRANCH:
        release(i, p, team.members[team.points[P_MEMBERS][p]][i], state)
    else:
        branch = robots[T_BRANCH][i]
        if branch >= 0 and team.points[P_JOINS][branch] == p:
            team.points[P_ENDED][branch] = 1
            robots[T_BRANCH][i] = branch_around(branch, team)
        robots[T_AT][i] = p
        robots[T_GIVEN][i] = given
        team.points[P_WAITING][p] += 1
        team.numbers[TEAM_FRESH] = 1


def deliver_answer(i: int, answer: int, state: State) -> None:
    """Robot i is told an answer, and goes on."""
    robots = state.team.robots
    robots[T_ANSWER][i] = answer
    state.actuators.ints[A_DONE][robots[T_ACTUATOR][i]] = 1


def leave_point(i: int, team: Team) -> None:
    """Robot i waits at no point any more."""
    at = team.robots[T_AT]
    if at[i] >= 0:
        team.points[P_WAITING][at[i]] -= 1
        at[i] = -1


def release(i: int, p: int, answer: int, state: State) -> None:
    """Robot i goes on from point p; what a substitute would need to come there is kept."""
    team = state.team
    robots = team.robots
    leave_point(i, team)
    deliver_answer(i, answer, state)
    kind = team.points[P_KIND][p]
    if kind == BRANCH:
        if answer:
            robots[T_BRANCH][i] = p
        give_up_branches(team.points[P_JOINS][p], team)
    anchor = robots[T_ANCHOR][i]
    inside = anchor >= 0 and team.points[P_KIND][anchor] == BLOCK
    inside = inside and team.points[P_FIRST][anchor] <= p <= team.points[P_LAST][anchor]
    if inside or kind == BRANCH or (kind == BLOCK and answer == 0):
        since = robots[T_SINCE][i]
        if since < len(team.since[i]):
            team.since[i][since] = 2 * p + answer
        robots[T_SINCE][i] = since + 1
        return
    robots[T_ANCHOR][i] = p
    robots[T_ANCHORED][i] = state.clock[TICK]
    robots[T_ANCHOR_ANSWER][i] = answer
    robots[T_SINCE][i] = 0


def branch_around(branch: int, team: Team) -> int:
    """The innermost branch in which another one is; -1 for none."""
    points = team.points
    p = branch - 1
    while p >= 0 and (points[P_KIND][p] != BRANCH or branch > points[P_LAST][p]):
        p -= 1
    return p


def give_up_branch(branch: int, team: Team) -> None:
    """The team cannot go on if nobody is left of a branch, and nobody has come to its end."""
    is_lost = team.points[P_ENDED][branch] == 0 and is_left_empty(team.points[P_MEMBERS][branch], team)
    if is_lost and team.numbers[TEAM_OVER] == 0:
        team.numbers[TEAM_OVER] = OVER_BLOCK
        team.numbers[TEAM_OVER_WHO] = branch


def give_up_branches(joins: int, team: Team) -> None:
    """The team has come to branches, or to the meeting behind them: nobody may be left of one."""
    for p in range(len(team.points[P_KIND])):
        if team.points[P_KIND][p] == BRANCH and team.points[P_JOINS][p] == joins:
            give_up_branch(p, team)


def agree(state: State) -> None:
    """Lets all go on from the points at which all who come there are there."""
    team = state.team
    team.numbers[TEAM_FRESH] = 0
    team.numbers[TEAM_DUE] = 0
    waiting = team.points[P_WAITING]
    by_radio = has_radio(state)
    for p in range(len(waiting)):
        if waiting[p] == 0:
            continue
        if not are_all_present(p, team):
            team.points[P_DUE][p] = 0
        elif not by_radio or is_known(p, state):
            decide(p, state)


def is_known(p: int, state: State) -> bool:
    """Whether all who are at point p know by now, over the radio, that they are."""
    team = state.team
    due = team.points[P_DUE]
    tick = state.clock[TICK]
    if due[p] == 0:
        due[p] = 1 + tick + latency(p, state)
    if tick + 1 >= due[p]:
        due[p] = 0
        return True
    team.numbers[TEAM_DUE] += 1
    team.numbers[TEAM_FRESH] = 1
    return False


def are_all_present(p: int, team: Team) -> bool:
    """Whether all who come to a point are there, and somebody is."""
    members = team.members[team.points[P_MEMBERS][p]]
    at = team.robots[T_AT]
    found = 0
    for i in range(len(members)):
        if members[i]:
            if at[i] != p or team.robots[T_SILENT][i] >= 0:
                return False
            found += 1
    return found > 0


def decide(p: int, state: State) -> None:
    """What is agreed at point p, where all are there; then they go on."""
    team = state.team
    kind = team.points[P_KIND][p]
    members = team.members[team.points[P_MEMBERS][p]]
    result = 0
    if kind == ASK:
        result = combine_answers(p, members, team)
    elif kind == COUNT:
        passes = team.points[P_PASSES][p] if first_answer(members, team) else 0
        result = 1 if passes < team.points[P_TIMES][p] else 0
        team.points[P_PASSES][p] = passes + 1
    at = team.robots[T_AT]
    for i in range(len(members)):
        if members[i] and at[i] == p:
            release(i, p, result, state)
    if kind == MOVE:
        move(p, state)
    block = team.points[P_BLOCK][p]
    if block >= 0 and is_left_empty(team.points[P_MEMBERS][block], team):
        team.numbers[TEAM_OVER] = OVER_BLOCK
        team.numbers[TEAM_OVER_WHO] = block
    if kind == MEET:
        give_up_branches(p, team)
        for branch in range(len(team.points[P_KIND])):
            if team.points[P_KIND][branch] == BRANCH and team.points[P_JOINS][branch] == p:
                team.points[P_ENDED][branch] = 0


def is_left_empty(chosen: int, team: Team) -> bool:
    """Whether nobody is in a set, because those who were in it are missed."""
    members = team.members[chosen]
    i = 0
    while i < len(members) and members[i] == 0:
        i += 1
    return team.emptied[chosen] != 0 and i == len(members)


def first_answer(members: list[int], team: Team) -> int:
    """The answer of the first member."""
    holders = team.robots[T_HOLDER]
    for seat in range(len(holders)):
        i = holders[seat]
        if i >= 0 and members[i]:
            return team.robots[T_GIVEN][i]
    return 0


def combine_answers(p: int, members: list[int], team: Team) -> int:
    """The answers of those who are asked, as one."""
    asked = team.members[team.points[P_VOTERS][p]]
    given = team.robots[T_GIVEN]
    holders = team.robots[T_HOLDER]
    quantifier = team.points[P_QUANTIFIER][p]
    yes = 0
    count = 0
    first = 0
    for seat in range(len(holders)):
        i = holders[seat]
        if i >= 0 and members[i] and asked[i]:
            one = 1 if given[i] else 0
            if count == 0:
                first = one
            count += 1
            yes += one
    if quantifier == ANY:
        result = 1 if yes > 0 else 0
    elif quantifier == EVERY:
        result = 1 if yes == count else 0
    elif quantifier == MOST:
        result = 1 if 2 * yes > count else 0
    else:
        result = first
    return 1 - result if team.points[P_NEGATED][p] else result


def move(p: int, state: State) -> None:
    """Lets robots go over from one group to another, in team order."""
    team = state.team
    source = team.points[P_SOURCE][p]
    target = team.points[P_TARGET][p]
    left = team.points[P_TIMES][p]
    holders = team.robots[T_HOLDER]
    inner = team.within[source]
    for seat in range(len(holders)):
        i = holders[seat]
        if left > 0 and i >= 0 and in_group(i, source, team):
            left -= 1
            for g in range(len(inner)):
                if inner[g]:
                    team.groups[g][i] = 0
            team.groups[target][i] = 1
            record_event(state.events, state.clock, MOVED_OVER, i, target, 0)
    find_members(team)


def save_team(team: Team) -> None:
    """Keeps how the team stands, to compare with (deadlock_detection)."""
    copy_row(team.kept[0], team.robots[T_AT])
    copy_row(team.kept[1], team.robots[T_GIVEN])
    copy_row(team.kept[2], team.robots[T_ANSWER])
    copy_row(team.kept_passes, team.points[P_PASSES])


def is_team_unchanged(team: Team) -> bool:
    """Whether the team stands as it was kept: what robots answer and are answered, and how often they went round."""
    if not (same(team.kept[0], team.robots[T_AT]) and same(team.kept[1], team.robots[T_GIVEN])):
        return False
    return same(team.kept[2], team.robots[T_ANSWER]) and same(team.kept_passes, team.points[P_PASSES])
