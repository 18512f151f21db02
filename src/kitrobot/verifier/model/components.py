"""The components of a model's states: each gets a number when it first comes up, and a row in the tables.

The state of a mission is split into *components*: the shared state (boxes, shared variables, remaining failures, the
team's state), each agent except its motion (`Inside`), and the motion of all robots on each road (`traffic`). A state
is the numbers of its components, packed into one key (`columns`).
"""

from __future__ import annotations

from collections.abc import Collection

from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model import reactions
from kitrobot.verifier.model.absence import AbsenceAgreement
from kitrobot.verifier.model.abstraction import Abstraction
from kitrobot.verifier.model.table_builder import KINDS, USUAL_KINDS, Roads, build, check_size, first_body
from kitrobot.verifier.model.team_agreement import TeamState
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.bodies import FAILED, RUNS, Inside, zone_of
from kitrobot.verifier.tables.dynamic_arrays import grow_table, widen_insides
from kitrobot.verifier.tables.events import ModelTooLargeError
from kitrobot.verifier.tables.key_layout import Layout, Widths

State = tuple[int, ...]
"""The numbers of a state's components: the shared state, each agent, each road; under *prompt* the due agents."""

SharedState = tuple[int, ...]
"""The remaining failures, the boxes in each storehouse, the shared variables, the team's state."""


