"""Liveness: fair strongly connected components of the explored graph, in which a run can wait for ever.

A run is fair when it delays no progress class for ever (see `timing`): a tick that would change something all the time
happens eventually; any other event that is possible again and again happens eventually. Tarjan's algorithm (1972),
without recursion, finds the components. If an event is possible in a component and never happens in it, the states in
which it is possible are removed and the rest is searched again (Emerson and Lei, 1987).

Each state that counts has a *colour*; a search follows steps within one colour. What is left of a component gets a
colour of its own and is searched in the next round. This module uses only the subset of Python that Numba compiles.
"""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.verifier.tables.columns import (
    AGENTS,
    C_BACKWARD,
    C_BEGIN,
    C_FORWARD,
    C_MOVES,
    CONF_WIDTH,
    I_ENDS,
    I_TICKS,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    LOCKSTEP,
    ROAD_FIELD,
    ROADS,
    SLOWER,
    TAKEN_WIDTH,
    TIMING,
    WATCHED,
)
from kitrobot.verifier.tables.state_decoding import decode, may_idle
from kitrobot.verifier.tables.tables import Graph, Row, Tables
from kitrobot.verifier.tables.traffic import fill_moves
from kitrobot.verifier.transitions.absence_detection import is_team_over, possible_absences

ROOTS, ROOT, INDEX, TOP, WORK, REST, COLOUR, FIRST, EXPANDED, TWO = range(10)
SEARCH_NUMBERS = 10
"""How many roots there are, which is next, states found so far, the heights of `stack` and `work`, states left for the
next round, the last colour; where in `stack` the part begins that was found; states with all their steps; whether keys
have two words."""
LOOKED, TO_LOOK, GONE_ON, REACHED, COMPLETE = range(5)
"""What `mark_reachable` counts."""
BUSY, DONE, FAIR, MISSING = range(4)
"""Results of `find_fair_component`: call it again, the round is over, a component was found, a table lacks an entry."""


CAN_END, CAN_BEGIN, CAN_FORWARD, CAN_BACKWARD = range(4)
"""Places in `masks`: the agents, as bits, whose actions may complete in a state, that may begin to roll, that may enter
the next zone forward, or backward."""
TAKEN_TICKS, TAKEN_BEGINS, TAKEN_ENDS, TAKEN_ZONES, TAKEN_ABSENCES = range(4, 9)
"""Places in `masks`: the progress classes of the steps within a component, in the order of a row of `taken`."""
CAN_PASS = 9
"""The place in `masks` of the agents that a team may miss, or whose units may become free, in a state."""


class ComponentSearch(NamedTuple):
    """The data of a search, a number for each state; 32 bits are enough.

    Attributes:
        numbers: see `ROOTS`.
        colour: 0 for a state that does not count.
        order: the index of a state; 0 before it is found, -1 when its component is done.
        low: the least index that it leads to.
        roots, rest: the states of this round, and those of the next.
        stack: states whose component is not known yet.
        work, edge: the path to the current state, and the next step of each state on it.
        masks: bits of agents: what may happen in the current state (`CAN_END` …), and the progress classes of the steps
            within a component (`TAKEN_TICKS` …).
    """

    numbers: Row
    colour: Row
    order: Row
    low: Row
    roots: Row
    rest: Row
    stack: Row
    work: Row
    edge: Row
    masks: Row


def find_fair_component(t: Tables, g: Graph, s: ComponentSearch, steps: int) -> int:
    """Continues a round for about so many steps; returns `BUSY`, `DONE`, `FAIR` or `MISSING`."""
    numbers, colour, order, low, work, edge = s.numbers, s.colour, s.order, s.low, s.work, s.edge
    expanded = numbers[EXPANDED]
    while steps > 0:
        steps -= 1
        depth = numbers[WORK]
        if depth == 0:
            if numbers[ROOT] == numbers[ROOTS]:
                return DONE
            root = s.roots[numbers[ROOT]]
            numbers[ROOT] += 1
            if order[root] == 0 and colour[root] != 0 and root < expanded:
                push_state(g, s, root)
            continue
        state = work[depth - 1]
        at, end = edge[depth - 1], g.first_edge[state + 1]
        entered = False
        while at < end and not entered:
            target = g.targets[at]
            at += 1
            if target < expanded and colour[target] == colour[state]:
                if order[target] == 0:
                    edge[depth - 1] = at
                    push_state(g, s, target)
                    entered = True
                elif order[target] > 0 and order[target] < low[state]:
                    low[state] = order[target]
        if entered:
            continue
        edge[depth - 1] = at
        if low[state] == order[state]:
            first = numbers[TOP] - 1
            while s.stack[first] != state:
                first -= 1
            found = assess_component(t, g, s, first)
            if found == FAIR:
                numbers[FIRST] = first
                return FAIR
            if found == MISSING:
                return MISSING
            steps -= numbers[TOP] - first
            numbers[TOP] = first
        numbers[WORK] = depth - 1
        if depth > 1:
            before = work[depth - 2]
            if low[state] < low[before] and order[state] > 0:
                low[before] = low[state]
    return BUSY


