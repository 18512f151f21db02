"""What is known of each robot, sensor and actuator of a run: the names of the columns of its tables.

A table is rows of numbers, one row a quantity, one entry a robot (or device): `floats[X][robot]`. In a run that is
stepped by CPython the rows are lists, in one that is stepped by Numba they are the rows of an array; the loops read
the same. Lengths are in mm, speeds in mm/s, angles in rad, times in s or, as integers, in steps.

Robots stand in the order of the team. Sensors, and actuators, are sorted by their device, so that those of one device
are side by side (see `devices`); each kind of device names its own columns (S_OWN, A_OWN).
"""

from __future__ import annotations

FREE = -1
"""The road of a robot that moves freely; less is that of one that was taken off a road (failed_robots)."""

# ---- robots, numbers with a fraction: state.robots.floats

(
    X,
    Y,
    HEADING,
    UX,  # the direction it looks in: cosine and sine of its heading
    UY,
    SPEED,
    TARGET,  # the commanded speed of its wheels
    ACCELERATION,
    BRAKING,
    TURN,  # how far it turns in this step
    WAY,  # how far it rolls in this step
    LENGTH,
    RADIUS,
    AT,  # mm along its road
    GAP_AHEAD,  # the free way to the next robot on the same road, bumper to bumper; infinite without one
    GAP_BEHIND,
    SAVED_TARGET,  # the commanded speed of a robot when it failed
) = range(17)
ROBOT_FLOATS = 17

# ---- robots, integers: state.robots.ints

(
    SOLID,  # 1: it has wheels, and others can touch it
    ROAD,
    STRETCH,  # which piece of the sampled road it is on
    LEADER,  # the robot ahead on the same road, or -1
    DIRECTED,  # 1: UX and UY are needed of a robot on a road
    LOW_X,  # the cells of the grid that it reaches into begin here
    LOW_Y,
    TOUCHING,
    BED,  # 1: it can carry a box
    LOAD,
    SIGNS,  # what devices show on the body of their robot, as bits: SIGN_LAMP, SIGN_ALARM, SIGN_ARM
    DELIVERED,  # boxes it brought
    PERIOD,  # its tick in steps
    PROGRAM,
    ACTUATOR_INDEX,  # its first actuator in `actuator_index`
    ENDED,
    ASLEEP,  # 1: the last tick changed nothing, so the next will not, until an input changes
    DOWN,  # whether its program misses its ticks: WELL, STALLED or FAILED
    MUTED,  # 1: it has lost its radio
    SINCE,  # the step in which DOWN became what it is
    CAUSE,  # what brought that about
    LEFT,  # 1: it was beyond the edge of the world once
    ORIGIN,  # 1 + the storehouse that its last box came from; 0 before the first one, -1 when that box is lost
    PIECES,  # in how many pieces it goes its way in this step
    NUDGED,  # in how many pieces of this step it moves, because a robot that moves in so many pushed it
) = range(25)
ROBOT_INTS = 25

SIGN_LAMP, SIGN_ALARM, SIGN_ARM = 1, 4, 8
"""Lamp on, collision sensor pressed, arm out; the bits between and above are other flags of an agent (simulation)."""

WELL, STALLED, FAILED = range(3)

# ---- sensors: state.sensors.ints and state.sensors.floats

(
    S_ROBOT,
    S_VALUE,  # what is measured now
    S_HELD,  # what came out of delay, drop-outs and noise last
    S_LAST,  # what the machine was given last
    S_CELL,
    S_LEAST,
    S_MOST,
    S_PLAIN,  # 1: neither late nor noisy nor lossy nor forced
    S_FORCED,  # 1: S_FORCE takes the place of what is measured
    S_FORCE,
    S_FLIPS,  # 1: its noise is a chance to be wrong, not a spread
    S_DRAWS,  # how many random numbers it has taken
    S_KEY_A,
    S_KEY_B,
    S_RING,  # where its past readings begin in `past`
    S_SIZE,  # how many of them: the delay in its own ticks, and one
    S_NEXT,  # where the next one goes
    S_FILLED,
    S_DOCK,
    S_STORE,
    S_SECTION,  # the section it was in
    S_RESTLESS,  # 1: what it reads may change although nothing does
    S_FIRST,  # where its numbers begin and end in `numbers`
    S_END,
) = range(24)
SENSOR_INTS = 24
S_NOISE, S_DROPOUT = range(2)
S_OWN = (2, 3, 4)
"""Columns that each kind of sensor uses as it likes; its module names them."""
SENSOR_FLOATS = 5