class Components:
    """The components of a model's states; see `model.Model`.

    Args:
        run: the run.
        parts: its discrete abstraction.
        failures: the most failures in one run, together.
        timing: when agents tick.
        kinds: the kinds of failures, of `KINDS`.

    Raises:
        AbstractionError: the mission is too large for the numbers of the tables.
    """

    def __init__(
        self,
        run: Simulation,
        parts: Abstraction,
        failures: int = 0,
        timing: Timing = Timing.LOCKSTEP,
        kinds: Collection[FailureKind] = USUAL_KINDS,
    ) -> None:
        state = run.state
        self.run = run
        self.agreement = parts.agreement
        self.absence: AbsenceAgreement | None = None
        """The absence model of a team; None if no member can fail."""
        if self.agreement is not None and failures:
            self.agreement = self.absence = AbsenceAgreement(run, self.agreement.actuators)
        self.timing = timing
        self.parts = parts.parts
        self.limits = parts.limits
        self.count = len(self.parts)
        check_size(self.parts)
        self.roads = Roads(run, self.parts)
        self.goals = [(int(house), int(wanted)) for house, wanted in zip(*state.docks.goals, strict=True)]
        self.houses = len(run.world.storehouses)
        fastest = min((part.agent.period for part in self.parts), default=1)
        slower = sum(1 << i for i, part in enumerate(self.parts) if part.agent.period > fastest)
        may_fail = sum(KINDS[kind] for kind in set(kinds)) if failures else 0
        watched = 0 if self.absence is None else 1 + self.absence.works
        self.t, due = build(run, self.parts, self.roads, timing, may_fail, slower, watched)
        self.widths = Widths(self.t.fixed[v.FIELDS], due if timing is Timing.PROMPT else -1, self.count)
        self.layout: Layout = self.widths.layout()
        self.place_fields()
        self._insides: list[list[Inside]] = [[] for _ in self.parts]
        self._inside_numbers: list[dict[Inside, int]] = [{} for _ in self.parts]
        self._shareds: list[SharedState] = []
        self._shared_numbers: dict[SharedState, int] = {}
        self._writes: list[reactions.Change] = []
        self._write_numbers: dict[reactions.Change, int] = {}
        self._first_watched = 3 + 2 * self.houses
        self._watched_each = v.W_FREED + watched - 1 if watched else 0
        self._first_write = self._first_watched + self._watched_each * len(self.parts)
        self._seen: list[dict[tuple[int, ...], int]] = [{} for _ in self.parts]
        self._seen_tuples: list[list[tuple[int, ...]]] = [[] for _ in self.parts]
        self._read: dict[tuple[int, int, tuple[int, ...]], tuple[int | None, ...]] = {}
        self._changes = self._reactions = self._outcomes = 0
        self.failures = failures
        loads, at = state.robots.ints[c.LOAD], [float(one) for one in state.robots.floats[c.AT]]
        # The run may continue before the exploration begins.
        self._first_shared = [*(int(one) for one in state.docks.stock), *(int(one) for one in state.shared.ints[0])]
        self._agreed_at = 1 + len(self._first_shared)
        if self.agreement is not None:
            first = self.agreement.first
            self._first_shared += first if self.absence is None else self.absence.reduced(first, failures)
        self._first_insides = [
            Inside(part.table.first, int(loads[part.agent.index]), reactions.idle_actuators(part), RUNS)
            for part in self.parts
        ]
        self._first_bodies = [first_body(part, self.parts, at) if part.track is not None else 0 for part in self.parts]

    # -- components

    def inside(self, i: int, number: int) -> Inside:
        """The state of an agent except its motion."""
        return self._insides[i][number]

    def insides(self, i: int) -> list[Inside]:
        """All known states of an agent except its motion, by number."""
        return self._insides[i]

    def shareds(self) -> list[SharedState]:
        """All known shared states, by number."""
        return self._shareds

    def has_ended(self, i: int, inside: Inside) -> bool:
        """Whether the program of agent i has ended."""
        part = self.parts[i]
        return inside.is_over or part.table.has_ended(inside.local) or (part.is_spare and self.absence is None)

    def agreed(self, shared: SharedState) -> TeamState:
        """The team's state; empty without a team."""
        return shared[self._agreed_at :]

    def goals_hold(self, shared: SharedState) -> bool:
        """Whether every storehouse of a goal holds what it is to hold."""
        return all(shared[1 + house] == wanted for house, wanted in self.goals)

    def body(self, state: State, i: int) -> int:
        """The motion of an agent on a road (see `bodies`)."""
        number = state[1 + self.count + self.roads.of[i]]
        fixed = self.t.fixed
        at = v.C_STAND + fixed[v.DOCKS] + fixed[v.PLACES] + self.roads.place[i]
        return int(self.t.confs[number * fixed[v.CONF_WIDTH] + at])

    def zone(self, state: State, i: int) -> int:
        """The zone in which an agent on a road is."""
        return zone_of(self.body(state, i))

    def inside_number(self, i: int, inside: Inside) -> int:
        """The number of an agent's own state; assigns one if it is new."""
        known = self._inside_numbers[i]
        if (number := known.get(inside)) is not None:
            return number
        number = len(known)
        if number >= v.MOST_INSIDES:
            raise ModelTooLargeError
        self._hold(1 + i, number)
        fixed = self.t.fixed
        if number >= fixed[v.INSIDE_STRIDE]:
            self.t = widen_insides(self.t, self.count)
        known[inside] = number
        self._insides[i].append(inside)
        ended = self.has_ended(i, inside)
        row = (i * fixed[v.INSIDE_STRIDE] + number) * fixed[v.INSIDE_WIDTH]
        insides = self.t.insides
        insides[row + v.I_TICKS] = int(inside.down == RUNS and not ended)
        insides[row + v.I_LOAD], insides[row + v.I_DOWN] = inside.load, inside.down
        insides[row + v.I_MUTED] = int(inside.is_muted)
        insides[row + v.I_ENDS] = int(any(inside.busy) and inside.down != FAILED)
        insides[row + v.I_ENDED] = int(ended)
        for n, act in enumerate(self.parts[i].acts):
            insides[row + v.I_ACT + 2 * n] = inside.busy[act.busy] if act.busy >= 0 else 0
        return number

    def shared_number(self, shared: SharedState) -> int:
        """The number of a shared state; assigns one if it is new."""
        if (number := self._shared_numbers.get(shared)) is not None:
            return number
        number = len(self._shareds)
        self._hold(0, number)
        seen = [self._seen_number(i, shared) << v.S_SHARED for i in range(self.count)]
        row = [*shared[: 1 + self.houses], *seen]
        if self.absence is not None:
            row += self.absence.seen(self.agreed(shared))
        self._room("shared", (number + 1) * len(row))
        self.t.shared[number * len(row) : (number + 1) * len(row)] = row
        self._shared_numbers[shared] = number
        self._shareds.append(shared)
        return number

    def _seen_number(self, i: int, shared: SharedState) -> int:
        """The number of agent i's view of the shared state.

        The view is its variables, the storehouses and answers that it senses, and whether its team ended its program.
        """
        part, ends = self.parts[i], []
        if self.absence is not None:
            ends = [int(self.absence.has_ended(self.agreed(shared), part.agent.index))]
        sensed = (
            shared[1 + sense.store if sense.store >= 0 else self._agreed_at + sense.agreed]
            for sense in part.senses
            if reactions.is_shared(sense)
        )
        seen = (*(shared[1 + self.houses + n] for n in part.shared), *sensed, *ends)
        number = self._seen[i].get(seen)
        if number is None:
            number = self._seen[i][seen] = len(self._seen[i])
            self._seen_tuples[i].append(seen)
            if number >= v.MOST_SEEN:
                raise ModelTooLargeError
        return number

    def cells(self, i: int, key: int) -> list[int]:
        """The first cells of agent i as its program finds them: inputs, then variables, each at its place.

        `key` is what the agent senses (`state_decoding.sense_key`). An input that may read anything is 0, and so is a
        variable that was not requested from `abstract_run`.
        """
        part, inside = self.parts[i], self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        layout = part.agent.machine.layout
        found = [0] * layout.cells
        for at, (sense, there) in enumerate(
            zip(
                part.senses,
                reactions.external_values(part, self._signs_of(i), key, seen[len(part.shared) :]),
                strict=True,
            )
        ):
            found[1 + at] = reactions.read(inside, sense, there) or 0
        for cell in layout.variables.values():
            found[cell] = part.table.value(inside.local, cell)
        for cell, value in zip(part.table.shared, inside.own or seen, strict=False):
            found[cell] = value
        return found

    def _signs_of(self, i: int) -> list[tuple[int, ...]]:
        """The values of agent i's sign sensors in the classes of zones; empty if it is on no road."""
        return self.roads.signs[i] if self.roads.of[i] >= 0 else []

    # -- room in the tables

    def _hold(self, field: int, number: int) -> None:
        """Widens a field if a number does not fit; keys are then rewritten."""
        if number > int(self.t.mask[field]):
            self.layout = self.widths.widen(field, number)
            self.place_fields()

    def place_fields(self) -> None:
        """Writes the layout into the tables."""
        for name in ("shift", "mask", "word"):
            getattr(self.t, name)[: len(self.layout.shift)] = getattr(self.layout, name)
        self._forget_after()

    def _forget_after(self) -> None:
        """Empties the cache `after`, whose keys belong to one layout."""
        self.t.regs[v.AFTERS] = self.t.regs[v.AFTER_ROWS] = 0
        self.t.after_slots[:] = [0] * len(self.t.after_slots)

    def _more(self, name: str) -> None:
        """Doubles a table; its new rows hold what free ones hold."""
        table = getattr(self.t, name)
        free = -1 if name in ("change_keys", "reaction_keys") else 0
        self.t = self.t._replace(**{name: grow_table(table, 2 * len(table), free)})

    def _room(self, name: str, size: int) -> None:
        while len(getattr(self.t, name)) < size:
            self._more(name)
