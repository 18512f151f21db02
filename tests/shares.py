"""The order in which pytest-xdist's workers get the tests: long ones first, so that none is alone at the end.

With `--dist worksteal` each worker gets an equal number of tests that follow each other; one that has none left takes
the last ones of another. In the order of their names, the tests with a browser came at the end: three workers had
nothing to do while the fourth went through the last of them.
"""

from __future__ import annotations

from typing import TypeVar

Test = TypeVar("Test")


def in_shares(long: list[Test], short: list[Test], workers: int) -> list[Test]:
    """All tests, in shares of equal number, of which each begins with its part of the long ones.

    Args:
        long: those that take seconds.
        short: the others.
        workers: how many shares; both lists are shared out in their order.
    """
    ordered: list[Test] = []
    count, begun, filled = len(long) + len(short), 0, 0
    for left in range(workers, 0, -1):
        size = (count - len(ordered)) // left
        first = min((len(long) - begun) // left, size)
        ordered += long[begun : begun + first] + short[filled : filled + size - first]
        begun, filled = begun + first, filled + size - first
    return ordered