def push_state(g: Graph, s: ComponentSearch, state: int) -> None:
    """Pushes a newly found state onto the stacks (Tarjan)."""
    numbers = s.numbers
    numbers[INDEX] += 1
    s.order[state] = s.low[state] = numbers[INDEX]
    s.stack[numbers[TOP]] = state
    numbers[TOP] += 1
    s.work[numbers[WORK]] = state
    s.edge[numbers[WORK]] = g.first_edge[state]
    numbers[WORK] += 1


def assess_component(t: Tables, g: Graph, s: ComponentSearch, first: int) -> int:
    """Decides whether the top component of the stack is fair; if not, queues what is left of it for the next round."""
    numbers, masks, stack = s.numbers, s.masks, s.stack
    n, top, two = t.fixed[AGENTS], numbers[TOP], numbers[TWO] == 1
    root_order, root_colour = s.order[stack[first]], s.colour[stack[first]]
    for k in range(TAKEN_TICKS, CAN_PASS + 1):
        masks[k] = 0
    ends = begins = forward = backward = 0
    waited = -1
    is_left = top - first > 1
    if not is_left:
        # Most components are one state, which some event leaves eventually.
        if not collect_enabled(t, g, s, stack[first], two):
            return MISSING
        is_stuck = not (
            masks[CAN_END] or masks[CAN_BEGIN] or masks[CAN_FORWARD] ^ masks[CAN_BACKWARD] or masks[CAN_PASS]
        )
        for e in range(g.first_edge[stack[first]], g.first_edge[stack[first] + 1]):
            is_stuck = is_stuck or g.targets[e] == stack[first]
        if not is_stuck:
            s.order[stack[first]] = -1
            return DONE
    for place in range(first, top):
        state = stack[place]
        for e in range(g.first_edge[state], g.first_edge[state + 1]):
            target = g.targets[e]
            if target == state:
                is_left = True
            if target < numbers[EXPANDED] and s.colour[target] == root_colour and s.order[target] >= root_order:
                for k in range(TAKEN_WIDTH):
                    masks[TAKEN_TICKS + k] |= t.taken[g.taken[e] * TAKEN_WIDTH + k]
        if not collect_enabled(t, g, s, state, two):
            return MISSING
        ends, begins, forward, backward = (
            ends | masks[CAN_END],
            begins | masks[CAN_BEGIN],
            forward | masks[CAN_FORWARD],
            backward | masks[CAN_BACKWARD],
        )
        waited &= masks[CAN_PASS]
    if not is_left:
        state = stack[first]
        rests = g.first_edge[state] == g.first_edge[state + 1]
        if rests and is_team_over(t):
            return FAIR
        if not rests and t.fixed[TIMING] != LOCKSTEP:
            decode(t, g.x[state], g.y[state] if two else 0)
            for i in range(n):
                if has_ticks(t, i) and not rests:
                    idle = may_idle(t, i)
                    if idle < 0:
                        return MISSING
                    rests = idle == 1
        if not rests:
            s.order[state] = -1
            return DONE
    wanted = ~masks[TAKEN_TICKS] & (1 << n) - 1
    if t.fixed[TIMING] == LOCKSTEP:
        wanted &= t.fixed[SLOWER]
    place = first
    while wanted and place < top:
        decode(t, g.x[stack[place]], g.y[stack[place]] if two else 0)
        for i in range(n):
            if wanted >> i & 1:
                idle = may_idle(t, i) if has_ticks(t, i) else 1
                if idle < 0:
                    return MISSING
                if idle:
                    wanted &= ~(1 << i)
        place += 1
    starved_begins, starved_ends = begins & ~masks[TAKEN_BEGINS], ends & ~masks[TAKEN_ENDS]
    # A lease that could end all the time ends eventually; one that could only now and then may never end.
    starved = waited & ~masks[TAKEN_ABSENCES]
    # Robots that roll one way, again and again, and stay in their zones.
    caught = (forward ^ backward) & ~masks[TAKEN_ZONES]
    if not wanted and not starved_begins and not starved_ends and not caught and not starved:
        return FAIR
    numbers[COLOUR] += 1
    for place in range(first, top):
        state = stack[place]
        if not collect_enabled(t, g, s, state, two):
            return MISSING
        s.order[state] = -1
        keeps = not (
            starved_begins & masks[CAN_BEGIN]
            or starved_ends & masks[CAN_END]
            or caught & (masks[CAN_FORWARD] | masks[CAN_BACKWARD])
        )
        if wanted or starved or not keeps:
            s.colour[state] = 0
        else:
            s.colour[state] = numbers[COLOUR]
            s.rest[numbers[REST]] = state
            numbers[REST] += 1
    return DONE


