"""All robots on one road: a number for how they move, and what can happen to them next."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence

from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model.abstraction import AgentModel
from kitrobot.verifier.tables.roads import PRESSED
from tests.verifier.reference.bodies import FAILED, RUNS, Body
from tests.verifier.reference.events import MOST_AT_ONCE, Event, ModelTooLargeError, progress
from tests.verifier.reference.motion import Move, around_of, moves

_ONCE = {Move.BEGIN: 1, Move.HALT: 1, Move.ZONE: 2}
"""What a robot does once at most in a moment: moves of one number exclude each other. It comes once to each gap."""
_Moment = tuple[tuple[Event, ...], int, int]
"""What happens to the robots of a road between two ticks: events in order, their progress classes, the number after."""
_Own = tuple[int, object]
"""An agent, and what it did of what it does once."""


class Traffic:
    """The robots on one road.

    Args:
        run: the run, before its first step.
        parts: all agents.
        road: the number of the road.
    """

    def __init__(self, run: Simulation, parts: Sequence[AgentModel], road: int) -> None:
        self.agents = [i for i, part in enumerate(parts) if part.road == road]
        self.parts = parts
        self._place = {i: place for place, i in enumerate(self.agents)}
        self._known: list[tuple[Body, ...]] = []
        self._numbers: dict[tuple[Body, ...], int] = {}
        self._moves: dict[int, tuple[tuple[Event, int], ...]] = {}
        self._moments: dict[int, tuple[_Moment, ...]] = {}
        self._ticks: dict[tuple[int, int, int, bool], int] = {}
        self._rolling: dict[int, tuple[int, int]] = {}
        self._standing: dict[tuple[int, int], tuple[int, ...]] = {}
        robots = run.state.robots.ints
        self.beds = [i for i in self.agents if robots[c.BED][parts[i].agent.index]]
        """Those that can carry a box."""
        self._dock_zones = [self._zones_of(run, dock, road) for dock in range(len(run.world.docks))]
        self.first = self._number(tuple(self._first(run, i) for i in self.agents))

    def body(self, number: int, i: int) -> Body:
        """How agent i moves."""
        return self._known[number][self._place[i]]

    def __len__(self) -> int:
        """How many numbers there are."""
        return len(self._known)

    def _number(self, bodies: tuple[Body, ...]) -> int:
        found = self._numbers.get(bodies)
        if found is None:
            found = self._numbers[bodies] = len(self._known)
            self._known.append(bodies)
        return found

    def _first(self, run: Simulation, i: int) -> Body:
        part = self.parts[i]
        at = run.state.robots.floats[c.AT]
        assert part.track is not None
        zone, gap = part.track.zones.zone_at(at[i]), part.track.gaps.beyond
        if part.leader >= 0:
            way = at[part.leader] - at[i]
            if way < 0:
                way += part.track.zones.length_mm
                is_around = part.track.zones.zone_at(at[part.leader]) == zone
                gap = around_of(part.track) if is_around else gap
            if gap != around_of(part.track):
                gap = part.track.gaps.class_of(way - part.track.gaps.lengths_mm)
        return Body(0, 0, zone, gap, False, False, False, False, True)

    def _zones_of(self, run: Simulation, dock: int, road: int) -> frozenset[int]:
        """The zones of a dock, where it is on this road."""
        docks = run.state.docks
        track = self.parts[self.agents[0]].track
        if docks.road[dock] != road or track is None:
            return frozenset()
        middle, reach = docks.floats[0][dock], docks.floats[1][dock]
        found = set()
        for zone in range(len(track.zones)):
            begin, end = track.zones.ends(zone)
            away = abs((begin + end) / 2 - middle)
            away = min(away, track.zones.length_mm - away) if track.zones.closed else away
            if away <= reach:
                found.add(zone)
        return frozenset(found)

    # -- looking

    def standing_in(self, number: int, dock: int) -> tuple[int, ...]:
        """The agents with beds that stand in a dock."""
        found = self._standing.get((number, dock))
        if found is None:
            zones, bodies = self._dock_zones[dock], self._known[number]
            here = ((i, bodies[self._place[i]]) for i in self.beds)
            found = tuple(i for i, body in here if body.way == 0 and body.zone in zones)
            self._standing[number, dock] = found
        return found

    def notices(self, number: int, i: int, reach_mm: float) -> int:
        """Whether a collision sensor of agent i, which looks where its robot drives, notices another one."""
        body, part = self.body(number, i), self.parts[i]
        if body.way < 0 or (body.way == 0 and body.want < 0):
            if part.follower < 0:
                return 0
            part, body = self.parts[part.follower], self.body(number, part.follower)
        assert part.track is not None
        if part.leader < 0 or body.gap > part.track.gaps.beyond:
            return 0
        return int(part.track.gaps.reached(body.gap, reach_mm))

    def begins(self, number: int) -> bool:
        """Whether a robot, whose commands are not late, is told to roll, stands, and presses on nobody."""
        return any(
            event.what is Move.BEGIN
            and not self.is_last(number, event.agent)
            and not self.parts[event.agent].is_late
            and not self._presses(number, event.agent)
            for event, _ in self.moves(number)
        )

    def is_last(self, number: int, i: int) -> bool:
        """Whether agent i is in the last zone in the direction that its wheels were told, perhaps at the road's end."""
        body, track = self.body(number, i), self.parts[i].track
        assert track is not None
        return track.zones.next(body.zone, body.want) < 0

    def _presses(self, number: int, i: int) -> bool:
        """Whether agent i presses on the robot before it, in the direction that its wheels were told."""
        body, follower = self.body(number, i), self.parts[i].follower
        return (body.gap if body.want > 0 else self.body(number, follower).gap if follower >= 0 else -1) == PRESSED

    # -- changing

    def after_tick(self, number: int, i: int, want: int, ticks: bool) -> int:
        """After a tick of agent i that told its wheels a direction (less than -1: nothing); whether it `ticks` on."""
        key = number, i, want, ticks
        found = self._ticks.get(key)
        if found is None:
            body = self.body(number, i)
            after = body.told(want) if want >= -1 else body
            found = self._ticks[key] = self._with(number, i, after._replace(new_zone=False, new_gap=False, ticks=ticks))
        return found

    def befallen(self, number: int, i: int, down: int) -> int:
        """After agent i failed, stalled or runs again."""
        body = self.body(number, i)._replace(ticks=down == RUNS)
        if down == FAILED:
            body = body._replace(want=0, held_zone=False, held_gap=False)
        return self._with(number, i, body)

    def moves(self, number: int) -> tuple[tuple[Event, int], ...]:
        """What robots can do next, and the numbers after it."""
        found = self._moves.get(number)
        if found is None:
            found = self._moves[number] = tuple(self._moves_from(number))
        return found

    def moment(self, number: int) -> tuple[_Moment, ...]:
        """What may happen between two steps of the simulator. No robot waits that can begin to roll."""
        found = self._moments.get(number)
        if found is None:
            found = self._moments[number] = tuple(self._moments_from(number))
        return found

    def rolling(self, number: int) -> tuple[int, int]:
        """The agents that get on forward, and those that get on backward, as bits; at the end of a road none does."""
        found = self._rolling.get(number)
        if found is None:
            ways = {1: 0, -1: 0}
            for i in self.agents:
                body, track = self.body(number, i), self.parts[i].track
                assert track is not None
                if (
                    body.way
                    and body.gap != PRESSED
                    and len(track.zones) > 1
                    and track.zones.next(body.zone, body.way) >= 0
                ):
                    ways[body.way] |= 1 << i
            found = self._rolling[number] = ways[1], ways[-1]
        return found

    def _moves_from(self, number: int) -> Iterator[tuple[Event, int]]:
        bodies = self._known[number]
        for i in self.agents:
            part = self.parts[i]
            leader = bodies[self._place[part.leader]] if part.leader >= 0 else None
            follower = bodies[self._place[part.follower]] if part.follower >= 0 else None
            behind = self.parts[part.follower].track if part.follower >= 0 else None
            assert part.track is not None
            is_pair = part.leader == part.follower
            for moved in moves(bodies[self._place[i]], leader, follower, part.track, behind, is_pair):
                made = list(bodies)
                made[self._place[i]] = moved.me
                if moved.leader is not None:
                    made[self._place[part.leader]] = moved.leader
                if moved.follower is not None:
                    made[self._place[part.follower]] = moved.follower
                yield Event(i, moved.move, part.leader), self._number(tuple(made))

    def _moments_from(self, number: int) -> Iterator[_Moment]:
        waiting: deque[tuple[int, frozenset[_Own], tuple[Event, ...]]] = deque([(number, frozenset(), ())])
        seen = {(number, waiting[0][1])}
        given: set[tuple[int, frozenset[int]]] = set()
        while waiting:
            now, used, events = waiting.popleft()
            # Which of them came into another zone, or began to roll, matters besides.
            which = now, frozenset(who for who, what in used if what in (_ONCE[Move.BEGIN], _ONCE[Move.ZONE]))
            if not self.begins(now) and which not in given:
                given.add(which)
                yield events, sum({progress(event, len(self.parts)) for event in events}), now
            for event, after in self.moves(now):
                assert isinstance(event.what, Move)
                own = event.agent, _ONCE.get(event.what) or (event.what, self.body(after, event.agent).gap)
                if own in used or (after, used | {own}) in seen:
                    continue
                seen.add((after, used | {own}))
                waiting.append((after, used | {own}, (*events, event)))
                if len(seen) > MOST_AT_ONCE:
                    raise ModelTooLargeError

    def _with(self, number: int, i: int, body: Body) -> int:
        made = list(self._known[number])
        made[self._place[i]] = body
        return self._number(tuple(made))
