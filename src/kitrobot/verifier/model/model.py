"""The discrete model of a mission: the tables in which the exploration looks up transitions, filled on demand.

When the exploration finds that a table lacks an entry, the model adds it: with the interpreter itself (`programs`) and,
where a team agrees on something or misses a member, with the simulator (`team_agreement`, `absence`).

A tick changes the agent itself and shared variables; what other agents sense of it changes with events of the world. So
the ticks of one moment may be taken in any order, except for shared variables: the next tick sees those of the
previous.
"""

from __future__ import annotations

from collections.abc import Collection

from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model import reactions
from kitrobot.verifier.model.absence import ENDS
from kitrobot.verifier.model.components import Components, SharedState, State
from kitrobot.verifier.model.programs import Reaction
from kitrobot.verifier.model.team_agreement import TeamCommand, TeamState
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.bodies import ANEW, FAILED, LOST, RUNS, Inside
from kitrobot.verifier.tables.dynamic_arrays import insert, rebuild_conf_slots
from kitrobot.verifier.tables.events import ModelTooLargeError
from kitrobot.verifier.tables.state_decoding import decode, sense_key
from kitrobot.verifier.tables.traffic import intern_conf
from kitrobot.verifier.transitions.interleaved_successors import due_in

__all__ = ["Model", "SharedState", "State"]


