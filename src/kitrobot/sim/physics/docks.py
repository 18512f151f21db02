"""Who stands in a dock."""

from __future__ import annotations

from kitrobot.sim.tables.columns import AT, CLOSED, ROAD, SPEED
from kitrobot.sim.tables.state import Docks, Roads, Robots

# The rows of `docks.floats`: mm along its road, and how far from there a carrier may stand.
DOCK_AT, DOCK_REACH = range(2)


def carrier_in(dock: int, robots: Robots, roads: Roads, docks: Docks) -> int:
    """The robot with a bed that stands still in the dock, or -1; the nearest when there are several."""
    road = docks.road[dock]
    middle = docks.floats[DOCK_AT][dock]
    best = docks.floats[DOCK_REACH][dock]
    closed = roads.ints[CLOSED]
    floats = robots.floats
    at = floats[AT]
    speed = floats[SPEED]
    on_road = robots.ints[ROAD]
    carriers = robots.carriers
    found = -1
    for k in range(len(carriers)):
        i = carriers[k]
        if speed[i] != 0.0 or on_road[i] != road:
            continue
        distance = abs(at[i] - middle)
        if closed[road] and roads.length[road] - distance < distance:
            distance = roads.length[road] - distance
        if distance <= best and (found < 0 or distance < best):
            best = distance
            found = i
    return found
