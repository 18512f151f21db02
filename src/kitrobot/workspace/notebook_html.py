"""Missions and runs as HTML, for notebooks: a picture of the world from above, and what there is to say in a table.

All that comes from files is escaped.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from html import escape

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives.robot import Robot
from kitrobot.sim.setup.settings import length_of
from kitrobot.sim.simulation import Simulation
from kitrobot.trace.drawing import Stroke
from kitrobot.trace.drawing_svg import stroke_svg
from kitrobot.world.floor_svg import floor_svg
from kitrobot.world.model import World

WIDTH_PX = 420
LINE_PX = 2
"""Lines of pens are at least so wide."""

MOST_ROBOTS = 200
"""So many are drawn."""

USUAL_MM = 60.0
"""Of a robot without wheels."""

MOST_PROBLEMS = 10
"""So many are shown."""

BODY = "#e07a1f"
INK = "#1b1f27"


@dataclass(frozen=True)
class WorldMoment:
    """A world with its robots at one moment.

    Attributes:
        world: where they are.
        robots: the first of them, each with its name.
        poses: x and y in mm and the heading in radians of each.
    """

    world: World
    robots: tuple[tuple[str, Robot], ...]
    poses: tuple[tuple[float, float, float], ...]


def moment_of(run: Simulation) -> WorldMoment:
    """The world of a run as it is now."""
    members = run.members[:MOST_ROBOTS]
    poses = tuple((x, y, heading) for x, y, heading, *_ in run.poses()[:MOST_ROBOTS])
    return WorldMoment(run.world, tuple((one.name, one.robot) for one in members), poses)


def world_html(moment: WorldMoment, strokes: Iterable[Stroke] = ()) -> str:
    """The world from above, with what pens drew and the robots on it."""
    world = moment.world
    least_mm = math.ceil(LINE_PX * world.width_mm / WIDTH_PX)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH_PX}" role="img" '
        f'aria-label="{escape(world.name)}, from above" viewBox="0 0 {world.width_mm:g} {world.height_mm:g}" '
        'fill="none" stroke-linecap="round" stroke-linejoin="round">',
        *floor_svg(world),
        *(stroke_svg(replace(one, width_mm=max(one.width_mm, least_mm)), world.height_mm) for one in strokes),
        *(
            _body(name, robot, pose, world.height_mm)
            for (name, robot), pose in zip(moment.robots, moment.poses, strict=True)
        ),
        "</svg>",
    ]
    return "\n".join(lines)


def table_html(caption: str, rows: Iterable[tuple[str, str]]) -> str:
    """Names with what is said of each; rows without words are left out."""
    lines = (f"<tr><th>{escape(name)}</th><td>{escape(words)}</td></tr>" for name, words in rows if words)
    return f"<table><caption>{escape(caption)}</caption>{''.join(lines)}</table>"


def mission_html(
    name: str,
    programs: Sequence[tuple[str, str]],
    problems: Sequence[Diagnostic],
    simulation: Callable[[], Simulation] | None,
) -> str:
    """A mission: what is said of its programs, its mistakes, and its world where it can be set up."""
    picture = "" if simulation is None else world_html(moment_of(simulation()))
    said = [(str(one.severity.value), str(one.message)) for one in problems[:MOST_PROBLEMS]]
    return f"<figure>{picture}{table_html(name, [*programs, *said])}</figure>"


def _body(name: str, robot: Robot, pose: tuple[float, float, float], height_mm: float) -> str:
    """A disc with its front, and its name for a pointer that rests on it."""
    x, y, heading = pose
    half = (length_of(robot) or USUAL_MM) / 2
    return (
        f'  <g transform="translate({x:.1f} {height_mm - y:.1f}) rotate({-math.degrees(heading):.1f})">'
        f"<title>{escape(name)}</title>"
        f'<circle r="{half:.1f}" fill="{BODY}" stroke="{INK}" stroke-width="{half / 8:.1f}"/>'
        f'<path d="M0 0H{half:.1f}" stroke="{INK}" stroke-width="{half / 6:.1f}"/></g>'
    )
