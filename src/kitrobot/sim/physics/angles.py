"""Sine and cosine from additions and multiplications alone, so that every host gets the same bits.

The C library's differ between systems, and a compiler may put its own in their place. After fdlibm's kernels: the
angle less a multiple of a right angle, then two polynomials; right to about 1 in 2⁵² for angles of a few turns.
"""

from __future__ import annotations

import math

_QUARTERS = 2.0 / math.pi
_RIGHT = 1.57079632673412561417e00
_REST = 6.07710050650619224932e-11
"""A right angle in two parts, the first short enough for exact multiples."""


def direction(angle: float) -> tuple[float, float]:
    """(cosine, sine) of an angle in radians."""
    quarter = math.floor(angle * _QUARTERS + 0.5)
    x = angle - quarter * _RIGHT - quarter * _REST
    z = x * x
    sine = x + z * x * (
        -1.66666666666666324348e-01
        + z
        * (
            8.33333333332248946124e-03
            + z
            * (
                -1.98412698298579493134e-04
                + z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10))
            )
        )
    )
    cosine = 1.0 - (
        0.5 * z
        - z
        * z
        * (
            4.16666666666666019037e-02
            + z
            * (
                -1.38888888888741095749e-03
                + z
                * (
                    2.48015872894767294178e-05
                    + z
                    * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11))
                )
            )
        )
    )
    turned = quarter & 3
    if turned == 0:
        return cosine, sine
    if turned == 1:
        return -sine, cosine
    if turned == 2:
        return -cosine, -sine
    return sine, -cosine
