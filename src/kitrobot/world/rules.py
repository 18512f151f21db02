"""The rules of worlds: what can be wrong with one beyond its XML."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

LINE = rule(
    "world-line",
    Severity.ERROR,
    "A road, line or floor cannot be drawn",
    "A floor is a rectangle, or has three points or more. A line needs two different points, a closed one three. A "
    "point's `radius` rounds its corner off and takes room from the stretches on both sides; where two roundings meet "
    "they must fit.",
)
SECTIONS = rule(
    "world-sections",
    Severity.ERROR,
    "Sections do not cover their road",
    "The sections of a road follow one another from 0 to its end, each beginning where the one before ends, without "
    "gap or overlap, so that a carrier reads exactly one sign wherever it is. The last one may leave out `to`.",
)
DOCK = rule(
    "world-dock",
    Severity.ERROR,
    "A dock is not on its road",
    "`at` says how many mm along its road a dock lies, from 0 to the road's length.",
)
UNKNOWN = rule(
    "world-unknown-name",
    Severity.ERROR,
    "A name stands for nothing",
    "Docks name their road and storehouse, starts name a road, a dock or a storehouse; each must be in the same file.",
)
STOREHOUSE = rule(
    "world-storehouse",
    Severity.ERROR,
    "A storehouse holds more than it can",
    "`stock` is at most `capacity`.",
)
START = rule(
    "world-start",
    Severity.ERROR,
    "Nobody can start there",
    "A start says one of: `road` and `at`, `dock`, `storehouse`, or `x` and `y` (with `heading` in degrees, counter-"
    "clockwise, 0 to the right). It lies in the world and not in a wall.",
)
ZONE = rule(
    "world-zone",
    Severity.ERROR,
    "A zone has no shape, or there are too many",
    "A zone is a circle with a `radius`, or a rectangle with `width` and `height`, around its middle `x`, `y`. A world "
    "has at most 200 of them.",
)
OUTSIDE = rule(
    "world-outside",
    Severity.ERROR,
    "Something lies outside the world",
    "Everything lies between 0 and the world's `width` and `height`.",
)
