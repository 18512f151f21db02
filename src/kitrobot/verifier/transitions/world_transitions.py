"""Transitions of the world: completed actions (arms, procedures that take longer) and faults of agents.

This module uses only the subset of Python that Numba compiles; -1 means the same as in `interleaved_successors`.
"""

from __future__ import annotations

from kitrobot.verifier.tables.bodies import FAILED, RUNS, STALLED
from kitrobot.verifier.tables.columns import (
    A_ACT,
    A_ACTS,
    A_PLACE,
    A_ROAD,
    A_SHARES,
    ACT,
    AGENT,
    C_STAND,
    CODE,
    CONF_WIDTH,
    E_AGENT,
    E_OTHER,
    FIELDS,
    G_FAILURES,
    G_STOCK,
    HOUSES,
    I_ACT,
    I_BEFALLEN,
    I_DOWN,
    I_ENDED,
    I_LOADED,
    I_MUTED,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    KEPT,
    LINE,
    MAY_CRASH,
    MAY_FAIL,
    MAY_MUTE,
    MAY_STALL,
    MISS_A,
    MISS_B,
    MISS_DONE,
    MISS_DOWN,
    MISS_LOADED,
    ROAD_FIELD,
    SHARED_WIDTH,
    TOO_MANY,
    UNSHARED,
)
from kitrobot.verifier.tables.events import (
    DONE,
    FAIL,
    LOADED,
    MUTE,
    NO_BOX,
    NO_EMPTY_CARRIER,
    NO_LOADED_CARRIER,
    RESUME,
    STALL,
    UNLOADED,
)
from kitrobot.verifier.tables.state_decoding import find_silenced, look_up_change, with_field
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.tables.traffic import conf_after_fault

RESUMES, CRASHES, STALLS, MUTES = range(4)
FAULT_KINDS = 4
"""How many kinds of faults an agent can have, in the order in which `write_faults` writes them."""


def write_completions(t: Tables, x: int, y: int, i: int, first: int) -> int:
    """Writes the possible completions of agent i in the state of `now` into rows of `line`; returns how many."""
    fixed, now = t.fixed, t.now
    row = (i * fixed[INSIDE_STRIDE] + now[1 + i]) * fixed[INSIDE_WIDTH] + I_ACT
    found = 0
    for n in range(t.agents[i * AGENT + A_ACTS]):
        if t.insides[row + 2 * n] == 0:
            continue
        if t.insides[row + 2 * n + 1] < 0:
            t.regs[CODE], t.regs[MISS_A], t.regs[MISS_B] = MISS_DONE, i, n
            return -1
        act = (t.agents[i * AGENT + A_ACT] + n) * ACT
        carriers = 0
        if t.acts[act] and t.acts[act + 3] >= 0:
            dock_row = now[fixed[ROAD_FIELD] + t.acts[act + 3]] * fixed[CONF_WIDTH]
            carriers = t.confs[dock_row + C_STAND + t.acts[act + 1]]
        carrier = -1
        while True:
            if carriers:
                carrier += 1
                while not carriers >> carrier & 1:
                    carrier += 1
                carriers &= ~(1 << carrier)
            written = write_completion(t, x, y, i, n, carrier, first + found)
            if written < 0:
                return -1
            found += written
            if not carriers:
                break
    return found