class Model(Components):
    """The model of a run that is before its first step, under one assumption; see `Components` for its arguments."""

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

    # -- filling

    def fill(self, code: int) -> None:
        """Adds the entry or the room that a pause code asks for to the tables.

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
            rebuild_conf_slots(self.t)
        elif code == v.ROOM_NEXT:
            if len(self.t.next_x) > 1_000_000:
                raise ModelTooLargeError
            for name in ("next_x", "next_y", "next_taken", "next_kinds", "next_event", "next_slots"):
                self._more(name)
            self.t.next_slots[:] = [0] * len(self.t.next_slots)
            regs[v.NEXTS] = 0
        elif code == v.ROOM_AFTERS:
            if len(self.t.after) < _MOST_AFTER:
                for name in ("after_heads", "after_slots", "after"):
                    self._more(name)
            elif not regs[v.AFTERS]:
                raise ModelTooLargeError
            self._forget_after()
        elif code in _ROOM:
            self._more(_ROOM[code])
        else:
            raise ModelTooLargeError

    def _fill_reaction(self, i: int, key: int) -> None:
        part = self.parts[i]
        inside = self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        if self.absence is not None and seen[-1]:
            over = self.inside_number(i, inside._replace(is_over=True))
            self._put_reactions(key, [(over, 0, v.NO_WRITE)])
            return
        found: dict[tuple[int, int, int], None] = {}
        for reaction, change in self.reactions_to(i, key):
            want, after = reactions.after_reaction(part, inside, reaction)
            number = self.inside_number(i, after)
            ticks = after.down == RUNS and not self.has_ended(i, after)
            if self.absence is not None and part.is_member and reaction.ended:
                change = change[0], (*change[1], TeamCommand(ENDS, part.agent.index, 0, 0))
            found[number, 2 * (want + 2) + ticks, self._write_number(change)] = None
        self._put_reactions(key, found)

    def reactions_to(self, i: int, key: int) -> list[tuple[Reaction, reactions.Change]]:
        """All reactions of a tick of agent i, each with its change of the shared state.

        `key` is what the agent senses (`state_decoding.sense_key`).
        """
        part, inside = self.parts[i], self._insides[i][key & v.MOST_INSIDES - 1]
        choices = {at: sense.choices for at, sense in enumerate(part.senses)}
        sensed, shared = self._sensed(i, key)
        found = part.table.react(inside.local, sensed, shared, choices)
        return [(one, reactions.change_by(part, inside, shared, one)) for one in found]

    def sensed(self, i: int, state: State) -> tuple[tuple[int | None, ...], tuple[int, ...]]:
        """The input values of agent i in a state (None for one that may read anything), and its shared variables."""
        decode(self.t, *self.layout.key(state))
        return self._sensed(i, sense_key(self.t, i))

    def _sensed(self, i: int, key: int) -> tuple[tuple[int | None, ...], tuple[int, ...]]:
        """The same, by what it senses (`state_decoding.sense_key`)."""
        part, inside = self.parts[i], self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        about = key >> v.S_SHARED, inside.load, inside.busy
        read = self._read.get(about)
        if read is None:
            outside = reactions.external_values(part, self._signs_of(i), key, seen[len(part.shared) :])
            read = tuple(
                reactions.read(inside, sense, there) for sense, there in zip(part.senses, outside, strict=True)
            )
            self._read[about] = read
        return read, inside.own or seen[: len(part.shared)]

    def _put_reactions(self, key: int, found: Collection[tuple[int, int, int]]) -> None:
        """Appends the outcomes of a tick."""
        first = self._outcomes
        self._outcomes += len(found)
        self._room("outcomes", self._outcomes * v.OUTCOME)
        rows = [one for row in found for one in row]
        self.t.outcomes[first * v.OUTCOME : self._outcomes * v.OUTCOME] = rows
        self._reactions += 1
        self.t = insert(self.t, "reaction_keys", "reaction_at", self._reactions, key, first << v.S_COUNT | len(found))

    def _fill_silenced(self, i: int, key: int) -> None:
        inside = self._insides[i][key & v.MOST_INSIDES - 1]
        seen = self._seen_tuples[i][key >> v.S_SHARED & v.MOST_SEEN - 1]
        number = self.inside_number(i, reactions.after_silence(self.parts[i], inside, key, seen))
        self._reactions += 1
        self.t = insert(self.t, "reaction_keys", "reaction_at", self._reactions, key, number)

    def _write_number(self, change: reactions.Change) -> int:
        """The number of a change of the shared state; assigns one if it is new."""
        if change == ((), ()):
            return v.NO_WRITE
        number = self._write_numbers.get(change)
        if number is None:
            number = self._write_numbers[change] = self._first_write + len(self._writes)
            self._writes.append(change)
        return number

    def _fill_change(self, number: int, write: int) -> None:
        shared = list(self._shareds[number])
        if write <= 2 * self.houses:
            shared[1 + (write - 1) // 2] += 1 if write % 2 == 0 else -1
        elif write == 1 + 2 * self.houses:
            shared[0] -= 1
        elif write == 2 + 2 * self.houses:
            assert self.agreement is not None, "only a team settles"
            settled = self.agreement.settled(tuple(shared[self._agreed_at :]))
            shared[self._agreed_at :] = self._reduced(settled, shared[0])
        elif write < self._first_write:
            assert self.absence is not None, "only a team that misses members is watched"
            i, what = divmod(write - self._first_watched, self._watched_each)
            agreed = self.absence.after_event(tuple(shared[self._agreed_at :]), self.parts[i].agent.index, what)
            shared[self._agreed_at :] = self._settled(agreed, shared[0])
        else:
            changes, told = self._writes[write - self._first_write]
            for at, value in changes:
                shared[1 + self.houses + at] = value
            if self.agreement is not None and told:
                agreed = self.agreement.after(tuple(shared[self._agreed_at :]), told)
                shared[self._agreed_at :] = self._settled(agreed, shared[0])
        after = self.shared_number(tuple(shared))
        self._changes += 1
        self.t = insert(self.t, "change_keys", "change_to", self._changes, number << v.S_WRITE | write, after)

    def _settled(self, agreed: TeamState, left: int) -> TeamState:
        """A state of the team after all has been agreed on that can be, where that is not left to the end of a step."""
        if self.timing is Timing.LOCKSTEP or self.agreement is None:
            return agreed
        return self._reduced(self.agreement.all_settled(agreed), left)

    def _reduced(self, agreed: TeamState, left: int) -> TeamState:
        """The same without what makes no difference where so many failures are left."""
        return agreed if self.absence is None else self.absence.reduced(agreed, left)

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
            after = self._left_behind(i, inside, which) if which >= ANEW else inside._replace(down=which)
        to = self.inside_number(i, after)
        fixed = self.t.fixed
        self.t.insides[(i * fixed[v.INSIDE_STRIDE] + number) * fixed[v.INSIDE_WIDTH] + column] = to

    def _left_behind(self, i: int, inside: Inside, how: int) -> Inside:
        """The state of agent i once its program restarts (`ANEW`), or once it is `LOST` while it is down.

        Devices that are told to stop by that have stopped, and those of a robot that failed do nothing any more.
        """
        part, busy = self.parts[i], list(inside.busy)
        assert self.absence is not None, "only a team misses members"
        if how == LOST and part.table.is_observed:
            return inside
        first = int(self.run.state.robots.ints[c.ACTUATOR_INDEX][part.agent.index])
        for at, act in enumerate(part.acts):
            k = int(self.run.state.actuators.actuator_index[first + at])
            if act.busy >= 0 and (inside.down == FAILED or (how == ANEW and self.absence.halts(k))):
                busy[act.busy] = 0
        return inside._replace(local=part.table.first, busy=tuple(busy), loose=0)


_MOST_AFTER = 2_000_000
"""The most numbers in the cache of ticks in lockstep; a larger cache is emptied."""
_ROOM = {v.ROOM_MOVES: "moves", v.ROOM_MOVE_SETS: "move_sets", v.ROOM_LOG: "log"}
