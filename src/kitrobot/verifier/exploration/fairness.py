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


CAN_END, CAN_BEGIN, CAN_FORWARD, CAN_BACKWARD, CAN_PASS = range(5)
"""Places in `enabled` and `possible`: the agents, as bits, whose actions may complete, that may begin to roll, that may
enter the next zone forward, or backward; and those that a team may miss, or whose units may become free."""
TICKS, BEGINS, ENDS, ZONES, ABSENCES = range(5)
"""Places in `taken` and `starved`: the progress classes, in the order of a row of `Tables.taken`."""
MASKS = frozenset({"numbers", "enabled", "possible", "taken", "starved"})
"""The rows of a search that need 64 bits."""


class ComponentSearch(NamedTuple):
    """The data of a search, a number for each state; 32 bits are enough. In the last four rows agents are bits.

    Attributes:
        numbers: see `ROOTS`.
        colour: 0 for a state that does not count.
        order: the index of a state; 0 before it is found, -1 when its component is done.
        low: the least index that it leads to.
        roots, rest: the states of this round, and those of the next.
        stack: states whose component is not known yet.
        work, edge: the path to the current state, and the next step of each state on it.
        enabled: what may happen in the current state (`CAN_END` …).
        possible: what may happen in a component: somewhere in it, but for absences, which count if they may everywhere.
        taken: the progress classes of the steps within a component (`TICKS` …).
        starved: those that are delayed for ever in a component.
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
    enabled: Row
    possible: Row
    taken: Row
    starved: Row


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
    state = s.stack[first]
    if s.numbers[TOP] - first == 1 and not has_step_to_itself(g, state):
        found = assess_single_state(t, g, s, state)
        if found != BUSY:
            return found
    if not collect_component(t, g, s, first):
        return MISSING
    possible, taken, starved = s.possible, s.taken, s.starved
    starved[TICKS] = find_starved_ticks(t, g, s, first)
    if starved[TICKS] < 0:
        return MISSING
    starved[BEGINS] = possible[CAN_BEGIN] & ~taken[BEGINS]
    starved[ENDS] = possible[CAN_END] & ~taken[ENDS]
    # Robots that roll one way, again and again, and stay in their zones.
    starved[ZONES] = (possible[CAN_FORWARD] ^ possible[CAN_BACKWARD]) & ~taken[ZONES]
    # A lease that could end all the time ends eventually; one that could only now and then may never end.
    starved[ABSENCES] = possible[CAN_PASS] & ~taken[ABSENCES]
    if not (starved[TICKS] or starved[BEGINS] or starved[ENDS] or starved[ZONES] or starved[ABSENCES]):
        return FAIR
    return DONE if queue_rest(t, g, s, first) else MISSING


def has_step_to_itself(g: Graph, state: int) -> bool:
    """Whether a step leads from a state to itself."""
    at, end = g.first_edge[state], g.first_edge[state + 1]
    while at < end and g.targets[at] != state:
        at += 1
    return at < end


def assess_single_state(t: Tables, g: Graph, s: ComponentSearch, state: int) -> int:
    """Decides about a component of one state without steps to itself; returns `BUSY` if a run may stay in it.

    Most components are one state, which some event leaves eventually.
    """
    if not collect_enabled(t, g, s, state):
        return MISSING
    enabled = s.enabled
    rolls = enabled[CAN_BEGIN] or enabled[CAN_FORWARD] ^ enabled[CAN_BACKWARD]
    if not (rolls or enabled[CAN_END] or enabled[CAN_PASS]):
        if g.first_edge[state] == g.first_edge[state + 1]:
            return FAIR if is_team_over(t) else BUSY
        for i in range(t.fixed[AGENTS] if t.fixed[TIMING] != LOCKSTEP else 0):
            if has_ticks(t, i):
                idle = may_idle(t, i)
                if idle < 0:
                    return MISSING
                if idle:
                    return BUSY
    s.order[state] = -1
    return DONE


def collect_component(t: Tables, g: Graph, s: ComponentSearch, first: int) -> bool:
    """Writes `possible` and `taken` of the top component of the stack; returns False if a table lacks an entry."""
    enabled, possible, taken = s.enabled, s.possible, s.taken
    expanded, root = s.numbers[EXPANDED], s.stack[first]
    order, colour = s.order[root], s.colour[root]
    for k in range(TAKEN_WIDTH):
        taken[k] = 0
    for k in range(CAN_PASS):
        possible[k] = 0
    possible[CAN_PASS] = -1
    for place in range(first, s.numbers[TOP]):
        state = s.stack[place]
        for e in range(g.first_edge[state], g.first_edge[state + 1]):
            target = g.targets[e]
            if target < expanded and s.colour[target] == colour and s.order[target] >= order:
                for k in range(TAKEN_WIDTH):
                    taken[k] |= t.taken[g.taken[e] * TAKEN_WIDTH + k]
        if not collect_enabled(t, g, s, state):
            return False
        for k in range(CAN_PASS):
            possible[k] |= enabled[k]
        possible[CAN_PASS] &= enabled[CAN_PASS]
    return True


def find_starved_ticks(t: Tables, g: Graph, s: ComponentSearch, first: int) -> int:
    """The agents, as bits, whose ticks change something in every state of a component, and are never taken in it.

    It returns -1 if a table lacks an entry.
    """
    n = t.fixed[AGENTS]
    starved = ~s.taken[TICKS] & (1 << n) - 1
    if t.fixed[TIMING] == LOCKSTEP:
        starved &= t.fixed[SLOWER]
    place = first
    while starved and place < s.numbers[TOP]:
        decode_state(t, g, s, s.stack[place])
        for i in range(n):
            if starved >> i & 1:
                idle = may_idle(t, i) if has_ticks(t, i) else 1
                if idle < 0:
                    return -1
                if idle:
                    starved &= ~(1 << i)
        place += 1
    return starved


def queue_rest(t: Tables, g: Graph, s: ComponentSearch, first: int) -> bool:
    """Queues the states of a component in which nothing starved is possible, under a new colour, for the next round.

    It returns False if a table lacks an entry.
    """
    numbers, enabled, starved = s.numbers, s.enabled, s.starved
    numbers[COLOUR] += 1
    for place in range(first, numbers[TOP]):
        state = s.stack[place]
        if not collect_enabled(t, g, s, state):
            return False
        s.order[state] = -1
        # A tick or an absence that starves is possible in every state.
        if (
            starved[TICKS]
            or starved[ABSENCES]
            or starved[BEGINS] & enabled[CAN_BEGIN]
            or starved[ENDS] & enabled[CAN_END]
            or starved[ZONES] & (enabled[CAN_FORWARD] | enabled[CAN_BACKWARD])
        ):
            s.colour[state] = 0
        else:
            s.colour[state] = numbers[COLOUR]
            s.rest[numbers[REST]] = state
            numbers[REST] += 1
    return True


def decode_state(t: Tables, g: Graph, s: ComponentSearch, state: int) -> None:
    """Writes the fields of a state into `now`."""
    decode(t, g.x[state], g.y[state] if s.numbers[TWO] else 0)


def has_ticks(t: Tables, i: int) -> bool:
    """Whether agent i has ticks in the state of `now`."""
    row = (i * t.fixed[INSIDE_STRIDE] + t.now[1 + i]) * t.fixed[INSIDE_WIDTH]
    return t.insides[row + I_TICKS] != 0


def collect_enabled(t: Tables, g: Graph, s: ComponentSearch, state: int) -> bool:
    """Writes into `enabled` what may happen in a state; returns False if a table lacks an entry."""
    fixed, enabled = t.fixed, s.enabled
    decode_state(t, g, s, state)
    for k in range(CAN_PASS + 1):
        enabled[k] = 0
    if is_team_over(t):
        return True
    if fixed[WATCHED]:
        enabled[CAN_PASS] = possible_absences(t)
    for i in range(fixed[AGENTS]):
        row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
        if t.insides[row + I_ENDS]:
            enabled[CAN_END] |= 1 << i
    for road in range(fixed[ROADS]):
        conf = t.now[fixed[ROAD_FIELD] + road]
        row = conf * fixed[CONF_WIDTH]
        if t.confs[row + C_MOVES] < 0 and fill_moves(t, conf) < 0:
            return False
        enabled[CAN_BEGIN] |= t.confs[row + C_BEGIN]
        enabled[CAN_FORWARD] |= t.confs[row + C_FORWARD]
        enabled[CAN_BACKWARD] |= t.confs[row + C_BACKWARD]
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
