"""Who stands in a dock."""

from __future__ import annotations

from kitrobot.sim.columns import AT, ROAD, SPEED

# The rows of `docks`: mm along its road, and how far from there a carrier may stand.
DOCK_AT, DOCK_REACH = range(2)


def carrier_in(
    dock: int,
    real: list[list[float]],
    whole: list[list[int]],
    carriers: list[int],
    docks: list[list[float]],
    dock_road: list[int],
    road_length: list[float],
    closed: list[int],
) -> int:
    """The robot with a bed that stands still in the dock, or -1; the nearest when there are several."""
    road = dock_road[dock]
    middle = docks[DOCK_AT][dock]
    best = docks[DOCK_REACH][dock]
    at = real[AT]
    speed = real[SPEED]
    roads = whole[ROAD]
    found = -1
    for k in range(len(carriers)):
        i = carriers[k]
        if speed[i] != 0.0 or roads[i] != road:
            continue
        distance = abs(at[i] - middle)
        if closed[road] and road_length[road] - distance < distance:
            distance = road_length[road] - distance
        if distance <= best and (found < 0 or distance < best):
            best = distance
            found = i
    return found
