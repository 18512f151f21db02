"""Names of the columns of the model's tables, and of the registers of an exploration.

A state is a key of one or two words of 63 bits, cut into *fields*: field 0 is the shared state (boxes in storehouses,
shared variables, remaining failures), then one field for each agent (its state except its motion), one for each road
(the motion of all robots on it), and under *prompt* one of bits: which agents have a tick to make. A field holds the
number of a *component*; tables say what each component is.
"""

from __future__ import annotations

WORD_BITS = 63
"""Bits of a word that are used, so that CPython's numbers and those of 64 bits are the same."""
MOST_AGENTS = 62
"""Agents at most: sets of them are bits of one word."""

# -- numbers that do not change during an exploration (`fixed`)
AGENTS, ROADS, PLACES, DOCKS, HOUSES, TIMING, ACTS, FIELDS, ROAD_FIELD, DUE_FIELD = range(10)
INSIDE_WIDTH, INSIDE_STRIDE, CONF_WIDTH, SHARED_WIDTH, POOL_WIDTH, USED_BITS, MAY_FAIL, SLOWER, SETTLES = range(10, 19)
WATCHED = 19
"""Where a team misses members, 1 and how many works it has; 0 elsewhere."""
FIXED = 20
LOCKSTEP, PROMPT, FREE = range(3)
MAY_CRASH, MAY_STALL, MAY_MUTE = 1, 2, 4
"""Bits of `MAY_FAIL`: the possible faults of agents; 0 for none."""

# -- numbers that do (`regs`)
CODE, CONFS, MOVES, MOVE_SETS, LOG, NEXTS, TAKEN = range(7)
"""Why the exploration paused, and the number of rows of each table."""
MISS_A, MISS_B, MISS_C, SEEK, FOUND = range(7, 12)
AT, COUNT, EDGES, LEVEL_END, DEPTH, CALMS, MOST, SEEN_KINDS, KEEPS, WORDS, TOUCHED = range(12, 23)
AFTERS, AFTER_ROWS, CHOICES = range(23, 26)
IS_WORKER, GATHERS, BASE, BATCH_FIRST, GATHER_AT, GATHERED, STEP_ROOM, LEFT_OUT = range(26, 34)
"""Whether these are a worker's tables, which adds nothing to what all workers share; whether steps are gathered in a
batch (`GATHERS_ALL`), or only those that a worker left out; the number of the first state that is kept; of a batch its
first state, the state that is next, how many steps there are and how many may be, and how many states were left out.
"""
GATHERS_ALL, GATHERS_LEFT_OUT = 1, 2
FIRST_OF = 34
"""From here on: for each kind of event, the first state in which it occurs."""
KINDS = 24
REGS = FIRST_OF + KINDS

# -- why the exploration paused
GOES_ON, ROOM_CONFS, ROOM_MOVES, ROOM_MOVE_SETS, ROOM_LOG, ROOM_NEXT, ROOM_STATES, ROOM_EDGES, ROOM_CALM = range(9)
WIDEN, MISS_REACTION, MISS_SHARED, MISS_DONE, MISS_LOADED, MISS_DOWN, TOO_MANY, CUT = range(9, 17)
ROOM_AFTERS, ROOM_STEPS, MISS_AS_WORKER = range(17, 20)

# -- a row of `agents`
(A_ROAD, A_PLACE, A_LEADER, A_FOLLOWER, A_LATE, A_ZONES, A_CLOSED, A_BEYOND, A_ZONE_AT, A_GAP_AT, A_CAN_AT) = range(11)
A_SENSES_AT, A_SENSES, A_VISIT, A_VISITS, A_ACT, A_ACTS, A_BED, A_SHARES = range(11, 19)
AGENT = 19
UNSHARED, SHARED, KEPT = range(3)
"""`A_SHARES`: whether others hear of it, and whether what it knows of shared variables counts once it has failed."""
# -- a row of `visits`: a dock, the number of its road (-1), the load that is wanted (2: any)
VISIT = 3
# -- a row of `acts`: whether it is an arm, its dock, its storehouse, the number of the dock's road, its capacity
ACT = 5

