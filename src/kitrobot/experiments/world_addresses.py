"""The addresses of a world: the numbers of its parts, by name (`storehouse.A.stock`) or by place (`wall.1.x1`)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import fields, replace
from typing import Any, get_args, get_type_hints

from annotated_types import Ge, Le

from kitrobot.experiments.addresses import Address, Put
from kitrobot.experiments.variant import Value, Variant
from kitrobot.world.limits import MAX_SIZE_MM
from kitrobot.world.model import World

_KINDS = {
    "storehouse": "storehouses",
    "dock": "docks",
    "road": "roads",
    "start": "starts",
    "wall": "walls",
    "line": "lines",
    "box": "boxes",
    "ball": "balls",
    "zone": "zones",
}
"""A word for a part, and the field of the world that holds all of its kind."""
_UNIT = re.compile(r"_(mm|g|rad)$")


def world_addresses(world: World) -> Iterator[Address]:
    """All numbers of a world that can vary."""
    for word, field in _KINDS.items():
        for at, part in enumerate(getattr(world, field)):
            name = getattr(part, "name", str(at + 1))
            for attribute, least, most, whole, unit in _numbers(type(part)):
                if word == "start" and not part.road:
                    continue  # Only on a road is a start so many mm along.
                current = getattr(part, attribute)
                put = _put_part(field, at, attribute)
                yield Address(f"{word}.{name}.{_UNIT.sub('', attribute)}", current, put, least, most, whole, unit=unit)
            if word == "start" and part.pose is not None:
                pose = part.pose
                for attribute, now in (("x_mm", pose.x_mm), ("y_mm", pose.y_mm)):
                    put = _put_pose(at, attribute, 1.0)
                    short = _UNIT.sub("", attribute)
                    yield Address(f"start.{name}.{short}", now, put, -MAX_SIZE_MM, MAX_SIZE_MM, unit="mm")
                heading = round(math.degrees(pose.heading_rad), 3)
                put = _put_pose(at, "heading_rad", math.pi / 180)
                yield Address(f"start.{name}.heading", heading, put, -360, 360, unit="°")
    for attribute in ("width_mm", "height_mm"):
        current = getattr(world, attribute)
        put = _put_size(attribute)
        yield Address(f"world.{_UNIT.sub('', attribute)}", current, put, 1, MAX_SIZE_MM, unit="mm")


def _numbers(kind: type[Any]) -> tuple[tuple[str, float, float, bool, str], ...]:
    """Of each field of a part that is a number: its name, least and most, whether it is whole, and its unit."""
    hints = get_type_hints(kind, include_extras=True)
    found = []
    for field in fields(kind):
        hint = hints[field.name]
        base, *limits = get_args(hint) or (hint,)
        if base in (int, float):
            least = next((one.ge for one in limits if isinstance(one, Ge)), -MAX_SIZE_MM)
            most = next((one.le for one in limits if isinstance(one, Le)), MAX_SIZE_MM)
            unit = _UNIT.search(field.name)
            found.append((field.name, float(least), float(most), base is int, unit[1] if unit else ""))  # type: ignore[arg-type]
    return tuple(found)


def _put_part(field: str, at: int, attribute: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        parts = list(getattr(variant.world, field))
        parts[at] = replace(parts[at], **{attribute: value})
        changed: dict[str, Any] = {field: tuple(parts)}
        variant.world = replace(variant.world, **changed)

    return put


def _put_pose(at: int, attribute: str, factor: float) -> Put:
    def put(variant: Variant, value: Value) -> None:
        starts = list(variant.world.starts)
        pose = starts[at].pose
        assert pose is not None, "it has an address"
        starts[at] = replace(starts[at], pose=replace(pose, **{attribute: factor * float(value)}))
        variant.world = replace(variant.world, starts=tuple(starts))

    return put


def _put_size(attribute: str) -> Put:
    def put(variant: Variant, value: Value) -> None:
        variant.world = replace(variant.world, **{attribute: float(value)})  # type: ignore[arg-type]

    return put
