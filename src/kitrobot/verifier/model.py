"""The discrete model of a mission: what its components are, and the tables in which exploring looks them up.

The state of a mission is cut into *components*: what is shared (boxes, shared variables, failures that may still come),
each agent but for its motion (`Inside`), and the motion of all robots on each road (`traffic`). Each is given a number
when it first comes up, and a state is these numbers in one key (`columns`). What exploring finds missing in a table is
filled in here, by the interpreter itself (`programs`).

A tick changes the agent itself and shared variables; what others sense of it changes with events of the world. So the
ticks of one moment may be taken in any order, but for shared variables: those of a tick are seen by the next.
"""

from __future__ import annotations

from collections.abc import Collection

from kitrobot.mission import FailureKind
from kitrobot.sim import Simulation
from kitrobot.sim import columns as c
from kitrobot.text import Sentence
from kitrobot.verifier import columns as v
from kitrobot.verifier import reactions
from kitrobot.verifier.bodies import FAILED, RUNS, Inside, zone_of
from kitrobot.verifier.building import KINDS, USUAL_KINDS, Roads, build, check_size, first_body
from kitrobot.verifier.events import TooManyError
from kitrobot.verifier.growing import find_confs_again, longer, put, widen_insides
from kitrobot.verifier.packing import Layout, Widths
from kitrobot.verifier.parts import Parts
from kitrobot.verifier.programs import AbstractionError
from kitrobot.verifier.stepping import due_in
from kitrobot.verifier.timing import Timing
from kitrobot.verifier.traffic import intern_conf

State = tuple[int, ...]
"""The numbers of a state's components: what is shared, each agent, each road; under *prompt* who has a tick to make."""

Shared = tuple[int, ...]
"""How many failures may still come, the boxes in each storehouse, the shared variables, what the team agreed on."""


