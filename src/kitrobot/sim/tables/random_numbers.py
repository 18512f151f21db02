"""Chance from a seed, by counting: the n-th number of a device is a function of its two keys and of n.

So chance has no state beyond a count, a snapshot is a copy, and devices never disturb one another. Only whole numbers
below 2⁶³ are multiplied, so CPython and Numba compute the very same.
"""

from __future__ import annotations

import hashlib

MASK = 0xFFFFFFFF


def keys(*names: object) -> tuple[int, int]:
    """The two keys of a device, from the run's seed and the names that lead to it."""
    digest = hashlib.sha256("/".join(map(str, names)).encode()).digest()
    return int.from_bytes(digest[:4], "little"), int.from_bytes(digest[4:8], "little")


def scrambled(x: int) -> int:
    """A 32-bit number turned into another, one to one, so that neighbours have nothing in common (after C. Wellons)."""
    x ^= x >> 16
    x = (x * 0x21F0AAAD) & MASK
    x ^= x >> 15
    x = (x * 0x735A2D97) & MASK
    return x ^ (x >> 15)


def drawn(key_a: int, key_b: int, number: int) -> int:
    """The draw of that number: 32 bits."""
    return scrambled(scrambled((number + key_a) & MASK) ^ key_b)


def happens(key_a: int, key_b: int, number: int, probability: float) -> bool:
    """Whether something of this probability (0…1) happens in the draw of that number."""
    return drawn(key_a, key_b, number) < probability * 4294967296.0


def gauss(key_a: int, key_b: int, number: int) -> float:
    """A normal deviate (mean 0, standard deviation 1) out of three draws: twelve bytes added up, at most ±6."""
    total = 0
    for k in range(3):
        x = drawn(key_a, key_b, number + k)
        total += (x & 255) + ((x >> 8) & 255) + ((x >> 16) & 255) + (x >> 24)
    return (total - 1530) / 256.0
