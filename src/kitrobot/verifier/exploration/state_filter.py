"""A Bloom filter instead of the states, and the odds that it takes a new state for one that it has seen.

A state sets `BITS` bits in one block of 512, so one read of memory decides whether it was seen (Putze, Sanders and
Singler, *Cache-, Hash- and Space-Efficient Bloom Filters*, 2007). Besides, two bytes for each state say from which one
it was reached first: states are numbered as they are reached, so those that a state reached first follow each other,
and their number is enough (`births`); `picks` says which of its steps it was. So the way to any state can be found.

`odds_of_omission` is plain Python; the rest of this module uses only the subset that Numba compiles.
"""

from __future__ import annotations

from kitrobot.verifier.exploration.step_batches import NEW, WINDOW, note_state
from kitrobot.verifier.tables.columns import (
    ALL_BITS,
    AT,
    BASE,
    BATCH_FIRST,
    COUNT,
    CUT,
    GOES_ON,
    MOST,
    OTHER_MULTIPLIER,
    WORDS,
)
from kitrobot.verifier.tables.tables import Graph, Row, StateFilter, StepBatch, Tables

BITS = 6
"""Bits of a state."""
BLOCK = 64
"""Bytes of a block."""
SEEN = 0
"""The target of a step to a state that was seen."""
MOST_BIRTHS = 255
_SAMPLE = 4096


def block_of(h: int, blocks: int) -> int:
    """The block of a hash."""
    return (h >> 31) * blocks >> 32


def filter_steps(f: StateFilter, b: StepBatch, first: int, end: int, low: int, high: int, own: int) -> int:
    """Looks up the states after these steps whose blocks are from `low` to before `high`, and adds new ones; `own` and
    what is returned as of `step_batches.insert_steps`.
    """
    bits, blocks = f.bits, len(f.bits) // BLOCK
    mixed = 0
    for at in range(first, end, WINDOW):
        count = own
        for n in range(at, min(at + WINDOW, end)):
            block = block_of(b.places[n], blocks)
            b.own[count] = n
            count += (block >= low) & (block < high)
        for k in range(own, count):
            mixed ^= bits[block_of(b.places[b.own[k]], blocks) * BLOCK]
        for k in range(own, count):
            n = b.own[k]
            b.targets[n] = insert_hash(bits, block_of(b.places[n], blocks), b.places[n])
    return mixed


def insert_hash(bits: Row, block: int, h: int) -> int:
    """Sets the bits of a hash in its block; `SEEN` if all of them were set, else `NEW`."""
    left, target = ((h ^ h >> 32) * OTHER_MULTIPLIER & ALL_BITS) >> 9, SEEN
    for _ in range(BITS):
        spot, bit = block * BLOCK + (left >> 3 & BLOCK - 1), 1 << (left & 7)
        if bits[spot] & bit == 0:
            bits[spot] |= bit
            target = NEW
        left >>= 9
    return target


def queue_steps(t: Tables, g: Graph, b: StepBatch, f: StateFilter, until: int) -> int:
    """Numbers and queues the new states after the steps out of the states up to this one, or as many as there may be;
    why it ended, or GOES_ON.
    """
    regs, two, base, first = t.regs, t.regs[WORDS] == 2, t.regs[BASE], t.regs[BATCH_FIRST]
    at, count, code = regs[AT], regs[COUNT], GOES_ON
    while at < until and code == GOES_ON:
        begin, born = b.begins[at - first], count
        for n in range(begin, b.ends[at - first]):
            if b.targets[n] == NEW:
                if count >= regs[MOST]:
                    code = CUT
                    break
                g.x[count - base] = b.x[n]
                if two:
                    g.y[count - base] = b.y[n]
                f.picks[count] = n - begin & 255
                count += 1
        born = count - born
        f.births[at] = min(born, MOST_BIRTHS)
        if born >= MOST_BIRTHS:
            f.wide[f.counts[0]], f.wide[f.counts[0] + 1] = at, born
            f.counts[0] += 2
        note_state(t, g, b, at, at if b.calm[at - first] == 1 else -at - 1)
        at += 1
        regs[AT], regs[COUNT] = at, count
    return code


def odds_of_omission(bits: Row) -> float:
    """The odds that the next state which was not reached yet is taken for one that was: the mean over blocks of
    (share of bits that are set) ** BITS.

    Its bits and its block are those of a random function, so this is exact for what is in the filter now (Bloom 1970;
    for the states of a search: Holzmann, *An Analysis of Bitstate Hashing*, 1998). For every earlier state it was
    smaller. Of a large filter 4096 blocks are looked at.
    """
    blocks = len(bits) // BLOCK
    sample = range(0, blocks, max(1, blocks // _SAMPLE))
    shares = (
        int.from_bytes(bytes(bits[BLOCK * n : BLOCK * (n + 1)]), "little").bit_count() / (8 * BLOCK) for n in sample
    )
    return sum(share**BITS for share in shares) / len(sample)
