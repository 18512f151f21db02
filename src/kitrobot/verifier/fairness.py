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

from kitrobot.verifier.absence_detection import is_over, may_pass
from kitrobot.verifier.columns import (
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
from kitrobot.verifier.state_decoding import decode, stays
from kitrobot.verifier.tables import Graph, Row, Tables
from kitrobot.verifier.traffic import fill_moves

ROOTS, ROOT, INDEX, TOP, WORK, REST, COLOUR, FIRST, EXPANDED, TWO = range(10)
SEARCH_NUMBERS = 10
"""How many roots there are, which is next, states found so far, the heights of `stack` and `work`, states left for the
next round, the last colour; where in `stack` the part begins that was found; states with all their steps; whether keys
have two words."""
LOOKED, TO_LOOK, GONE_ON, REACHED, COMPLETE = range(5)
"""What `reach` counts."""
BUSY, DONE, FAIR, MISSING = range(4)
"""What `search` says: it is to be gone on with, the round is over, a part was found, a table lacks something."""


class Search(NamedTuple):
    """What a search keeps, a number for each state; 32 bits are enough.

    Attributes:
        numbers: see `ROOTS`.
        colour: 0 for a state that does not count.
        order: 0 for one that was not found yet, -1 for one whose part is done.
        low: the least index that it leads to.
        roots, rest: the states of this round, and those of the next.
        stack: states whose part is not known yet.
        work, edge: the way to where the search is, and which step of each state is next.
        masks: what may happen in the state that is looked at: ends, begins, who gets on forward, backward; then the
            progress classes of the steps within a part; then for whom a team may not wait any longer in that state.
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


def search(t: Tables, g: Graph, s: Search, steps: int) -> int:
    """Goes on with a round for about so many steps."""
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
                enter(g, s, root)
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
                    enter(g, s, target)
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
            found = weigh(t, g, s, first)
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


def enter(g: Graph, s: Search, state: int) -> None:
    """Finds a state."""
    numbers = s.numbers
    numbers[INDEX] += 1
    s.order[state] = s.low[state] = numbers[INDEX]
    s.stack[numbers[TOP]] = state
    numbers[TOP] += 1
    s.work[numbers[WORK]] = state
    s.edge[numbers[WORK]] = g.first_edge[state]
    numbers[WORK] += 1


def weigh(t: Tables, g: Graph, s: Search, first: int) -> int:
    """Whether the part on top of the stack is fair; else what is left of it is put aside for the next round."""
    numbers, masks, stack = s.numbers, s.masks, s.stack
    n, top, two = t.fixed[AGENTS], numbers[TOP], numbers[TWO] == 1
    root_order, root_colour = s.order[stack[first]], s.colour[stack[first]]
    for k in range(4, 10):
        masks[k] = 0
    ends = begins = forward = backward = 0
    waited = -1
    is_left = top - first > 1
    if not is_left:
        # Most parts are one state, which something leaves in the end.
        if not may(t, g, s, stack[first], two):
            return MISSING
        is_stuck = not (masks[0] or masks[1] or masks[2] ^ masks[3] or masks[9])
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
                    masks[4 + k] |= t.taken[g.taken[e] * TAKEN_WIDTH + k]
        if not may(t, g, s, state, two):
            return MISSING
        ends, begins, forward, backward = ends | masks[0], begins | masks[1], forward | masks[2], backward | masks[3]
        waited &= masks[9]
    if not is_left:
        state = stack[first]
        rests = g.first_edge[state] == g.first_edge[state + 1]
        if rests and is_over(t):
            return FAIR
        if not rests and t.fixed[TIMING] != LOCKSTEP:
            decode(t, g.x[state], g.y[state] if two else 0)
            for i in range(n):
                if ticks_in(t, i) and not rests:
                    idle = stays(t, i)
                    if idle < 0:
                        return MISSING
                    rests = idle == 1
        if not rests:
            s.order[state] = -1
            return DONE
    wanted = ~masks[4] & (1 << n) - 1
    if t.fixed[TIMING] == LOCKSTEP:
        wanted &= t.fixed[SLOWER]
    place = first
    while wanted and place < top:
        decode(t, g.x[stack[place]], g.y[stack[place]] if two else 0)
        for i in range(n):
            if wanted >> i & 1:
                idle = stays(t, i) if ticks_in(t, i) else 1
                if idle < 0:
                    return MISSING
                if idle:
                    wanted &= ~(1 << i)
        place += 1
    starved_begins, starved_ends = begins & ~masks[5], ends & ~masks[6]
    # A lease that could always be over is, in the end; one that could be now and then may never be.
    starved = waited & ~masks[8]
    # Who rolls one way, again and again, and stays in its zone.
    caught = (forward ^ backward) & ~masks[7]
    if not wanted and not starved_begins and not starved_ends and not caught and not starved:
        return FAIR
    numbers[COLOUR] += 1
    for place in range(first, top):
        state = stack[place]
        if not may(t, g, s, state, two):
            return MISSING
        s.order[state] = -1
        keeps = not (starved_begins & masks[1] or starved_ends & masks[0] or caught & (masks[2] | masks[3]))
        if wanted or starved or not keeps:
            s.colour[state] = 0
        else:
            s.colour[state] = numbers[COLOUR]
            s.rest[numbers[REST]] = state
            numbers[REST] += 1
    return DONE


def ticks_in(t: Tables, i: int) -> bool:
    """Whether agent i has ticks in the state of `now`."""
    row = (i * t.fixed[INSIDE_STRIDE] + t.now[1 + i]) * t.fixed[INSIDE_WIDTH]
    return t.insides[row + I_TICKS] != 0


def may(t: Tables, g: Graph, s: Search, state: int, two: bool) -> bool:
    """Puts into `masks` what may happen in a state; False where a table lacks something."""
    fixed = t.fixed
    decode(t, g.x[state], g.y[state] if two else 0)
    for k in range(4):
        s.masks[k] = 0
    s.masks[9] = 0
    if is_over(t):
        return True
    if fixed[WATCHED]:
        s.masks[9] = may_pass(t)
    for i in range(fixed[AGENTS]):
        row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
        if t.insides[row + I_ENDS]:
            s.masks[0] |= 1 << i
    for road in range(fixed[ROADS]):
        conf = t.now[fixed[ROAD_FIELD] + road]
        row = conf * fixed[CONF_WIDTH]
        if t.confs[row + C_MOVES] < 0 and fill_moves(t, conf) < 0:
            return False
        s.masks[1] |= t.confs[row + C_BEGIN]
        s.masks[2] |= t.confs[row + C_FORWARD]
        s.masks[3] |= t.confs[row + C_BACKWARD]
    return True


def next_round(s: Search) -> Search:
    """The search through what is left."""
    numbers = s.numbers
    numbers[ROOTS], numbers[ROOT], numbers[REST] = numbers[REST], 0, 0
    numbers[INDEX] = numbers[TOP] = numbers[WORK] = 0
    for n in range(numbers[ROOTS]):
        s.order[s.rest[n]] = 0
    return s._replace(roots=s.rest, rest=s.roots)


def reach(g: Graph, marks: Row, since: Row, colour: Row, found: Row, before: Row, numbers: Row, steps: int) -> int:
    """Goes on for about so many states to give colour 1 to all marked states that can be reached through marked ones
    from those that are in `since` too, and to write them into `found`; 1 when there are no more.

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


def sample(g: Graph, part: Row, marks: Row, steps: Row) -> None:
    """Of each set of progress classes the first step within a part (`marks`): two numbers, -1 for none."""
    for n in range(len(part)):
        state = part[n]
        for e in range(g.first_edge[state], g.first_edge[state + 1]):
            if marks[g.targets[e]] and steps[2 * g.taken[e]] < 0:
                steps[2 * g.taken[e]] = state
                steps[2 * g.taken[e] + 1] = g.targets[e]


def way(g: Graph, start: int, end: int, marks: Row, before: Row, queue: Row) -> int:
    """A shortest way of at least one step to a state within a part: `before` says from where. Whether there is one."""
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