class Model:
    """The model of a run that is before its first step, under one assumption.

    Args:
        run: the run.
        parts: its agents, taken apart.
        failures: how many failures there may be, together.
        timing: when agents tick.
        kinds: what kinds of failures: those of `KINDS`.

    Raises:
        AbstractionError: the mission is too large for the numbers of the tables, or a team is to go on after failures.
    """

    def __init__(
        self,
        run: Simulation,
        parts: Parts,
        failures: int = 0,
        timing: Timing = Timing.LOCKSTEP,
        kinds: Collection[FailureKind] = USUAL_KINDS,
    ) -> None:
        state = run.state
        self.run = run
        self.agreement = parts.agreement
        if self.agreement is not None and failures:
            raise AbstractionError(
                Sentence("what a team does about failures has no discrete form yet"),
                Sentence("check this mission without failures"),
            )
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
        self.t, due = build(run, self.parts, self.roads, timing, may_fail, slower)
        self.widths = Widths(self.t.fixed[v.FIELDS], due if timing is Timing.PROMPT else -1, self.count)
        self.layout: Layout = self.widths.layout()
        self.place_fields()
        self._insides: list[list[Inside]] = [[] for _ in self.parts]
        self._inside_numbers: list[dict[Inside, int]] = [{} for _ in self.parts]
        self._shareds: list[Shared] = []
        self._shared_numbers: dict[Shared, int] = {}
        self._writes: dict[reactions.Change, int] = {}
        self._seen: list[dict[tuple[int, ...], int]] = [{} for _ in self.parts]
        self._seen_tuples: list[list[tuple[int, ...]]] = [[] for _ in self.parts]
        self._changes = self._reactions = self._outcomes = 0
        self.failures = failures
        loads, at = state.robots.ints[c.LOAD], [float(one) for one in state.robots.floats[c.AT]]
        # The run may be gone on with before exploring begins.
        self._first_shared = [*(int(one) for one in state.docks.stock), *(int(one) for one in state.shared.ints[0])]
        self._agreed_at = 1 + len(self._first_shared)
        if self.agreement is not None:
            self._first_shared += self.agreement.first
        self._first_insides = [
            Inside(part.table.first, int(loads[part.agent.index]), reactions.idle_actuators(part), RUNS)
            for part in self.parts
        ]
        self._first_bodies = [first_body(part, self.parts, at) if part.track is not None else 0 for part in self.parts]

    # -- the first state

    def begin(self) -> State:
        """The first state.

        Raises:
            TooManyError: the mission is too large for a key.
        """
        found = [
            self.shared_number((self.failures, *self._first_shared)),
            *(self.inside_number(i, inside) for i, inside in enumerate(self._first_insides)),
        ]
        for road, agents in enumerate(self.roads.agents):
            for k in range(self.roads.places):
                self.t.made[k] = self._first_bodies[agents[k]] if k < len(agents) else 0
            while (number := intern_conf(self.t, road)) < 0:
                self.fill(int(self.t.regs[v.CODE]))
            found.append(number)
        if self.timing is Timing.PROMPT:
            x, y = self.layout.key((*found, 0))
            while (due := due_in(self.t, x, y, (1 << self.count) - 1)) < 0:
                self.fill(int(self.t.regs[v.CODE]))
                x, y = self.layout.key((*found, 0))
            found.append(due)
        return tuple(found)

    # -- components

    def inside(self, i: int, number: int) -> Inside:
        """What an agent is, but for its motion."""
        return self._insides[i][number]

    def insides(self, i: int) -> list[Inside]:
        """Everything that came up of it, by number."""
        return self._insides[i]

    def shareds(self) -> list[Shared]:
        """Everything that came up of what is shared, by number."""
        return self._shareds

    def has_ended(self, i: int, inside: Inside) -> bool:
        """Whether the program of agent i has ended."""
        return self.parts[i].is_over(inside.local)

    def goals_hold(self, shared: Shared) -> bool:
        """Whether every storehouse of a goal holds what it is to hold."""
        return all(shared[1 + house] == wanted for house, wanted in self.goals)

    def body(self, state: State, i: int) -> int:
        """How an agent on a road moves (see `bodies`)."""
        number = state[1 + self.count + self.roads.of[i]]
        fixed = self.t.fixed
        at = v.C_STAND + fixed[v.DOCKS] + fixed[v.PLACES] + self.roads.place[i]
        return int(self.t.confs[number * fixed[v.CONF_WIDTH] + at])

    def zone(self, state: State, i: int) -> int:
        """The zone in which an agent on a road is."""
        return zone_of(self.body(state, i))

    def inside_number(self, i: int, inside: Inside) -> int:
        """The number of what an agent is."""
        known = self._inside_numbers[i]
        if (number := known.get(inside)) is not None:
            return number
        number = len(known)
        if number >= v.MOST_INSIDES:
            raise TooManyError
        self._hold(1 + i, number)
        fixed = self.t.fixed
        if number >= fixed[v.INSIDE_STRIDE]:
            self.t = widen_insides(self.t, self.count)
        known[inside] = number
        self._insides[i].append(inside)
        ended = self.parts[i].is_over(inside.local)
        row = (i * fixed[v.INSIDE_STRIDE] + number) * fixed[v.INSIDE_WIDTH]
        insides = self.t.insides
        insides[row + v.I_TICKS] = int(inside.down == RUNS and not ended)
        insides[row + v.I_LOAD], insides[row + v.I_DOWN] = inside.load, inside.down
        insides[row + v.I_MUTED] = int(bool(inside.own))
        insides[row + v.I_ENDS] = int(any(inside.busy) and inside.down != FAILED)
        insides[row + v.I_ENDED] = int(ended)
        for n, act in enumerate(self.parts[i].acts):
            insides[row + v.I_ACT + 2 * n] = inside.busy[act.busy] if act.busy >= 0 else 0
        return number

    def shared_number(self, shared: Shared) -> int:
        """The number of what is shared."""
        if (number := self._shared_numbers.get(shared)) is not None:
            return number
        number = len(self._shareds)
        self._hold(0, number)
        seen = [self._seen_number(i, shared) << v.S_SHARED for i in range(self.count)]
        row = [*shared[: 1 + self.houses], *seen]
        self._room("shared", (number + 1) * len(row))
        self.t.shared[number * len(row) : (number + 1) * len(row)] = row
        self._shared_numbers[shared] = number
        self._shareds.append(shared)
        return number

    def _seen_number(self, i: int, shared: Shared) -> int:
        """The number of what agent i sees of what is shared: its variables, and the storehouses and answers that it
        senses.
        """
        part = self.parts[i]
        sensed = (
            shared[1 + sense.store if sense.store >= 0 else self._agreed_at + sense.agreed]
            for sense in part.senses
            if reactions.is_shared(sense)
        )
        seen = (*(shared[1 + self.houses + n] for n in part.shared), *sensed)
        number = self._seen[i].get(seen)
        if number is None:
            number = self._seen[i][seen] = len(self._seen[i])
            self._seen_tuples[i].append(seen)
            if number >= v.MOST_SEEN:
                raise TooManyError
        return number

    def cells(self, i: int, key: int) -> list[int]:
        """The first cells of agent i as its program would find them where it senses this (`looking.sensed`): inputs,
        then variables, each at its place. An input that may read anything is 0, and so is a variable that `take_apart`
        was not told of.
        """
        part, inside = self.parts[i], self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        layout = part.agent.machine.layout
        found = [0] * layout.cells
        for at, (sense, there) in enumerate(
            zip(part.senses, reactions.around(part, self._signs_of(i), key, seen[len(part.shared) :]), strict=True)
        ):
            found[1 + at] = reactions.read(inside, sense, there) or 0
        for cell in layout.variables.values():
            found[cell] = part.table.value(inside.local, cell)
        for cell, value in zip(part.table.shared, inside.own or seen, strict=False):
            found[cell] = value
        return found

    # -- filling

    def fill(self, code: int) -> None:
        """Puts into the tables what exploring asked for.

        Raises:
            TooManyError: there is no number left for it, or a step goes in too many ways.
            AbstractionError: a program may read too many values.
        """
        regs = self.t.regs
        a, b = int(regs[v.MISS_A]), int(regs[v.MISS_B])
        if code == v.MISS_REACTION:
            (self._fill_silenced if b >> v.S_MUTE else self._fill_reaction)(a, b)
        elif code == v.MISS_SHARED:
            self._fill_change(a, b)
        elif code in (v.MISS_DONE, v.MISS_LOADED, v.MISS_DOWN):
            self._fill_inside(code, a, b)
        elif code == v.WIDEN:
            self._hold(a, int(self.t.mask[a]) + 1)
        elif code == v.ROOM_CONFS:
            self._more("confs")
            slots = self.t.conf_slots
            while len(slots) < 4 * (len(self.t.confs) // int(self.t.fixed[v.CONF_WIDTH])):
                self._more("conf_slots")
                slots = self.t.conf_slots
            find_confs_again(self.t)
        elif code == v.ROOM_NEXT:
            if len(self.t.next_x) > 1_000_000:
                raise TooManyError
            for name in ("next_x", "next_y", "next_taken", "next_kinds", "next_event", "next_slots"):
                self._more(name)
            self.t.next_slots[:] = [0] * len(self.t.next_slots)
            regs[v.NEXTS] = 0
        elif code == v.ROOM_AFTERS:
            if len(self.t.after) < _MOST_AFTER:
                for name in ("after_heads", "after_slots", "after"):
                    self._more(name)
            elif not regs[v.AFTERS]:
                raise TooManyError
            self._forget_after()
        elif code in _ROOM:
            self._more(_ROOM[code])
        else:
            raise TooManyError

    def _fill_reaction(self, i: int, key: int) -> None:
        part = self.parts[i]
        inside = self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        outside = reactions.around(part, self._signs_of(i), key, seen[len(part.shared) :])
        shared = inside.own or seen[: len(part.shared)]
        sensed = tuple(reactions.read(inside, sense, there) for sense, there in zip(part.senses, outside, strict=True))
        choices = {at: sense.choices for at, sense in enumerate(part.senses)}
        found: dict[tuple[int, int, int], None] = {}
        for reaction in part.table.react(inside.local, sensed, shared, choices):
            want, after = reactions.after_reaction(part, inside, reaction)
            number = self.inside_number(i, after)
            ticks = after.down == RUNS and not part.is_over(after.local)
            change = reactions.change_by(part, inside, shared, reaction)
            found[number, 2 * (want + 2) + ticks, self._write_number(change)] = None
        first = self._outcomes
        self._outcomes += len(found)
        self._room("outcomes", self._outcomes * v.OUTCOME)
        rows = [one for row in found for one in row]
        self.t.outcomes[first * v.OUTCOME : self._outcomes * v.OUTCOME] = rows
        self._reactions += 1
        self.t = put(self.t, "reaction_keys", "reaction_at", self._reactions, key, first << v.S_COUNT | len(found))

    def _fill_silenced(self, i: int, key: int) -> None:
        inside = self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        number = self.inside_number(i, reactions.after_silence(self.parts[i], inside, key, seen))
        self._reactions += 1
        self.t = put(self.t, "reaction_keys", "reaction_at", self._reactions, key, number)

    def _signs_of(self, i: int) -> list[tuple[int, ...]]:
        """What the sensors for signs of agent i read in the classes of zones; none on no road."""
        return self.roads.signs[i] if self.roads.of[i] >= 0 else []

    def _write_number(self, change: reactions.Change) -> int:
        """The number of a change of what is shared."""
        if change == ((), ()):
            return v.NO_WRITE
        return self._writes.setdefault(change, 3 + 2 * self.houses + len(self._writes))

    def _fill_change(self, number: int, write: int) -> None:
        shared = list(self._shareds[number])
        if write <= 2 * self.houses:
            shared[1 + (write - 1) // 2] += 1 if write % 2 == 0 else -1
        elif write == 1 + 2 * self.houses:
            shared[0] -= 1
        elif write == 2 + 2 * self.houses:
            assert self.agreement is not None, "only a team settles"
            shared[self._agreed_at :] = self.agreement.settled(tuple(shared[self._agreed_at :]))
        else:
            changes, told = next(one for one, its in self._writes.items() if its == write)
            for at, value in changes:
                shared[1 + self.houses + at] = value
            if self.agreement is not None and told:
                agreed = self.agreement.after(tuple(shared[self._agreed_at :]), told)
                settles = self.timing is not Timing.LOCKSTEP
                shared[self._agreed_at :] = self.agreement.all_settled(agreed) if settles else agreed
        after = self.shared_number(tuple(shared))
        self._changes += 1
        self.t = put(self.t, "change_keys", "change_to", self._changes, number << v.S_WRITE | write, after)

    def _fill_inside(self, code: int, i: int, which: int) -> None:
        number = int(self.t.now[1 + i])
        inside = self._insides[i][number]
        column = v.I_LOADED
        after = inside._replace(load=1 - inside.load)
        if code == v.MISS_DONE:
            column = v.I_ACT + 2 * which + 1
            busy = list(inside.busy)
            busy[self.parts[i].acts[which].busy] = 0
            after = inside._replace(busy=tuple(busy))
        elif code == v.MISS_DOWN:
            column = v.I_BEFALLEN + which
            after = inside._replace(down=which)
        to = self.inside_number(i, after)
        fixed = self.t.fixed
        self.t.insides[(i * fixed[v.INSIDE_STRIDE] + number) * fixed[v.INSIDE_WIDTH] + column] = to

    # -- room in the tables

    def _hold(self, field: int, number: int) -> None:
        """Makes sure that a field is wide enough for a number; keys are written anew where it was not."""
        if number > int(self.t.mask[field]):
            self.layout = self.widths.widen(field, number)
            self.place_fields()

    def place_fields(self) -> None:
        """Writes the layout into the tables."""
        for name in ("shift", "mask", "word"):
            getattr(self.t, name)[: len(self.layout.shift)] = getattr(self.layout, name)
        self._forget_after()

    def _forget_after(self) -> None:
        """Empties `after`, whose keys are those of one layout, and which has room for so many states."""
        self.t.regs[v.AFTERS] = self.t.regs[v.AFTER_ROWS] = 0
        self.t.after_slots[:] = [0] * len(self.t.after_slots)

    def _more(self, name: str) -> None:
        """Doubles a table; its new rows hold what free ones hold."""
        table = getattr(self.t, name)
        free = -1 if name in ("change_keys", "reaction_keys") else 0
        self.t = self.t._replace(**{name: longer(table, 2 * len(table), free)})

    def _room(self, name: str, size: int) -> None:
        while len(getattr(self.t, name)) < size:
            self._more(name)


_MOST_AFTER = 2_000_000
"""Numbers that are kept of what follows in lockstep; a table that needs more is emptied."""
_ROOM = {v.ROOM_MOVES: "moves", v.ROOM_MOMENTS: "moments", v.ROOM_LOG: "log"}
