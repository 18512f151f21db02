"""The successors of a state in *prompt* and *free*: single ticks of agents, completed actions, moves and faults.

A step is a sequence of look-ups: a tick is looked up in `reaction_at` by the agent's own state and a few bits of what
it senses, and changes the key of the state by XOR. -1 means that a table lacks an entry (`regs[CODE]` says which one):
the caller adds it and calls again. This module uses only the subset of Python that Numba compiles.
"""

from __future__ import annotations

from kitrobot.verifier.tables.columns import (
    A_PLACE,
    A_ROAD,
    AGENT,
    AGENTS,
    C_MOVE,
    C_MOVES,
    C_STAND,
    CHOICES,
    CONF_WIDTH,
    DOCKS,
    DUE_FIELD,
    E_AGENT,
    E_KIND,
    I_ENDS,
    I_TICKS,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    LINE,
    MAY_FAIL,
    MOVE,
    NEXTS,
    OUTCOME,
    PLACES,
    PROMPT,
    ROAD_FIELD,
    ROADS,
    S_COUNT,
    TAKEN_WIDTH,
    TIMING,
    WATCHED,
)
from kitrobot.verifier.tables.events import FAIL, MUTE, TICK
from kitrobot.verifier.tables.state_decoding import decode, emit_step, find_reactions, look_up_change, may_idle
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.tables.traffic import conf_after_tick, fill_moves
from kitrobot.verifier.transitions.absence_detection import detect_absences, is_team_over
from kitrobot.verifier.transitions.simultaneous_ticks import add_simultaneous_ticks
from kitrobot.verifier.transitions.world_transitions import RESUMES, write_completions, write_faults


def expand_interleaved(t: Tables, x: int, y: int) -> int:
    """Finds the steps out of a state of *prompt* or *free*; ticks that change nothing are left out."""
    regs, fixed, now = t.regs, t.fixed, t.now
    regs[NEXTS] = 0
    decode(t, x, y)
    is_prompt = fixed[TIMING] == PROMPT
    if is_team_over(t):
        return 0
    due = now[fixed[DUE_FIELD]] if is_prompt else 0
    if not add_ticks(t, x, y, is_prompt):
        return -1
    if due == 0 and not add_world_events(t, x, y):
        return -1
    if fixed[MAY_FAIL]:
        for i in range(fixed[AGENTS]):
            found = write_faults(t, x, y, i, 0, RESUMES)
            if found < 0:
                return -1
            for n in range(found):
                event, row = t.faults[n * LINE + 2], n * LINE
                if fixed[WATCHED]:
                    if detect_absences(t, n, found, 0) < 0:
                        return -1
                    row = found * LINE
                if not emit_step(t, t.faults[row], t.faults[row + 1], event, 0):
                    return -1
            if fixed[WATCHED]:
                decode(t, x, y)
    if fixed[WATCHED] and due == 0 and not add_absences(t, x, y):
        return -1
    return make_due(t, x, y, due) if is_prompt else regs[NEXTS]


def add_ticks(t: Tables, x: int, y: int, keeps: bool) -> bool:
    """Adds the ticks of all agents, one each, and the simultaneous ticks with other results.

    Ticks that change nothing are added only if steps are stored (`keeps`).
    """
    fixed, now, agents, insides, outcomes = t.fixed, t.now, t.agents, t.insides, t.outcomes
    shift, word, confs = t.shift, t.word, t.confs
    stride, width, conf_width = fixed[INSIDE_STRIDE], fixed[INSIDE_WIDTH], fixed[CONF_WIDTH]
    ticks_at = C_STAND + fixed[DOCKS] + 2 * fixed[PLACES]
    writers = 0
    for i in range(fixed[AGENTS]):
        inside = now[1 + i]
        if not insides[(i * stride + inside) * width + I_TICKS]:
            continue
        got = find_reactions(t, i)
        if got < 0:
            return False
        road = agents[i * AGENT + A_ROAD]
        first = got >> S_COUNT
        for o in range(first, first + (got & (1 << S_COUNT) - 1)):
            nx, ny = x, y
            d = inside ^ outcomes[o * OUTCOME]
            if d:
                if word[1 + i]:
                    ny ^= d << shift[1 + i]
                else:
                    nx ^= d << shift[1 + i]
            if road >= 0:
                f = fixed[ROAD_FIELD] + road
                told, k = outcomes[o * OUTCOME + 1], agents[i * AGENT + A_PLACE]
                to = confs[now[f] * conf_width + ticks_at + 8 * k + told]
                if to < 0:
                    to = conf_after_tick(t, now[f], k, told)
                    if to < 0:
                        return False
                d = now[f] ^ to
                if d:
                    if word[f]:
                        ny ^= d << shift[f]
                    else:
                        nx ^= d << shift[f]
            if outcomes[o * OUTCOME + 2]:
                writers |= 1 << i
                after = look_up_change(t, now[0], outcomes[o * OUTCOME + 2])
                if after < 0:
                    return False
                nx ^= (now[0] ^ after) << shift[0]
            if (keeps or nx != x or ny != y) and not emit_step(t, nx, ny, TICK | i << E_AGENT, 1 + i):
                return False
    return writers & writers - 1 == 0 or add_simultaneous_ticks(t, x, y, writers)


