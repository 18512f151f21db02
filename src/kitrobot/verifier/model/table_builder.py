"""Builds the empty tables of a model: the agents, roads and devices of a mission as numbers."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from kitrobot.mission.trial import FailureKind
from kitrobot.sim.devices.base import Discrete
from kitrobot.sim.physics.docks import DOCK_AT, DOCK_REACH
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.abstraction import AgentModel
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.bodies import MOST_GAPS, TICKS, body
from kitrobot.verifier.tables.events import MOST_AT_ONCE
from kitrobot.verifier.tables.roads import Gaps, Zones, possible_everywhere
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.transitions.move_sets import P_USED, USED_PER_WORD
from kitrobot.verifier.transitions.simultaneous_ticks import MOST_TOGETHER

_TIMINGS = {Timing.LOCKSTEP: v.LOCKSTEP, Timing.PROMPT: v.PROMPT, Timing.FREE: v.FREE}
MOST_TAKEN = 65_535

_LOCKSTEP_SIZES = {
    "move_sets": 256 * v.MOVE_SET,
    "log": 256,
    "taken_slots": 131_072,
    "pool_slots": 65_536,
    "given_slots": 65_536,
    "after_heads": 1024 * v.AFTER_HEAD,
    "after_slots": 2048,
    "after": 4096 * v.AFTER,
}
"""How long the tables are that only lockstep needs."""

KINDS = {FailureKind.FAIL: v.MAY_CRASH, FailureKind.STALL: v.MAY_STALL, FailureKind.MUTE: v.MAY_MUTE}
"""The possible kinds of faults in a model, and their bits in the tables."""
USUAL_KINDS = (FailureKind.FAIL, FailureKind.STALL)


class Roads:
    """The roads with robots: the agents on each, in team order, and what they can distinguish there."""

    def __init__(self, run: Simulation, parts: Sequence[AgentModel]) -> None:
        self.numbers = sorted({part.road for part in parts if part.road >= 0})
        self.agents = [[i for i, part in enumerate(parts) if part.road == road] for road in self.numbers]
        beds = run.state.robots.ints[c.BED]
        self.beds = [[i for i in agents if beds[parts[i].agent.index]] for agents in self.agents]
        self.places = max((len(agents) for agents in self.agents), default=1)
        self.of = [self.numbers.index(part.road) if part.road >= 0 else -1 for part in parts]
        self.place = [self.agents[road].index(i) if road >= 0 else -1 for i, road in enumerate(self.of)]
        self.of_dock = [self.numbers.index(road) if road in self.numbers else -1 for road in run.state.docks.road]
        self.signs: list[list[tuple[int, ...]]] = [[] for _ in parts]
        """Of each agent what its sensors for signs read in the classes of zones."""


def check_size(parts: Sequence[AgentModel]) -> None:
    """Checks that agents and sensors are few enough for the numbers of the tables.

    Raises:
        AbstractionError: they are too many.
    """
    fits = len(parts) <= v.MOST_AGENTS
    for part in parts:
        gaps = sum(sense.discrete is Discrete.GAP for sense in part.senses)
        zones = len(part.track.zones) if part.track is not None else 1
        visits = sum(sense.discrete is Discrete.VISIT for sense in part.senses)
        fits = fits and zones << gaps <= v.MOST_VIEWS and 1 << visits <= v.MOST_VISITS
        fits = fits and (part.track is None or part.track.gaps.beyond + 1 < MOST_GAPS)
    if not fits:
        raise AbstractionError(
            Sentence("this mission has too many robots, or robots with too many sensors, to be checked"),
            Sentence("check a mission with at most {count} robots", v.MOST_AGENTS),
        )


def build(
    run: Simulation, parts: Sequence[AgentModel], roads: Roads, timing: Timing, may_fail: int, slower: int, watched: int
) -> tuple[Tables, int]:
    """Builds the empty tables, as lists; also returns the number of fields of a key.

    `watched`: 0, or 1 and how many works the team has that misses members.
    """
    docks, acts = len(run.world.docks), max((len(part.acts) for part in parts), default=0)
    fixed = _fixed(run, parts, roads, timing, acts, watched)
    fields = fixed[v.DUE_FIELD]
    fixed[v.MAY_FAIL], fixed[v.SLOWER] = may_fail, slower
    agents, geo, visits, act_rows = _static(run, parts, roads, docks, watched > 0)
    regs = [0] * v.REGS
    is_lockstep = timing is Timing.LOCKSTEP
    taken = [0] * (v.TAKEN_WIDTH * MOST_TAKEN) if is_lockstep else _single_classes(len(parts))
    regs[v.TAKEN] = 0 if is_lockstep else 1 + v.TAKEN_WIDTH * len(parts)
    pool = (MOST_AT_ONCE + 2) * fixed[v.POOL_WIDTH] if is_lockstep else 1
    lines = (MOST_AT_ONCE if is_lockstep or may_fail else 4 * v.MOST_AGENTS + 4 * acts * roads.places) * v.LINE
    road_agents = [agents_[k] if k < len(agents_) else -1 for agents_ in roads.agents for k in range(roads.places)]
    tables = Tables(
        regs=regs,
        fixed=fixed,
        shift=[0] * (fields + 1),
        mask=[0] * (fields + 1),
        word=[0] * (fields + 1),
        agents=agents,
        geo=geo or [0],
        visits=visits or [0] * v.VISIT,
        acts=act_rows or [0] * v.ACT,
        road_agents=road_agents or [-1],
        insides=[-1] * (len(parts) * fixed[v.INSIDE_STRIDE] * fixed[v.INSIDE_WIDTH]),
        shared=[0] * (16 * fixed[v.SHARED_WIDTH]),
        change_keys=[-1] * 64,
        change_to=[0] * 64,
        reaction_keys=[-1] * 256,
        reaction_at=[0] * 256,
        outcomes=[0] * (64 * v.OUTCOME),
        confs=[0] * (64 * fixed[v.CONF_WIDTH]),
        conf_slots=[0] * 256,
        moves=[0] * (256 * v.MOVE),
        taken=taken,
        made=[0] * roads.places,
        now=[0] * (fields + 3),
        seen=[0] * (3 * len(parts) + 2 * len(roads.numbers) + 1),
        pool=[0] * pool,
        line=[0] * lines,
        faults=[0] * lines,
        **{name: [0] * (size if is_lockstep else 1) for name, size in _LOCKSTEP_SIZES.items()},
        next_x=[0] * 1024,
        next_y=[0] * 1024,
        next_taken=[0] * 1024,
        next_kinds=[0] * 1024,
        next_slots=[0] * 4096,
        next_event=[0] * 1024,
        events=[0] * 1024,
    )
    return tables, fields


def _fixed(
    run: Simulation, parts: Sequence[AgentModel], roads: Roads, timing: Timing, acts: int, watched: int
) -> list[int]:
    """The sizes of the tables, without those of faults. `acts`: how many actions an agent has at most."""
    docks, houses = len(run.world.docks), len(run.world.storehouses)
    fields = 1 + len(parts) + len(roads.numbers)
    fixed = [0] * v.FIXED
    fixed[v.AGENTS], fixed[v.ROADS], fixed[v.PLACES] = len(parts), len(roads.numbers), roads.places
    fixed[v.DOCKS], fixed[v.HOUSES], fixed[v.TIMING], fixed[v.ACTS] = docks, houses, _TIMINGS[timing], acts
    fixed[v.FIELDS], fixed[v.ROAD_FIELD] = fields + (timing is Timing.PROMPT), 1 + len(parts)
    fixed[v.DUE_FIELD] = fields
    fixed[v.INSIDE_WIDTH], fixed[v.INSIDE_STRIDE] = v.I_ACT + 2 * acts, 16
    fixed[v.CONF_WIDTH] = v.C_STAND + docks + 10 * roads.places
    fixed[v.WATCHED] = watched
    fixed[v.SHARED_WIDTH] = v.G_STOCK + houses + len(parts) + (v.G_HOLDING + watched - 1 if watched else 0)
    gaps = max((part.track.gaps.beyond for part in parts if part.track is not None), default=0)
    fixed[v.USED_BITS] = 2 + 2 * (gaps + 2)
    fixed[v.POOL_WIDTH] = P_USED + -(-roads.places * fixed[v.USED_BITS] // USED_PER_WORD)
    fixed[v.SETTLES] = int(run.team_plan is not None)
    return fixed


def _single_classes(agents: int) -> list[int]:
    """`taken` without lockstep: a row for each progress class of each agent, and room for ticks at the same time."""
    taken = [0] * (v.TAKEN_WIDTH * (1 + v.TAKEN_WIDTH * v.MOST_AGENTS + MOST_TOGETHER))
    for q in range(v.TAKEN_WIDTH):
        for i in range(agents):
            taken[(1 + q * agents + i) * v.TAKEN_WIDTH + q] = 1 << i
    return taken


def first_body(part: AgentModel, parts: Sequence[AgentModel], at: Sequence[float]) -> int:
    """How an agent on a road moves before the first step; `at`: where each is on its road, in mm."""
    assert part.track is not None
    zones, gaps, here = part.track.zones, part.track.gaps, at[part.agent.index]
    zone, gap = zones.zone_at(here), gaps.beyond
    if part.leader >= 0:
        ahead = at[parts[part.leader].agent.index]
        way = ahead - here + (zones.length_mm if ahead < here else 0)
        is_around = ahead < here and zones.zone_at(ahead) == zone
        gap = gaps.beyond + 1 if is_around else gaps.class_of(way - gaps.lengths_mm)
    return body(0, 0, zone, gap, TICKS)


def _static(
    run: Simulation, parts: Sequence[AgentModel], roads: Roads, docks: int, is_watched: bool
) -> tuple[list[int], list[int], list[int], list[int]]:
    """`agents`, `geo`, `visits` and `acts`."""
    agents: list[int] = []
    geo: list[int] = []
    visits: list[int] = []
    acts: list[int] = []
    capacity = [int(one) for one in run.state.docks.capacity]
    known: dict[Any, int] = {}
    for i, part in enumerate(parts):
        row = [0] * v.AGENT
        row[v.A_ROAD], row[v.A_PLACE] = roads.of[i], roads.place[i]
        row[v.A_LEADER] = roads.place[part.leader] if part.leader >= 0 else -1
        row[v.A_FOLLOWER] = roads.place[part.follower] if part.follower >= 0 else -1
        row[v.A_LATE], row[v.A_BED] = int(part.is_late), int(bool(run.state.robots.ints[c.BED][part.agent.index]))
        is_heard = bool(part.shared) or (is_watched and part.is_member)
        row[v.A_SHARES] = v.KEPT if part.is_observed else v.SHARED if is_heard else v.UNSHARED
        row[v.A_VISIT] = len(visits) // v.VISIT
        for sense in part.senses:
            if sense.discrete is Discrete.VISIT:
                visits += [sense.dock, roads.of_dock[sense.dock], sense.load]
                row[v.A_VISITS] += 1
        row[v.A_ACT], row[v.A_ACTS] = len(acts) // v.ACT, len(part.acts)
        for act in part.acts:
            store = max(act.store, 0)
            road = roads.of_dock[act.dock] if act.is_arm and act.dock >= 0 else -1
            acts += [int(act.is_arm), act.dock, store, road, capacity[store] if act.is_arm else 0]
        if part.track is not None:
            behind = parts[part.follower] if part.follower >= 0 else None
            _place_track(row, geo, part, behind, roads.signs[i], run, docks, known)
        agents += row
    return agents, geo, visits, acts


def _place_track(
    row: list[int],
    geo: list[int],
    part: AgentModel,
    follower: AgentModel | None,
    signs_read: list[tuple[int, ...]],
    run: Simulation,
    docks: int,
    known: dict[Any, int],
) -> None:
    """Puts an agent's road into its row, and its numbers behind `geo`; new combinations of signs go to `signs_read`."""
    track = part.track
    assert track is not None
    zones, gaps = track.zones, track.gaps
    row[v.A_ZONES], row[v.A_CLOSED], row[v.A_BEYOND] = len(zones), int(zones.closed), gaps.beyond
    row[v.A_ZONE_AT] = len(geo)
    signs = [sense.signs for sense in part.senses if sense.discrete is Discrete.SECTION]
    for zone in range(len(zones)):
        read = tuple(one[zone] for one in signs)
        if read not in signs_read:
            signs_read.append(read)
        size = zones.size(zone)
        geo += [int(size > track.tick_mm), int(size > track.braking_mm), signs_read.index(read)]
        geo += [int(_is_in(run, zones, zone, dock, part.road)) for dock in range(docks)]
    row[v.A_GAP_AT] = len(geo)
    for gap in range(gaps.beyond + 2):
        low, high = gaps.limits(gap) if gap <= gaps.beyond else (0.0, float("inf"))
        geo += [int(high - low > track.tick_mm), int(high - low > track.braking_mm)]
    if (zones, gaps) not in known:
        known[zones, gaps] = len(geo)
        geo += [int(one) for one in possible_everywhere(zones, gaps)]
    row[v.A_CAN_AT] = known[zones, gaps]
    row[v.A_SENSES_AT] = len(geo)
    behind = None if follower is None else follower.track
    for sense in part.senses:
        if sense.discrete is Discrete.GAP:
            row[v.A_SENSES] += 1
            geo += _reaches(gaps, sense.reach_mm)
            geo += _reaches(behind.gaps, sense.reach_mm) if behind is not None else []


def _reaches(gaps: Gaps, reach_mm: float) -> list[int]:
    """Of each class of gap, and the one with a lap between, whether a sensor notices a robot there."""
    return [int(gaps.reached(gap, reach_mm)) for gap in range(gaps.beyond + 1)] + [0]


@lru_cache(10_000)
def _nearest(zones: Zones, zone: int, middle: float) -> float:
    begin, end = zones.ends(zone)
    away = abs((begin + end) / 2 - middle)
    return min(away, zones.length_mm - away) if zones.closed else away


def _is_in(run: Simulation, zones: Zones, zone: int, dock: int, road: int) -> bool:
    """Whether a zone of a road is one of a dock."""
    docks = run.state.docks
    middle, reach = docks.floats[DOCK_AT][dock], docks.floats[DOCK_REACH][dock]
    return bool(docks.road[dock] == road and _nearest(zones, zone, middle) <= reach)