NO_READING = -(1 << 40)
"""S_LAST of a sensor whose machine has received no reading yet; no sensor reads it."""

# ---- actuators: state.actuators.ints and state.actuators.floats

(
    A_ROBOT,
    A_KIND,
    A_DONE,  # 1: what takes longer has ended
    A_CELL,  # where the machine reads that, or -1
    A_TAKEN,  # the command it took last, or -1
    A_FRESH,  # 1 + the step in which it received a new command
    A_DRAWS,
    A_KEY_A,
    A_KEY_B,
    A_DELAY,  # in steps
    A_QUEUE,  # where its queue begins in `queue`
    A_SIZE,  # how many commands that holds
    A_HEAD,
    A_QUEUED,
    A_QUEUED_LATER,  # how many of the queued ones take longer
    A_DOCK,
    A_STORE,
    A_ACTION,  # what it is about to do: its device's own
) = range(18)
ACTUATOR_INTS = 18
A_NOISE, A_DROPOUT = range(2)
A_OWN = (2, 3, 4, 5)
"""Columns that each kind of actuator uses as it likes; its module names them."""
ACTUATOR_FLOATS = 6

# ---- roads, integers: state.roads.ints

CLOSED, FIRST, LAST, CUT_FIRST, CUT_LAST = range(5)
"""Whether it is closed; its points, the last one inclusive; its sections, the last one exclusive."""

# ---- what does not change in a run: state.fixed_real and state.fixed

DT, WIDEST, FAILS, WIDTH, HEIGHT, SMALLEST = range(6)
TOGETHER, SEES, MOST_EVENTS, FAILS_EVERY, RULE, TOW_AFTER = range(6)

# ---- the run as a whole: state.clock

(
    TICK,
    RUNNING,  # programs that have not ended
    EVENTS,  # how many are in `events`
    COLLISIONS,
    CONTACTS,  # pairs that touched after the last step
    ROLLING,  # robots that rolled or turned in the last step
    MOVED,  # 1: robots moved since the grid was filled
    CHANCE,  # sensors whose reading may change although nothing does: by chance, or by a person's hand
    QUIET,  # steps without command and without motion that leads anywhere
    KEPT,  # 1: a state is kept to compare with
    DISTANCE,
    UNTIL,
    CYCLE,  # steps after which all ticks fall together again
    PATIENCE,  # quiet steps after which all late readings are in
    STUCK,
    LIVING,  # programs that have not ended, of robots that have not failed
    PLANNED,  # how much of the schedule of failures has been
    REVIVALS,  # how many revivals are still to come on schedule
    HEALTHY,  # programs that have not ended, of robots that have not failed, stalled or lost their radio
    PLANS,  # how long the schedule of failures is
    OFF_ROADS,  # robots that failed on a road and are to be taken off it
    PUSHABLES,  # pushable objects that moved in the last step
) = range(22)
CLOCKS = 22

# ---- what happens, as five numbers: kind, agent, what, how much, tick

(
    END,
    COLLISION,  # what: the other robot, or -1 - wall
    LOADED,  # what: the storehouse
    UNLOADED,
    NO_EMPTY_CARRIER,  # what: the dock
    NO_LOADED_CARRIER,
    NO_BOX,  # what: the storehouse
    NO_ROOM,
    WRITTEN,  # what: the shared variable, how much: its value
    LOST,  # what: the actuator that a command did not reach
    FAULT,  # what: the kind of fault, how much: its cause
    LEAVING,
    MOVED_OVER,  # what: the group that it is in now
    MISSED,  # the team goes on without it
    TAKEN_OVER,  # it plays a role now, what: the robot that was missed, much: 1 where that is itself
    BACK,  # it begins anew, as a spare one
    UNIT_LOST,  # what: the work of which it had a unit
    UNHEARD,  # what: the robot whose message, with news for this one, got lost
    TOWED,  # it is off its road, what: the storehouse that its box came from, how much: what became of that
    DRAWN,  # agent: the pen, what: what became of a point of its line, how much: the point (pens)
) = range(20)
EVENT = 5


def record_event(events: list[int], clock: list[int], kind: int, agent: int, what: int, much: int) -> None:
    """Appends an event to `events`; there is room for everything that can happen in a step."""
    at = EVENT * clock[EVENTS]
    events[at] = kind
    events[at + 1] = agent
    events[at + 2] = what
    events[at + 3] = much
    events[at + 4] = clock[TICK]
    clock[EVENTS] += 1
