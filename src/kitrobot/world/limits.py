"""The numbers and words of a world as types that say their limits; lengths are in mm."""

from __future__ import annotations

from typing import Annotated, Literal

from annotated_types import Ge, Le

MAX_SIZE_MM = 1_000_000.0
"""A kilometre; worlds are table tops and halls."""

MAX_NUMBER = 65535
"""The largest sign, stock or capacity: what the language can write."""

MOST_PARTS = 20_000
"""Parts of one kind, and corners of one part, that a page may send."""

Coordinate = Annotated[float, Ge(-MAX_SIZE_MM), Le(MAX_SIZE_MM)]
Length = Annotated[float, Ge(0), Le(MAX_SIZE_MM)]
Count = Annotated[int, Ge(0), Le(MAX_NUMBER)]
Percent = Annotated[float, Ge(0), Le(100)]

FloorColour = Literal["red", "green", "blue"]
ZoneKind = Literal["warm", "loud", "bright"]
"""What sensors feel in a zone."""
DockKind = Literal["load", "unload"]
Side = Literal["left", "right"]