# -- a row of `insides`
I_TICKS, I_LOAD, I_DOWN, I_ENDS, I_ENDED, I_LOADED, I_BEFALLEN = range(7)
"""Whether it has ticks; its load; its fault; whether an action can complete; whether its program has ended; the
number with the other load; with RUNS, STALLED and FAILED, once its program began anew, and once it is missed (five);
whether it has lost its radio."""
I_MUTED = 11
I_ACT = 12
"""From here on two for each actuator: what it does (0 nothing, 1 its first procedure …), the number once done."""

# -- a row of `shared`: failures that may still come, boxes in each storehouse, then what each agent sees of it
G_FAILURES, G_STOCK = range(2)
G_MEMBERS, G_SILENT, G_PLAYING, G_MISSED, G_OVER, G_HOLDING = range(6)
"""Where a team misses members, behind these, as bits: who is of it and has not ended, who is silent, who plays a role,
who is missed; whether it cannot go on; of each work who has a unit with a lease."""
NO_WRITE = 0
"""`writes`: nothing, then for each storehouse a box less and a box more, a failure less, that a team settles what
it can agree on; where it misses members, for each agent what comes of that (`W_SILENT`); and what ticks write."""
W_SILENT, W_BACK, W_MISSED, W_ANEW, W_FREED = range(5)
"""That it is silent, is heard again, is missed, is missed and begins anew; of each work that its unit is free again."""

# -- a row of `confs`: the motion of all robots on a road
(C_ROAD, C_FORWARD, C_BACKWARD, C_BEGIN, C_MUST, C_MOVE, C_MOVES, C_MOVE_SET, C_MOVE_SETS) = range(9)
C_STAND = 9
"""From here on: who stands in each dock; what each robot senses of the road; how it moves; and after a tick of its own,
eight for each."""
MOVE = 3
"""A row of `moves`: the number after it, the event, its progress class."""
MOVE_SET = 6
"""A row of `move_sets`: the number after it, who began to roll, who came into a zone, kinds, the first event in `log`,
how many."""
AFTER_HEAD, AFTER = 4, 6
"""A row of `after_heads`: a key (two words), its first row in `after`, how many. One of `after`: the key of what may
follow, who of the slower agents ticked, kinds of faults, the row of `faults` with them, and for whom the
team did not wait any longer."""
OUTCOME = 3
"""A row of `outcomes`: the agent's number after it, the command of its wheels (`conf_after_tick`), its write."""
S_COUNT = 13
"""A value of `reaction_at`: the first row, above how many there are."""
TAKEN_WIDTH = 5
"""A row of `taken`: who ticked, began to roll, came to an end, came into another zone, and for whom a team did not wait
any longer, as bits."""
LINE = 6
"""A row of `line` and `faults`: a key (two words), the event that led to it, the row it came from (-1), kinds of events
so far, and who came to an end; of `faults`, for whom a team did not wait any longer."""

# -- the key of a reaction: inside, seen of shared, seen of the road, visits, agent; or, with the bit above these, of
# what an agent is once it has lost its radio: inside, seen of shared, agent
S_SHARED, S_VIEW, S_VISITS, S_AGENT, S_MUTE = 18, 34, 48, 56, 62
MOST_INSIDES, MOST_SEEN, MOST_VIEWS, MOST_VISITS = 1 << 18, 1 << 16, 1 << 14, 1 << 8
S_WRITE = 24
"""The key of a change of the shared state: the number before it, above the write."""

# -- an event as one number
E_AGENT, E_OTHER = 6, 16
E_KIND = 63
E_MASK = 1023

MULTIPLIER = 0x1E3779B97F4A7C15
OTHER_MULTIPLIER = 0x2545F4914F6CDD1D
ALL_BITS = (1 << 63) - 1
