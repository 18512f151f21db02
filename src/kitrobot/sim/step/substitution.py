"""What a team does about robots that fail, stall or lose their radio, in a step.

Such a robot is silent: until it is missed, a second later, meetings wait for it. What happens then, the groups say that
it is in, in this order: *abort*: the team cannot go on. *substitute*: the first spare robot of its kind that is well,
and stands at the same storehouse if that one stood at one, takes its role and groups over; its program, which waits in
its first line, is led to where the role was lost (`compiler.team.points`). *drop*, which also holds where no spare one
is left: the others go on without it.

A role that was to be taken over and was not is vacant (`vacancies`).

A branch of whose robots the last one is missed before they came to its end is done by nobody: the team cannot go on.

With a radio, who does not hear a majority of the team is silent too, and while nobody hears one, nobody is missed.
A robot that is missed plays no role any more. One that has only lost its radio knows that by itself, and begins its
program anew at once, as a spare one; any other does so when it is revived. Its devices are told to stop before.
"""

from __future__ import annotations

from kitrobot.sim.devices.base import Command
from kitrobot.sim.step.dispatch import start
from kitrobot.sim.step.failed_robots import count_breakdowns, end_breakdown, is_towed
from kitrobot.sim.step.program_ends import end_program
from kitrobot.sim.tables.columns import (
    A_DONE,
    A_QUEUED,
    A_QUEUED_LATER,
    A_TAKEN,
    ACTUATOR_INDEX,
    ASLEEP,
    BACK,
    DOWN,
    ENDED,
    MISSED,
    MUTED,
    NO_READING,
    PROGRAM,
    S_LAST,
    S_ROBOT,
    TAKEN_OVER,
    WELL,
    record_event,
)
from kitrobot.sim.tables.rows import copy_row
from kitrobot.sim.tables.state import State, Team
from kitrobot.sim.tables.team_columns import (
    ABORT,
    DROP,
    NO_UNIT,
    NOBODY,
    OVER_ABORT,
    OVER_NOBODY,
    SUBSTITUTE,
    T_ACTUATOR,
    T_ANCHOR,
    T_ANSWER,
    T_BRANCH,
    T_HOLDER,
    T_LED,
    T_LEFT,
    T_MISSED,
    T_PLACE,
    T_REPLAYED,
    T_ROLE,
    T_SEAT,
    T_SILENT,
    T_SINCE,
    T_TO_REPLAY,
    TEAM_FRESH,
    TEAM_LEASE,
    TEAM_OVER,
    TEAM_OVER_GROUP,
    TEAM_OVER_WHO,
    TEAM_PENDING,
)
from kitrobot.sim.team.meetings import agree, branch_around, find_members, give_up_branch, in_group, leave_point
from kitrobot.sim.team.radio import ANY_QUORUM, BEAT, QUORUM, find_quorum, has_radio
from kitrobot.sim.team.shared_variables import APART_VALUE, SHARED_VALUE
from kitrobot.sim.team.vacancies import fill_vacancies, fill_vacancy, occupy_place
from kitrobot.sim.team.work import count_unheard, end_leases, lose_units, share_out


def finish_team_step(state: State) -> None:
    """After the devices of a step: what is agreed at points, and whether spare robots are needed any more."""
    if state.team.numbers[TEAM_FRESH]:
        agree(state)
        fill_vacancies(state)
    if len(state.team.holds) > 0:
        share_out(state)
    end_spares(state)


def detect_silent_robots(step: int, state: State) -> None:
    """Before the programs of a step: who is silent, who is missed, who takes over, and who is back."""
    team = state.team
    robots = team.robots
    ints = state.robots.ints
    pending = 0
    by_radio = has_radio(state)
    if by_radio and step % state.radio.numbers[BEAT] == 0:
        find_quorum(state)
    can_agree = not by_radio or state.radio.numbers[ANY_QUORUM] != 0
    end_leases(step, state)
    for i in range(len(robots[T_SILENT])):
        if robots[T_ACTUATOR][i] < 0 or ints[ENDED][i]:
            continue
        hears = ints[MUTED][i] == 0 and (not by_radio or state.radio.robots[QUORUM][i] != 0)
        if ints[DOWN][i] == WELL and hears and not is_towed(i, state):
            if robots[T_SILENT][i] >= 0:
                handle_return(i, state)
            continue
        if robots[T_SILENT][i] < 0:
            robots[T_SILENT][i] = step
        if robots[T_ROLE][i] < 0 or not can_agree:
            continue
        if step - robots[T_SILENT][i] < team.numbers[TEAM_LEASE]:
            pending += 1
            continue
        declare_missing(i, state)
        if ints[DOWN][i] == WELL:
            restart_program(i, state)
    team.numbers[TEAM_PENDING] = pending


def handle_return(i: int, state: State) -> bool:
    """Robot i is silent no more; whether its program begins anew, because it was missed. A spare one takes a role that
    is vacant.
    """
    robots = state.team.robots
    robots[T_SILENT][i] = -1
    state.team.numbers[TEAM_FRESH] = 1
    was_missed = robots[T_MISSED][i] != 0
    count_unheard(i, state.team)
    if was_missed:
        robots[T_MISSED][i] = 0
        end_breakdown(i, state)
        record_event(state.events, state.clock, BACK, i, 0, 0)
        restart_program(i, state)
    fill_vacancy(i, state)
    return was_missed


