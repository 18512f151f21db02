"""The works of a team in a step: who takes a unit, who has one done, and which are free again.

Units are alike, so they are counted: `works` says how many are left and how many of these somebody has, `holds` which
robots have one. A unit whose holder is missed, or whose lease is over, is free again; that holder cannot say any more
that it is done. Nobody hears a robot that is silent: it is given no unit, and that its unit is done counts when it is
back before it is missed. A robot that waits for a unit waits in vain while all who have one wait for others at points
of the team, so then it goes on without.
"""

from __future__ import annotations

from kitrobot.sim.tables.columns import A_DONE, TICK, UNIT_LOST, record_event
from kitrobot.sim.tables.state import State, Team
from kitrobot.sim.tables.team_columns import (
    HAS_UNIT,
    LOST_UNIT,
    NO_UNIT,
    T_AT,
    T_SILENT,
    TEAM_LEASED,
    UNHEARD_UNIT,
    W_LEASE,
    W_LEFT,
    W_TAKEN,
    W_WAITING,
)


def take_unit(i: int, w: int, k: int, state: State) -> None:
    """Robot i wants a unit of work w, by its actuator k; it goes on when it has one, or when none is left."""
    team = state.team
    state.actuators.ints[A_DONE][k] = 1
    is_heard = team.robots[T_SILENT][i] < 0
    if team.holds[w][i] == HAS_UNIT or (is_heard and team.works[W_LEFT][w] == 0):
        return
    if is_heard and team.works[W_TAKEN][w] < team.works[W_LEFT][w]:
        give_unit(i, w, state)
        return
    state.actuators.ints[A_DONE][k] = 0
    team.waits[w][i] = k
    team.works[W_WAITING][w] += 1


def give_unit(i: int, w: int, state: State) -> None:
    """Robot i has a unit of work w from now on."""
    team = state.team
    team.holds[w][i] = HAS_UNIT
    team.works[W_TAKEN][w] += 1
    team.until[w][i] = state.clock[TICK] + team.works[W_LEASE][w]


def finish_unit(i: int, w: int, state: State) -> None:
    """Robot i says that its unit of work w is done; whose unit was free again meanwhile is told."""
    team = state.team
    if team.robots[T_SILENT][i] >= 0:
        if team.holds[w][i] == HAS_UNIT:
            team.holds[w][i] = UNHEARD_UNIT
        return
    if team.holds[w][i] == HAS_UNIT:
        team.works[W_TAKEN][w] -= 1
        team.works[W_LEFT][w] -= 1
    elif team.holds[w][i] == LOST_UNIT:
        record_event(state.events, state.clock, UNIT_LOST, i, w, 0)
    team.holds[w][i] = NO_UNIT


def is_taken(hold: int) -> bool:
    """Whether a robot has a unit of a work, done or not."""
    return hold in (HAS_UNIT, UNHEARD_UNIT)


def count_unheard(i: int, team: Team) -> None:
    """Robot i, which was silent and not missed, is heard again: units of which it said that they are done are done."""
    for w in range(len(team.holds)):
        if team.holds[w][i] == UNHEARD_UNIT:
            team.works[W_TAKEN][w] -= 1
            team.works[W_LEFT][w] -= 1
            team.holds[w][i] = NO_UNIT


def lose_units(i: int, state: State) -> None:
    """All units of robot i are free again, and it waits for none."""
    team = state.team
    for w in range(len(team.holds)):
        if is_taken(team.holds[w][i]):
            lose_unit(i, w, state)
        if team.waits[w][i] >= 0:
            team.waits[w][i] = -1
            team.works[W_WAITING][w] -= 1


def lose_unit(i: int, w: int, state: State) -> None:
    """The unit of robot i is free again; where it said that it was done, and nobody heard it, that is told."""
    team = state.team
    if team.holds[w][i] == UNHEARD_UNIT:
        record_event(state.events, state.clock, UNIT_LOST, i, w, 0)
    team.works[W_TAKEN][w] -= 1
    team.holds[w][i] = LOST_UNIT


def end_leases(step: int, state: State) -> None:
    """Units whose lease is over are free again."""
    team = state.team
    for w in range(len(team.holds)):
        if team.works[W_LEASE][w] > 0 and team.works[W_TAKEN][w] > 0:
            holds = team.holds[w]
            for i in range(len(holds)):
                if is_taken(holds[i]) and step >= team.until[w][i]:
                    lose_unit(i, w, state)


def share_out(state: State) -> None:
    """Robots that wait for a unit have one, in team order, as far as there are free ones."""
    team = state.team
    leased = 0
    for w in range(len(team.holds)):
        if team.works[W_WAITING][w] == 0:
            continue
        for i in range(len(team.waits[w])):
            if team.works[W_TAKEN][w] < team.works[W_LEFT][w] and is_waiting(i, w, team):
                give_unit(i, w, state)
                wait_no_more(i, w, state)
        # Only now: who has been given one may be who the others wait for.
        if team.works[W_WAITING][w] > 0 and (team.works[W_LEFT][w] == 0 or is_in_vain(w, team)):
            for i in range(len(team.waits[w])):
                if is_waiting(i, w, team):
                    wait_no_more(i, w, state)
        if team.works[W_WAITING][w] > 0 and team.works[W_LEASE][w] > 0:
            leased += team.works[W_TAKEN][w]
    team.numbers[TEAM_LEASED] = leased


def is_waiting(i: int, w: int, team: Team) -> bool:
    """Whether robot i waits for a unit of work w and is not silent."""
    return team.waits[w][i] >= 0 and team.robots[T_SILENT][i] < 0


def wait_no_more(i: int, w: int, state: State) -> None:
    """Robot i, which waits for a unit of work w, goes on."""
    team = state.team
    state.actuators.ints[A_DONE][team.waits[w][i]] = 1
    team.waits[w][i] = -1
    team.works[W_WAITING][w] -= 1


def is_in_vain(w: int, team: Team) -> bool:
    """Whether all who have a unit of work w wait for others at points of the team."""
    holds = team.holds[w]
    at = team.robots[T_AT]
    i = 0
    while i < len(holds) and (not is_taken(holds[i]) or at[i] >= 0):
        i += 1
    return i == len(holds)