def has_ticks(t: Tables, i: int) -> bool:
    """Whether agent i has ticks in the state of `now`."""
    row = (i * t.fixed[INSIDE_STRIDE] + t.now[1 + i]) * t.fixed[INSIDE_WIDTH]
    return t.insides[row + I_TICKS] != 0


def collect_enabled(t: Tables, g: Graph, s: ComponentSearch, state: int, two: bool) -> bool:
    """Writes into `masks` what may happen in a state; returns False if a table lacks an entry."""
    fixed = t.fixed
    decode(t, g.x[state], g.y[state] if two else 0)
    for k in range(4):
        s.masks[k] = 0
    s.masks[CAN_PASS] = 0
    if is_team_over(t):
        return True
    if fixed[WATCHED]:
        s.masks[CAN_PASS] = possible_absences(t)
    for i in range(fixed[AGENTS]):
        row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
        if t.insides[row + I_ENDS]:
            s.masks[CAN_END] |= 1 << i
    for road in range(fixed[ROADS]):
        conf = t.now[fixed[ROAD_FIELD] + road]
        row = conf * fixed[CONF_WIDTH]
        if t.confs[row + C_MOVES] < 0 and fill_moves(t, conf) < 0:
            return False
        s.masks[CAN_BEGIN] |= t.confs[row + C_BEGIN]
        s.masks[CAN_FORWARD] |= t.confs[row + C_FORWARD]
        s.masks[CAN_BACKWARD] |= t.confs[row + C_BACKWARD]
    return True


def next_round(s: ComponentSearch) -> ComponentSearch:
    """The search of the next round, through what is left."""
    numbers = s.numbers
    numbers[ROOTS], numbers[ROOT], numbers[REST] = numbers[REST], 0, 0
    numbers[INDEX] = numbers[TOP] = numbers[WORK] = 0
    for n in range(numbers[ROOTS]):
        s.order[s.rest[n]] = 0
    return s._replace(roots=s.rest, rest=s.roots)


def mark_reachable(
    g: Graph, marks: Row, since: Row, colour: Row, found: Row, before: Row, numbers: Row, steps: int
) -> int:
    """Gives colour 1 to all marked states reachable through marked ones from those that are also in `since`.

    It writes them into `found`, and works on about so many states per call; returns 1 when there are no more.

    `before` says from where each was reached, -1 of those in `since`. `numbers`: how many states are looked through for
    those in `since`, and how many of them are; how many of those found are gone on from, and how many there are; how
    many states have all their steps.
    """
    while steps > 0 and numbers[LOOKED] < numbers[TO_LOOK]:
        steps -= 1
        state = numbers[LOOKED]
        numbers[LOOKED] += 1
        if marks[state] and since[state]:
            colour[state], before[state] = 1, -1
            found[numbers[REACHED]] = state
            numbers[REACHED] += 1
    count = numbers[REACHED]
    at = numbers[GONE_ON]
    while steps > 0 and at < count:
        steps -= 1
        state = found[at]
        at += 1
        if state >= numbers[COMPLETE]:
            continue
        for e in range(g.first_edge[state], g.first_edge[state + 1]):
            target = g.targets[e]
            if marks[target] and colour[target] == 0:
                colour[target], before[target] = 1, state
                found[count] = target
                count += 1
    numbers[GONE_ON], numbers[REACHED] = at, count
    return 1 if at == count and numbers[LOOKED] == numbers[TO_LOOK] else 0


def sample_steps(g: Graph, part: Row, marks: Row, steps: Row) -> None:
    """Writes, for each set of progress classes, the first step within a component (`marks`): two numbers or -1."""
    for n in range(len(part)):
        state = part[n]
        for e in range(g.first_edge[state], g.first_edge[state + 1]):
            if marks[g.targets[e]] and steps[2 * g.taken[e]] < 0:
                steps[2 * g.taken[e]] = state
                steps[2 * g.taken[e] + 1] = g.targets[e]


def find_shortest_path(g: Graph, start: int, end: int, marks: Row, before: Row, queue: Row) -> int:
    """Finds a shortest path of at least one step within a component, backwards in `before`; returns 1 if it exists."""
    queue[0] = start
    count, at = 1, 0
    for n in range(len(before)):
        before[n] = -1
    while at < count:
        state = queue[at]
        at += 1
        for e in range(g.first_edge[state], g.first_edge[state + 1]):
            target = g.targets[e]
            if marks[target] and before[target] < 0:
                before[target] = state
                if target == end:
                    return 1
                if target != start:
                    queue[count] = target
                    count += 1
    return 0
