"""The floor of a world as SVG, to lie under a drawing: ground, colours, zones, lines, roads and walls; y goes down."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kitrobot.world.model import BRIGHT, LOUD, WARM, World

GROUND = "#eceee9"
FLOOR = {"red": "#d3202f", "green": "#1c8548", "blue": "#1d6ad4"}
ZONES = {WARM: "#c2650f", LOUD: "#7549cc", BRIGHT: "#946500"}
ROAD, WALL = "#cdd2da", "#5b6472"
WALL_MM = 8


def floor_svg(world: World) -> Iterator[str]:
    """Lines of SVG in mm, as large as the world."""
    high = world.height_mm
    yield f'  <rect width="{_number(world.width_mm)}" height="{_number(high)}" fill="{GROUND}"/>'
    for floor in world.floors:
        shape = _path(floor.line.xs, floor.line.ys, high, True)
        yield f'  <path d="{shape}" fill="{FLOOR[floor.colour]}" fill-opacity="0.5" fill-rule="evenodd"/>'
    for zone in world.zones:
        colour = f'fill="{ZONES[zone.kind]}" fill-opacity="0.15" stroke="{ZONES[zone.kind]}" stroke-width="4"'
        x, y = zone.x_mm, high - zone.y_mm
        if zone.radius_mm:
            yield f'  <circle cx="{_number(x)}" cy="{_number(y)}" r="{_number(zone.radius_mm)}" {colour}/>'
        else:
            left, top = _number(x - zone.width_mm / 2), _number(y - zone.height_mm / 2)
            size = f'width="{_number(zone.width_mm)}" height="{_number(zone.height_mm)}"'
            yield f'  <rect x="{left}" y="{top}" {size} {colour}/>'
    for line in world.lines:
        shape = _path(line.line.xs, line.line.ys, high, line.closed)
        yield f'  <path d="{shape}" stroke="{FLOOR[line.colour]}" stroke-width="{_number(line.width_mm)}"/>'
    for road in world.roads:
        shape = _path(road.line.xs, road.line.ys, high, road.closed)
        yield f'  <path d="{shape}" stroke="{ROAD}" stroke-width="{_number(road.width_mm)}"/>'
    for wall in world.walls:
        shape = _path((wall.x1_mm, wall.x2_mm), (wall.y1_mm, wall.y2_mm), high, False)
        yield f'  <path d="{shape}" stroke="{WALL}" stroke-width="{WALL_MM}"/>'


def _path(xs: Sequence[float], ys: Sequence[float], high: float, closed: bool) -> str:
    points = (
        f"{'L' if at else 'M'}{_number(x)} {_number(high - y)}" for at, (x, y) in enumerate(zip(xs, ys, strict=True))
    )
    return " ".join(points) + ("Z" if closed else "")


def _number(value: float) -> str:
    text = f"{value:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text