def add_world_events(t: Tables, x: int, y: int) -> bool:
    """Adds the events of the world: completed actions, and moves of robots on roads."""
    fixed, now = t.fixed, t.now
    stride, width = fixed[INSIDE_STRIDE], fixed[INSIDE_WIDTH]
    for i in range(fixed[AGENTS]):
        if not t.insides[(i * stride + now[1 + i]) * width + I_ENDS]:
            continue
        found = write_completions(t, x, y, i, 0)
        if found < 0:
            return False
        for n in range(found):
            row = n * LINE
            if not emit_step(t, t.line[row], t.line[row + 1], t.line[row + 2], 1 + 2 * fixed[AGENTS] + i):
                return False
    for road in range(fixed[ROADS]):
        f = fixed[ROAD_FIELD] + road
        conf = now[f]
        row = conf * fixed[CONF_WIDTH]
        count = t.confs[row + C_MOVES]
        if count < 0:
            count = fill_moves(t, conf)
            if count < 0:
                return False
        first = t.confs[row + C_MOVE]
        for m in range(first, first + count):
            d = (conf ^ t.moves[m * MOVE]) << t.shift[f]
            nx, ny = (x, y ^ d) if t.word[f] else (x ^ d, y)
            if not emit_step(t, nx, ny, t.moves[m * MOVE + 1], t.moves[m * MOVE + 2]):
                return False
    return True


def add_absences(t: Tables, x: int, y: int) -> bool:
    """Adds absences: a team stops waiting for a member, or the lease of a unit of work ends."""
    faults, chosen, choices = t.faults, 0, 1
    faults[0], faults[1], faults[4] = x, y, 0
    while chosen < choices:
        rows = detect_absences(t, 0, 1, 1 << chosen)
        if rows < 0:
            return False
        choices = t.regs[CHOICES]
        event = faults[LINE + 2]
        if rows and not emit_step(
            t, faults[LINE], faults[LINE + 1], event, 1 + 4 * t.fixed[AGENTS] + (event >> E_AGENT)
        ):
            return False
        chosen += 1
    return True


def make_due(t: Tables, x: int, y: int, due: int) -> int:
    """Writes the due ticks into each step of *prompt*; returns the number of steps."""
    fixed = t.fixed
    f = fixed[DUE_FIELD]
    stored = 0
    for n in range(t.regs[NEXTS]):
        event, nx, ny = t.next_event[n], t.next_x[n], t.next_y[n]
        kind = event & E_KIND
        wanted = t.mask[f]
        if kind == TICK:
            wanted = due & ~t.taken[t.next_taken[n] * TAKEN_WIDTH]
        elif FAIL <= kind <= MUTE:
            wanted = due
        left = due_in(t, nx, ny, wanted)
        if left < 0:
            return -1
        d = (due ^ left) << t.shift[f]
        nx, ny = (nx, ny ^ d) if t.word[f] else (nx ^ d, ny)
        if kind == TICK and nx == x and ny == y:
            continue
        t.next_x[stored], t.next_y[stored], t.next_event[stored] = nx, ny, event
        t.next_taken[stored], t.next_kinds[stored] = t.next_taken[n], t.next_kinds[n]
        stored += 1
    t.regs[NEXTS] = stored
    return stored


def due_in(t: Tables, x: int, y: int, wanted: int) -> int:
    """The agents among `wanted`, as bits, with a due tick in a state: one that would change something."""
    if wanted == 0:
        return 0
    decode(t, x, y)
    fixed = t.fixed
    left = 0
    for i in range(fixed[AGENTS]):
        row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
        if wanted >> i & 1 and t.insides[row + I_TICKS]:
            is_idle = may_idle(t, i)
            if is_idle < 0:
                return -1
            left |= (1 - is_idle) << i
    return left
