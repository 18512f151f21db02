"""The discrete model of a mission: its states, the ticks of its agents and the events of its world.

A state is a tuple of whole numbers: for each agent a number for what it is but for its motion (`Inside`); for each road
a number for the motion of all robots on it (`Body`); the boxes in each storehouse; the shared variables; and how many
failures may still come. Whatever depends on a few of these is looked up once it was computed.

A tick changes the agent itself and shared variables; what others sense of it changes with events of the world. So the
ticks of one moment may be taken in any order, but for shared variables: those of a tick are seen by the next.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import product
from operator import itemgetter

from kitrobot.mission.trial import FailureKind
from kitrobot.sim.devices.base import Discrete
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model.abstraction import Abstraction, AgentModel, InputModel
from tests.verifier.reference.bodies import FAILED, RUNS, STALLED, Inside
from tests.verifier.reference.events import Event, EventKind
from tests.verifier.reference.traffic import Traffic

State = tuple[int, ...]

_Outcome = tuple[int, int, tuple[int, ...]]
"""After a tick: the agent's number, the direction its wheels were told (`_AS_BEFORE` or more), its shared variables."""
_AS_BEFORE = -2


class Model:
    """The model of a run that is before its first step.

    Args:
        run: the run.
        parts: its agents, taken apart.
        failures: how many failures there may be, together.
        kinds: of which kinds.
    """

    def __init__(
        self,
        run: Simulation,
        parts: Abstraction,
        failures: int = 0,
        kinds: Collection[FailureKind] = (FailureKind.FAIL, FailureKind.STALL),
    ) -> None:
        state = run.state
        self.run = run
        self._kinds = frozenset(kinds)
        self.parts = parts.parts
        self.limits = parts.limits
        self.count = len(self.parts)
        roads = sorted({part.road for part in self.parts if part.road >= 0})
        self.traffic = [Traffic(run, self.parts, road) for road in roads]
        """The roads that somebody is on."""
        self.roads_at = self.count
        self.stock_at = self.roads_at + len(roads)
        self.shared_at = self.stock_at + len(run.world.storehouses)
        self.failures_at = self.shared_at + len(state.shared.ints[0])
        self.goals = [(int(house), int(wanted)) for house, wanted in zip(*state.docks.goals, strict=True)]
        self._capacity = [int(one) for one in state.docks.capacity]
        self._road_of = [roads.index(part.road) if part.road >= 0 else -1 for part in self.parts]
        self._dock_road = [roads.index(road) if road in roads else -1 for road in state.docks.road]
        self._insides: list[list[Inside]] = [[] for _ in self.parts]
        self._numbers: list[dict[Inside, int]] = [{} for _ in self.parts]
        self._shared_places = [[self.shared_at + v for v in part.shared] for part in self.parts]
        self._seen_by = [itemgetter(*self._places(i)) for i in range(self.count)]
        self._met: list[dict[tuple[int, ...], tuple[_Outcome, ...]]] = [{} for _ in self.parts]
        self._ticking: list[list[bool]] = [[] for _ in self.parts]
        self._reactions: list[dict[tuple[int, ...], tuple[_Outcome, ...]]] = [{} for _ in self.parts]
        beds = state.robots.ints[c.LOAD]
        self.first: State = (
            *(
                self._number(i, self._first_inside(part, int(beds[part.agent.index])))
                for i, part in enumerate(self.parts)
            ),
            *(road.first for road in self.traffic),
            *(int(one) for one in state.docks.stock),
            *(int(one) for one in state.shared.ints[0]),
            failures,
        )

    # -- states

    def inside(self, state: State, i: int) -> Inside:
        """What agent i is, but for its motion."""
        return self._insides[i][state[i]]

    def _number(self, i: int, inside: Inside) -> int:
        known = self._numbers[i]
        number = known.get(inside)
        if number is None:
            number = known[inside] = len(known)
            self._insides[i].append(inside)
            self._ticking[i].append(inside.down == RUNS and not self.parts[i].table.has_ended(inside.local))
        return number

    def _first_inside(self, part: AgentModel, load: int) -> Inside:
        return Inside(part.table.first, load, (0,) * sum(act.busy >= 0 for act in part.acts), RUNS)

    def ended(self, state: State, i: int) -> bool:
        """Whether the program of agent i has ended."""
        return self.parts[i].table.has_ended(self.inside(state, i).local)

    def ticks(self, state: State, i: int) -> bool:
        """Whether agent i has ticks: its program goes on, and nothing befell it."""
        return self._ticking[i][state[i]]

    def goals_hold(self, state: State) -> bool:
        """Whether every storehouse of a goal holds what it is to hold."""
        return all(state[self.stock_at + house] == wanted for house, wanted in self.goals)

    def standing_in(self, state: State, dock: int) -> tuple[int, ...]:
        """The agents with beds that stand in a dock."""
        road = self._dock_road[dock]
        return self.traffic[road].standing_in(state[self.roads_at + road], dock) if road >= 0 else ()

    # -- ticks

    def react(self, state: State, i: int) -> tuple[_Outcome, ...]:
        """What one tick of agent i can bring."""
        seen = self._seen_by[i](state)
        found = self._met[i].get(seen)
        if found is not None:
            return found
        part, road = self.parts[i], self._road_of[i]
        around = [self._there(state, i, road, sense) for sense in part.senses]
        own = self.inside(state, i).own
        key = (state[i], *around, *(own or (state[self.shared_at + v] for v in part.shared)))
        found = self._reactions[i].get(key)
        if found is None:
            found = self._reactions[i][key] = self._computed(i, self.inside(state, i), around, key[1 + len(around) :])
        self._met[i][seen] = found
        return found

    def said(self, state: State, i: int) -> tuple[tuple[tuple[int, int, int], int], ...] | None:
        """What agent i tells its devices in its next tick; None where it may do one thing or another, or changes a
        shared variable, or begins something that takes longer.
        """
        part, road, inside = self.parts[i], self._road_of[i], self.inside(state, i)
        if not self.ticks(state, i):
            return ()
        around = [self._there(state, i, road, sense) for sense in part.senses]
        sensed = tuple(_reads(inside, sense, there) for sense, there in zip(part.senses, around, strict=True))
        shared = inside.own or tuple(state[self.shared_at + v] for v in part.shared)
        choices = {at: sense.choices for at, sense in enumerate(part.senses)}
        (first, *others) = part.table.react(inside.local, sensed, shared, choices)
        is_later = any(command in part.acts[actuator].later for actuator, command, _ in first.commands)
        if others or is_later or (first.shared != shared and not inside.own):
            return None
        return tuple(zip(first.commands, first.seconds, strict=True))

    def _places(self, i: int) -> list[int]:
        """The places of a state that a tick of agent i depends on; at least two."""
        part = self.parts[i]
        found = {i, self.failures_at, *(self.shared_at + v for v in part.shared)}
        for sense in part.senses:
            if sense.discrete in (Discrete.SECTION, Discrete.GAP):
                found.add(self.roads_at + self._road_of[i])
            elif sense.discrete is Discrete.EXACT and sense.store >= 0:
                found.add(self.stock_at + sense.store)
            elif sense.discrete is Discrete.VISIT and self._dock_road[sense.dock] >= 0:
                road = self._dock_road[sense.dock]
                found |= {self.roads_at + road, *self.traffic[road].beds}
        return sorted(found)

    def after_tick(self, state: State, i: int) -> Iterator[State]:
        """The states after one tick of agent i; what it writes is seen at once."""
        for outcome in self.react(state, i):
            made = list(state)
            self._apply(made, state, i, outcome)
            yield tuple(made)

    def stays(self, state: State, i: int) -> bool:
        """Whether a tick of agent i may change nothing."""
        own = self.inside(state, i).own
        shared = own or tuple(state[self.shared_at + v] for v in self.parts[i].shared)
        return any(
            outcome[0] == state[i] and outcome[2] == shared and self._keeps_motion(state, i, outcome[1])
            for outcome in self.react(state, i)
        )

    def writes(self, state: State, i: int) -> bool:
        """Whether a tick of agent i may change a shared variable."""
        own = self.inside(state, i).own
        shared = tuple(state[self.shared_at + v] for v in self.parts[i].shared)
        return not own and any(outcome[2] != shared for outcome in self.react(state, i))

    def _keeps_motion(self, state: State, i: int, want: int) -> bool:
        road = self._road_of[i]
        if road < 0:
            return True
        number = state[self.roads_at + road]
        return self.traffic[road].after_tick(number, i, want, True) == number

    def after_all(self, state: State, paused: Collection[int] = ()) -> Iterator[State]:
        """The states after a tick of all agents at once, but of those that are `paused`; of two that write one variable
        the later in the team wins.
        """
        ticking = [i for i in range(self.count) if i not in paused and self.ticks(state, i)]
        for outcomes in product(*(self.react(state, i) for i in ticking)):
            made = list(state)
            for i, outcome in zip(ticking, outcomes, strict=True):
                self._apply(made, state, i, outcome)
            yield tuple(made)

    def _apply(self, made: list[int], before: State, i: int, outcome: _Outcome) -> None:
        """Puts what a tick of agent i brought into a state that is being made."""
        made[i], want, shared = outcome
        heard = self._shared_places[i] if not self.inside(before, i).own else []
        for at, value in zip(heard, shared, strict=False):
            if value != before[at]:
                made[at] = value
        road = self._road_of[i]
        if road >= 0:
            at = self.roads_at + road
            made[at] = self.traffic[road].after_tick(made[at], i, want, self._ticking[i][made[i]])

    def _there(self, state: State, i: int, road: int, sense: InputModel) -> int:
        """What an input reads outside of the agent itself; 0 where there is nothing to read."""
        if sense.discrete is Discrete.SECTION:
            return sense.signs[self.traffic[road].body(state[self.roads_at + road], i).zone]
        if sense.discrete is Discrete.GAP:
            return self.traffic[road].notices(state[self.roads_at + road], i, sense.reach_mm)
        if sense.discrete is Discrete.VISIT:
            loads = [self.inside(state, at).load for at in self.standing_in(state, sense.dock)]
            return int(any(sense.load in (2, load) for load in loads))
        if sense.discrete is Discrete.EXACT and sense.store >= 0:
            return state[self.stock_at + sense.store]
        return 0

    def _computed(self, i: int, inside: Inside, around: list[int], shared: tuple[int, ...]) -> tuple[_Outcome, ...]:
        part = self.parts[i]
        sensed = tuple(_reads(inside, sense, there) for sense, there in zip(part.senses, around, strict=True))
        choices = {at: sense.choices for at, sense in enumerate(part.senses)}
        found: dict[_Outcome, None] = {}
        for reaction in part.table.react(inside.local, sensed, shared, choices):
            want, busy = _AS_BEFORE, list(inside.busy)
            for actuator, command, argument in reaction.commands:
                act = part.acts[actuator]
                if actuator == part.drive:
                    want = act.ways[command] if argument else 0
                elif act.busy >= 0 and command in act.later:
                    busy[act.busy] = 1 + act.ways[command]
            own = reaction.shared if inside.own else ()
            stopped, left = reaction.stops
            loose = inside.loose & ~stopped | left
            after = inside._replace(local=reaction.local, busy=tuple(busy), own=own, loose=loose)
            found[self._number(i, after), want, reaction.shared] = None
        return tuple(found)

    # -- the world

    def moves(self, state: State) -> Iterator[tuple[Event, State]]:
        """What robots on roads can do next, and the states after it."""
        for road, traffic in enumerate(self.traffic):
            at = self.roads_at + road
            for event, number in traffic.moves(state[at]):
                yield event, (*state[:at], number, *state[at + 1 :])

    def ends(self, state: State) -> Iterator[tuple[Event, State]]:
        """What takes longer and can come to its end next, and the states after it."""
        for i in range(self.count):
            inside = self.inside(state, i)
            if any(inside.busy) and inside.down != FAILED:
                yield from self._ends_of(state, i, inside)

    def failures(self, state: State) -> Iterator[tuple[Event, State]]:
        """What may befall agents next, and the states after it."""
        for i, part in enumerate(self.parts):
            inside = self.inside(state, i)
            if inside.down == STALLED:
                yield Event(i, EventKind.RESUME), self._befallen(state, i, RUNS, 0)
            if state[self.failures_at] == 0 or inside.down == FAILED or part.table.has_ended(inside.local):
                continue
            knows = inside.own or tuple(state[self.shared_at + v] for v in part.shared)
            if FailureKind.FAIL in self._kinds:
                copies = knows if part.is_observed else inside.own
                yield Event(i, EventKind.FAIL), self._befallen(state, i, FAILED, 1, copies)
            if inside.down == RUNS and FailureKind.STALL in self._kinds:
                yield Event(i, EventKind.STALL), self._befallen(state, i, STALLED, 1)
            if part.shared and not inside.own and FailureKind.MUTE in self._kinds:
                made = list(state)
                made[i] = self._number(i, inside._replace(own=knows))
                made[self.failures_at] -= 1
                yield Event(i, EventKind.MUTE), tuple(made)

    def begins(self, state: State) -> bool:
        """Whether a robot is told to roll, stands, and has a free way: in the simulator it rolls in that step."""
        return any(road.begins(state[self.roads_at + r]) for r, road in enumerate(self.traffic))

    def _befallen(self, state: State, i: int, down: int, failures: int, own: tuple[int, ...] | None = None) -> State:
        made, inside = list(state), self.inside(state, i)
        made[i] = self._number(i, inside._replace(down=down, own=inside.own if own is None else own))
        made[self.failures_at] -= failures
        road = self._road_of[i]
        if road >= 0:
            at = self.roads_at + road
            made[at] = self.traffic[road].befallen(made[at], i, down)
        return tuple(made)

    def _ends_of(self, state: State, i: int, inside: Inside) -> Iterator[tuple[Event, State]]:
        """What takes longer comes to its end; an arm moves a box then, or none."""
        for act in self.parts[i].acts:
            if act.busy < 0 or inside.busy[act.busy] == 0:
                continue
            busy = list(inside.busy)
            busy[act.busy] = 0
            done = list(state)
            done[i] = self._number(i, inside._replace(busy=tuple(busy)))
            if not act.is_arm:
                yield Event(i, EventKind.DONE), tuple(done)
                continue
            loads = inside.busy[act.busy] == 1
            stock_at = self.stock_at + act.store
            for carrier in self.standing_in(state, act.dock) or (-1,):
                other = self.inside(state, carrier) if carrier >= 0 else None
                if other is None or other.load == loads:
                    what = EventKind.NO_EMPTY_CARRIER if loads else EventKind.NO_LOADED_CARRIER
                    yield Event(i, what, act.dock), tuple(done)
                elif loads and state[stock_at] == 0:
                    yield Event(i, EventKind.NO_BOX, act.store), tuple(done)
                elif loads or state[stock_at] < self._capacity[act.store]:
                    moved = done[:]
                    moved[carrier] = self._number(carrier, other._replace(load=int(loads)))
                    moved[stock_at] += -1 if loads else 1
                    yield Event(i, EventKind.LOADED if loads else EventKind.UNLOADED, carrier), tuple(moved)


def _reads(inside: Inside, sense: InputModel, there: int) -> int | None:
    """The value of an input; None where it may be any of its choices."""
    if sense.discrete is Discrete.ANY:
        return None
    if sense.discrete is Discrete.BUSY:
        return 0 if inside.busy[sense.actuator] else 1
    value = inside.load if sense.discrete is Discrete.EXACT and sense.store < 0 else there
    return min(max(value, sense.least), sense.most)
