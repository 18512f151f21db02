"""Points of a unit cube for designs of several axes: Latin hypercube, Sobol sequence, random.

All chance comes from a text, so the same text gives the same points on every machine and version of Python. Sources:
M. D. McKay et al., Technometrics 21 (1979), for Latin hypercubes; S. Joe and F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008)
for the direction numbers of the Sobol sequence (`new-joe-kuo-6`).
"""

from __future__ import annotations

from random import Random

_JOE_KUO = (
    (1, 0, (1,)),
    (2, 1, (1, 3)),
    (3, 1, (1, 3, 1)),
    (3, 2, (1, 1, 1)),
    (4, 1, (1, 1, 3, 3)),
    (4, 4, (1, 3, 5, 13)),
    (5, 2, (1, 1, 5, 5, 17)),
    (5, 4, (1, 1, 5, 5, 5)),
    (5, 7, (1, 1, 7, 11, 19)),
)
"""Degree, coefficients and first numbers of the primitive polynomials of the dimensions from the second on."""
MOST_DIMENSIONS = 1 + len(_JOE_KUO)
"""Axes of a Sobol sequence at most."""
_BITS = 32

Points = list[list[float]]
"""n rows of d numbers from 0 up to, not including, 1."""


def latin_hypercube(count: int, dimensions: int, chance: str) -> Points:
    """Points of which each n-th part of each axis holds exactly one."""
    columns = []
    for axis in range(dimensions):
        random = Random(f"{chance}/{axis}")
        order = sorted(range(count), key=[random.random() for _ in range(count)].__getitem__)
        columns.append([(part + random.random()) / count for part in order])
    return [list(row) for row in zip(*columns, strict=True)]


def random_points(count: int, dimensions: int, chance: str) -> Points:
    """Points that have nothing to do with each other."""
    random = Random(chance)
    return [[random.random() for _ in range(dimensions)] for _ in range(count)]


def sobol(count: int, dimensions: int) -> Points:
    """The first points of the Sobol sequence, at most `MOST_DIMENSIONS` wide; the first one is the origin."""
    directions = [_directions(axis) for axis in range(dimensions)]
    x = [0] * dimensions
    points = []
    for number in range(count):
        points.append([one / 2**_BITS for one in x])
        flipped = ((number + 1) & -(number + 1)).bit_length() - 1
        x = [one ^ directions[axis][flipped] for axis, one in enumerate(x)]
    return points


def _directions(axis: int) -> list[int]:
    if axis == 0:
        return [1 << (_BITS - 1 - bit) for bit in range(_BITS)]
    degree, coefficients, first = _JOE_KUO[axis - 1]
    found = [number << (_BITS - 1 - bit) for bit, number in enumerate(first)]
    for bit in range(degree, _BITS):
        made = found[bit - degree] ^ (found[bit - degree] >> degree)
        for k in range(1, degree):
            if coefficients >> (degree - 1 - k) & 1:
                made ^= found[bit - k]
        found.append(made)
    return found