def declare_missing(i: int, state: State) -> None:
    """Robot i is missed: its role is another's now, or nobody's, or the team cannot go on."""
    team = state.team
    robots = team.robots
    rule = DROP
    group = -1
    for g in range(len(team.failure)):
        if team.failure[g] > rule and in_group(i, g, team):
            rule = team.failure[g]
            group = g
    robots[T_MISSED][i] = 1
    count_breakdowns(state)
    leave_point(i, team)
    lose_units(i, state)
    record_event(state.events, state.clock, MISSED, i, 0, 0)
    if rule == ABORT:
        team.numbers[TEAM_OVER] = OVER_ABORT
        team.numbers[TEAM_OVER_WHO] = i
        team.numbers[TEAM_OVER_GROUP] = group
    spare = first_spare(i, state) if rule == SUBSTITUTE else -1
    if spare >= 0:
        take_over(spare, i, state)
    else:
        if rule == SUBSTITUTE:
            robots[T_LEFT][robots[T_SEAT][i]] = 1 + robots[T_ROLE][i]
        drop(i, team)
    robots[T_ROLE][i] = -1
    robots[T_SEAT][i] = i
    find_members(team)
    branch = robots[T_BRANCH][i]
    robots[T_BRANCH][i] = -1
    while branch >= 0:
        give_up_branch(branch, team)
        branch = branch_around(branch, team)


def first_spare(lost: int, state: State) -> int:
    """The first robot of the same kind and at the same place that has no role and is well; -1 where there is none, or
    none could be led.
    """
    robots = state.team.robots
    ints = state.robots.ints
    if robots[T_SINCE][lost] > len(state.team.since[lost]):
        return -1
    for i in range(len(robots[T_ROLE])):
        if (
            robots[T_ACTUATOR][i] >= 0
            and robots[T_ROLE][i] < 0
            and robots[T_SILENT][i] < 0
            and ints[ENDED][i] == 0
            and ints[PROGRAM][i] == ints[PROGRAM][lost]
            and robots[T_PLACE][i] == robots[T_PLACE][lost]
        ):
            return i
    return -1


def take_over(spare: int, lost: int, state: State) -> None:
    """A spare robot plays the role of one that is missed, in its groups; it is led to where that was."""
    team = state.team
    robots = team.robots
    for g in range(len(team.groups)):
        team.groups[g][spare] = team.groups[g][lost]
        team.groups[g][lost] = 0
    occupy_place(spare, robots[T_SEAT][lost], lost, state)
    record_event(state.events, state.clock, TAKEN_OVER, spare, lost, 0)


def drop(lost: int, team: Team) -> None:
    """The others go on without a robot; its sets keep that, as 2 + the point from which it last went on."""
    robots = team.robots
    seat = robots[T_SEAT][lost]
    robots[T_HOLDER][seat] = NOBODY
    for g in range(len(team.groups)):
        team.vacated[g][seat] = team.groups[g][lost] if robots[T_LEFT][seat] > 0 else 0
        team.groups[g][lost] = 0
    for chosen in range(len(team.members)):
        if team.members[chosen][lost]:
            team.emptied[chosen] = robots[T_ANCHOR][lost] + 2


def restart_program(i: int, state: State) -> None:
    """The program of robot i begins anew, and its devices are told to stop. What is shared stays as it is known."""
    team = state.team
    robots = team.robots
    ints = state.robots.ints
    p = ints[PROGRAM][i]
    cells = state.machines.cells[i]
    copy_row(cells, team.first_cells[p])
    copy_row(state.machines.threads[i], team.first_threads[p])
    copy_row(state.machines.pars[i], team.first_pars[p])
    shared = state.shared
    for k in range(shared.mine_first[i], shared.mine_first[i + 1]):
        if ints[MUTED][i] or has_radio(state):
            cells[shared.mine_cell[k]] = shared.apart[APART_VALUE][k]
        else:
            cells[shared.mine_cell[k]] = shared.ints[SHARED_VALUE][shared.mine[k]]
    ints[ASLEEP][i] = 0
    sensor = state.sensors.ints
    for k in range(len(sensor[S_ROBOT])):
        if sensor[S_ROBOT][k] == i:
            sensor[S_LAST][k] = NO_READING
    actuator = state.actuators.ints
    for n in range(state.machines.parts[p]):
        k = state.actuators.actuator_index[ints[ACTUATOR_INDEX][i] + n]
        actuator[A_TAKEN][k] = -1
        actuator[A_QUEUED][k] = 0
        actuator[A_QUEUED_LATER][k] = 0
        if team.halts[k] >= 0:
            start(k, Command(team.halts[k], 0, 0, 0, 0), 0.0, state)
    leave_point(i, team)
    for w in range(len(team.holds)):
        team.holds[w][i] = NO_UNIT
    actuator[A_DONE][robots[T_ACTUATOR][i]] = 1
    robots[T_ANSWER][i] = 0
    robots[T_LED][i] = -1
    robots[T_BRANCH][i] = -1
    robots[T_ANCHOR][i] = -1
    robots[T_SINCE][i] = 0
    robots[T_REPLAYED][i] = 0
    robots[T_TO_REPLAY][i] = 0


def end_spares(state: State) -> None:
    """Ends the programs of spare robots when nobody is left whose role they could take over.

    When nobody who had a role has come to the end of its program, the team cannot go on.
    """
    team = state.team
    robots = team.robots
    ended = state.robots.ints[ENDED]
    arrived = 0
    for i in range(len(ended)):
        if robots[T_ACTUATOR][i] >= 0 and robots[T_ROLE][i] >= 0:
            if ended[i] == 0:
                return
            arrived += 1
    if arrived == 0:
        if team.numbers[TEAM_OVER] == 0:
            team.numbers[TEAM_OVER] = OVER_NOBODY
        return
    for i in range(len(ended)):
        if robots[T_ACTUATOR][i] >= 0 and ended[i] == 0 and robots[T_SILENT][i] < 0:
            end_program(i, state)
