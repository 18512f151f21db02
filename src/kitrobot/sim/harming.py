"""What befalls robots in a step: they fail, stall, lose their radio and are well again, on schedule and by chance.

*Failed*: it stops reacting for good. Its wheels brake as at `Stop()`, its other devices stand as they are, and it stays
where it is, in everybody's way. *Stalled*: its program misses its ticks; the devices go on as they were told last.
*Muted*: it has lost its radio, as a failed one has: shared variables neither come nor go (sharing). *Revived*: all of
that is over; program and devices go on where they were.

The schedule is rows of `plan`: step, robot and kind, in order of steps. By chance a robot fails with the same
probability in every second of its own; the draws are counted by the step, so they need no state. From outside, between
two steps, `Simulation.harm` calls `harm` here.
"""

from __future__ import annotations

from kitrobot.sim.chance import happens
from kitrobot.sim.columns import (
    ASLEEP,
    CAUSE,
    DOWN,
    ENDED,
    FAILED,
    HARMED,
    LIVING,
    MUTED,
    PLANNED,
    REVIVALS,
    SINCE,
    SOUND,
    STALLED,
    TARGET,
    TICK,
    TOLD,
    TURN,
    WELL,
    tell,
)
from kitrobot.sim.sharing import leave, rejoin
from kitrobot.sim.standstill import stirred

FAIL, STALL, MUTE, REVIVE = range(4)
"""What befalls a robot; the order of `FailureKind`."""

BY_HAND, ON_SCHEDULE, BY_CHANCE = range(3)

PLAN_STEP, PLAN_ROBOT, PLAN_KIND = range(3)
PLAN_ROWS = 3


def harm(
    i: int,
    kind: int,
    cause: int,
    real: list[list[float]],
    whole: list[list[int]],
    cells: list[list[int]],
    shared: list[list[int]],
    apart: list[list[int]],
    mine_first: list[int],
    mine: list[int],
    mine_cell: list[int],
    copy_robot: list[int],
    copy_cell: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Does it to robot i, and says so; what would change nothing is no news."""
    down = whole[DOWN]
    muted = whole[MUTED]
    was_deaf = muted[i] != 0 or down[i] == FAILED
    was_sound = muted[i] == 0 and down[i] == WELL
    if kind == FAIL:
        if down[i] == FAILED:
            return
        down[i] = FAILED
        real[TOLD][i] = real[TARGET][i]
        real[TARGET][i] = 0.0
        real[TURN][i] = 0.0
        if whole[ENDED][i] == 0:
            clock[LIVING] -= 1
    elif kind == STALL:
        if down[i] != WELL:
            return
        down[i] = STALLED
    elif kind == MUTE:
        if muted[i]:
            return
        muted[i] = 1
    else:
        if down[i] == WELL and muted[i] == 0:
            return
        if down[i] == FAILED:
            real[TARGET][i] = real[TOLD][i]
            if whole[ENDED][i] == 0:
                clock[LIVING] += 1
        down[i] = WELL
        muted[i] = 0
        whole[ASLEEP][i] = 0
    if kind != MUTE:
        whole[SINCE][i] = clock[TICK]
        whole[CAUSE][i] = cause
    stirred(clock)
    tell(events, clock, HARMED, i, kind, cause)
    if whole[ENDED][i] == 0:
        if was_sound:
            clock[SOUND] -= 1
        if muted[i] == 0 and down[i] == WELL:
            clock[SOUND] += 1
    is_deaf = muted[i] != 0 or down[i] == FAILED
    if is_deaf and not was_deaf:
        leave(i, shared, apart, mine_first, mine)
    elif was_deaf and not is_deaf:
        rejoin(i, whole, cells, shared, apart, mine_first, mine, mine_cell, copy_robot, copy_cell, events, clock)


def harm_on_schedule(
    step: int,
    plan: list[list[int]],
    real: list[list[float]],
    whole: list[list[int]],
    cells: list[list[int]],
    shared: list[list[int]],
    apart: list[list[int]],
    mine_first: list[int],
    mine: list[int],
    mine_cell: list[int],
    copy_robot: list[int],
    copy_cell: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Does what is planned for this step."""
    steps = plan[PLAN_STEP]
    while clock[PLANNED] < len(steps) and steps[clock[PLANNED]] <= step:
        n = clock[PLANNED]
        clock[PLANNED] = n + 1
        kind = plan[PLAN_KIND][n]
        if kind == REVIVE:
            clock[REVIVALS] -= 1
        harm(
            plan[PLAN_ROBOT][n],
            kind,
            ON_SCHEDULE,
            real,
            whole,
            cells,
            shared,
            apart,
            mine_first,
            mine,
            mine_cell,
            copy_robot,
            copy_cell,
            events,
            clock,
        )


def harm_by_chance(
    step: int,
    every: int,
    probability: float,
    fate: list[list[int]],
    real: list[list[float]],
    whole: list[list[int]],
    cells: list[list[int]],
    shared: list[list[int]],
    apart: list[list[int]],
    mine_first: list[int],
    mine: list[int],
    mine_cell: list[int],
    copy_robot: list[int],
    copy_cell: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Lets the robots whose turn it is fail with this probability; each has its turn in one of `every` steps.

    `fate` is two rows: the two keys of each robot.
    """
    down = whole[DOWN]
    ended = whole[ENDED]
    for i in range(step % every, len(down), every):
        if down[i] == FAILED or ended[i] or not happens(fate[0][i], fate[1][i], step, probability):
            continue
        harm(
            i,
            FAIL,
            BY_CHANCE,
            real,
            whole,
            cells,
            shared,
            apart,
            mine_first,
            mine,
            mine_cell,
            copy_robot,
            copy_cell,
            events,
            clock,
        )