def write_completion(t: Tables, x: int, y: int, i: int, n: int, carrier: int, at: int) -> int:
    """Writes the completion of action n of agent i, of an arm at a carrier (-1: none), into a row of `line`.

    It returns 1; 0 if it cannot be completed there.
    """
    fixed, now, insides = t.fixed, t.now, t.insides
    stride, width = fixed[INSIDE_STRIDE], fixed[INSIDE_WIDTH]
    row = (i * stride + now[1 + i]) * width + I_ACT + 2 * n
    act = (t.agents[i * AGENT + A_ACT] + n) * ACT
    loads, done = insides[row] == 1, insides[row + 1]
    event, to, write = DONE | i << E_AGENT, -1, 0
    if t.acts[act]:
        stock = t.shared[now[0] * fixed[SHARED_WIDTH] + G_STOCK + t.acts[act + 2]]
        if carrier < 0 or (now[fixed[FIELDS]] >> carrier & 1 == 1) == loads:
            what = NO_EMPTY_CARRIER if loads else NO_LOADED_CARRIER
            event = what | i << E_AGENT | t.acts[act + 1] + 1 << E_OTHER
        elif loads and stock == 0:
            event = NO_BOX | i << E_AGENT | t.acts[act + 2] + 1 << E_OTHER
        elif loads or stock < t.acts[act + 4]:
            event = (LOADED if loads else UNLOADED) | i << E_AGENT | carrier + 1 << E_OTHER
            to = insides[(carrier * stride + now[1 + carrier]) * width + I_LOADED]
            if to < 0:
                t.regs[CODE], t.regs[MISS_A] = MISS_LOADED, carrier
                return -1
            write = 1 + 2 * t.acts[act + 2] + (0 if loads else 1)
        else:
            return 0
    if (at + 1) * LINE > len(t.line):
        t.regs[CODE] = TOO_MANY
        return -1
    if carrier != i or to < 0:
        x, y = with_field(t, 1 + i, now[1 + i], done, x, y)
    if to >= 0:
        x, y = with_field(t, 1 + carrier, now[1 + carrier], to, x, y)
    if write:
        after = look_up_change(t, now[0], write)
        if after < 0:
            return -1
        x ^= (now[0] ^ after) << t.shift[0]
    put = at * LINE
    t.line[put], t.line[put + 1], t.line[put + 2], t.line[put + 3] = x, y, event, -1
    return 1


def write_faults(t: Tables, x: int, y: int, i: int, first: int, since: int) -> int:
    """Writes the possible faults of agent i in the state of `now` into rows of `faults`; returns how many.

    Only the kinds from `since` on are written.
    """
    fixed, now, insides = t.fixed, t.now, t.insides
    row = (i * fixed[INSIDE_STRIDE] + now[1 + i]) * fixed[INSIDE_WIDTH]
    down = insides[row + I_DOWN]
    left = t.shared[now[0] * fixed[SHARED_WIDTH] + G_FAILURES]
    kinds = fixed[MAY_FAIL] if left > 0 and down != FAILED and not insides[row + I_ENDED] else 0
    shares = t.agents[i * AGENT + A_SHARES]
    found = 0
    for n in range(since, FAULT_KINDS):
        if n == 0:
            to, event, may = RUNS, RESUME, down == STALLED
        elif n == 1:
            to, event, may = FAILED, FAIL, kinds & MAY_CRASH != 0
        elif n == 2:
            to, event, may = STALLED, STALL, kinds & MAY_STALL != 0 and down == RUNS
        else:
            to, event = down, MUTE
            may = kinds & MAY_MUTE != 0 and shares != UNSHARED and insides[row + I_MUTED] == 0
        if not may:
            continue
        if (first + found + 1) * LINE > len(t.faults):
            t.regs[CODE] = TOO_MANY
            return -1
        is_silenced = event == MUTE or (event == FAIL and shares == KEPT and insides[row + I_MUTED] == 0)
        inside = find_silenced(t, i, int(event == FAIL)) if is_silenced else insides[row + I_BEFALLEN + to]
        if inside < 0 and is_silenced:
            return -1
        if inside < 0:
            t.regs[CODE], t.regs[MISS_A], t.regs[MISS_B] = MISS_DOWN, i, to
            return -1
        nx, ny = with_field(t, 1 + i, now[1 + i], inside, x, y)
        if n > 0:
            after = look_up_change(t, now[0], 1 + 2 * fixed[HOUSES])
            if after < 0:
                return -1
            nx ^= (now[0] ^ after) << t.shift[0]
        road = t.agents[i * AGENT + A_ROAD]
        if road >= 0 and event != MUTE:
            f = fixed[ROAD_FIELD] + road
            conf = conf_after_fault(t, now[f], t.agents[i * AGENT + A_PLACE], to)
            if conf < 0:
                return -1
            nx, ny = with_field(t, f, now[f], conf, nx, ny)
        at = (first + found) * LINE
        t.faults[at], t.faults[at + 1], t.faults[at + 2], t.faults[at + 3] = nx, ny, event | i << E_AGENT, -1
        found += 1
    return found
