"""`AgentHost`: one agent of a fleet, without sockets and clocks: what came and the time in, envelopes out.

It has the agent's machine, its member of the protocol, and a replica of what the team agreed on. A tick is made for
each frame of the body, and only while the robot may act: the right ends a lease after a quorum was heard last, and a
robot that takes a role over waits until the one before it has lost its own (docs/team-protocol.md). Whose body is not
heard for a lease is silent in the team too: a robot without a body cannot play a role.
"""

from __future__ import annotations

from collections import deque

from kitrobot.fleet import notes
from kitrobot.fleet.bodies import MOST_SLOTS, WINDOW, Frame, Reply, Whole
from kitrobot.fleet.following import Following
from kitrobot.fleet.links import TeamLinks
from kitrobot.fleet.replica import Replica
from kitrobot.sim import Event, Simulation, Ticked
from kitrobot.sim.actuation import COMMAND
from kitrobot.sim.columns import A_CELL, ACTUATOR_INDEX, PROGRAM, S_CELL, S_ROBOT
from kitrobot.sim.sharing import SHARED_VALUE
from kitrobot.sim.team_columns import T_ROLE
from kitrobot.team import (
    Charter,
    Member,
    Message,
    Note,
    Noted,
    Quorum,
    Received,
    Refused,
    Seat,
    Sending,
    Time,
    Viewed,
    Write,
    first_state,
    may_act,
    step,
)
from kitrobot.team.changes import Change, Decided, Skipped
from kitrobot.team.events import Event as Input
from kitrobot.team.shared import FIRST_STAMP
from kitrobot.text import Sentence

MOST_PENDING = 12
"""Notes of this agent that are in the protocol at the same time; others wait here."""


class AgentHost:
    """Robot number `me` of a run.

    Args:
        simulation: the whole mission before its first step; this host alone uses it.
        me: the agent's number.
        charter: that of the fleet (see `charter_of`).
        life: how often this agent was started before in this run.
        now: ms by the clock that all its methods are given.

    Attributes:
        sendings: what is to be sent to members, `log`: what is to be told of, since somebody took it out.
        asks: whether a replica is to be asked for, from whoever knows more.
    """

    def __init__(self, simulation: Simulation, me: int, charter: Charter, life: int, now: int) -> None:
        self.replica = Replica(simulation)
        self.me = me
        self.charter = charter
        self.machine = simulation.members[me].machine
        self.links = TeamLinks(self.replica, me)
        self.state: Member = first_state(charter, Seat(me, life), now)
        self.following = Following(self.replica, simulation.state.shared)
        self.sendings: list[Sending] = []
        self.log: list[Event | Sentence] = []
        self.asks = False
        self.muted = False
        self.stopped = False
        self.heard_body_at = now
        self.acts_from = now
        self._serial_ticked = -1
        self._replies: dict[int, Reply] = {}
        self._early: dict[int, Frame] = {}
        self._given: dict[int, int] = {}
        """Of each cell that says whether something is done, the frame in which that was told last."""
        self._serial = life << 32
        self._unsent: deque[Note] = deque()
        self._freeing: set[tuple[int, int, int]] = set()
        self._beginning = 0
        self._units: dict[tuple[int, int, int], int] = {}
        self._effects: list[Noted | Viewed] = []
        self._end_said = -1
        """The epoch in which it said that its program is at its end."""
        state = simulation.state
        ints = state.sensors.ints
        self._own_cells = {
            ints[S_CELL][k] for _, first, last in self.links.banks for k in range(first, last) if ints[S_ROBOT][k] == me
        } | {state.actuators.ints[A_CELL][k] for k in self.links.actuators}
        self._first = self.machine.snapshot()
        self._variables = self.following.cells_of(me)

    # -- the protocol

    def receive(self, now: int, message: Message) -> None:
        """A message of another member came."""
        if not self._is_silent(now):
            self._step(now, Received(message))

    def time(self, now: int) -> None:
        """To be called at least every `Charter.beat`."""
        self._step(now, Time())
        for unit in self.replica.held_units():
            self._units.setdefault(unit, now)
        self._units = {unit: at for unit, at in self._units.items() if unit in set(self.replica.held_units())}
        self._freeing &= set(self._units)
        if self.is_first():
            self._free_units(now)
        self._send_notes(now)

    def is_first(self) -> bool:
        """Whether it is the first of the view: who looks after leases."""
        return self.state.tables.view.seats[0] == self.state.seat

    def may_act(self, now: int) -> bool:
        """Whether the robot may act at this moment, as one of its team; in a new role it also waits for `acts_from`."""
        if self.stopped:
            return False
        if not self.replica.is_of_team(self.me):
            return True
        return may_act(self.charter, self.state, self.me, now)

    def _is_silent(self, now: int) -> bool:
        """Whether it has no radio, or no body."""
        return self.muted or now - self.heard_body_at >= self.charter.lease

    def _free_units(self, now: int) -> None:
        """Asks for units to be free again whose lease is over."""
        for work, robot, grant in self.replica.held_units():
            lease = self.replica.simulation.mission.team.works[work].lease or 0
            over = now - self._units.get((work, robot, grant), now) >= lease * 1000
            if lease and over and (work, robot, grant) not in self._freeing:
                self._freeing.add((work, robot, grant))
                self._note(now, notes.FREE, work, robot, epoch=grant)

    def _note(self, now: int, kind: int, first: int, second: int, epoch: int | None = None) -> None:
        """Puts a note into the log, when there is room."""
        self._serial += 1
        epoch = self.replica.epochs[self.me] if epoch is None else epoch
        self._unsent.append(Note((kind, epoch, first, second, self._serial)))
        self._send_notes(now)

    def _send_notes(self, now: int) -> None:
        while self._unsent and len(self.state.log.pending) < MOST_PENDING:
            self._step(now, self._unsent.popleft())

    def _step(self, now: int, event: Input) -> None:
        stepped = step(self.charter, self.state, now, event)
        self.state = stepped.state
        if not self._is_silent(now):
            self.sendings.extend(stepped.messages)
        for change in stepped.changes:
            self._changed(now, change)

    def _changed(self, now: int, change: Change) -> None:
        match change:
            case Noted() | Viewed():
                self._effects.append(change)
            case Decided(slot=slot):
                effects, self._effects = tuple(self._effects), []
                self.following.decided(slot, effects)
                self._follow(now)
            case Skipped(slot=slot):
                self._effects = []
                self.following.skipped(slot)
                self._follow(now)
            case Quorum(heard=heard):
                self.log.append(
                    Sentence("hears its team") if heard else Sentence("hears too few of its team, and waits")
                )
            case Refused(member=member, why=why):
                self.log.append(Sentence("refused a message of member {member}: {why}", member, why))

    def adopt(self, now: int, whole: Whole) -> None:
        """Another member's replica came, for one that missed slots."""
        if not self.following.is_whole and self.following.adopt(whole):
            self._follow(now)

    def whole(self) -> Whole | None:
        """The replica, for another member; None where this one misses slots itself."""
        if not self.following.is_whole:
            return None
        return Whole(self.replica.slot, tuple(map(tuple, self.replica.packed())))

    def _follow(self, now: int) -> None:
        """Takes in the slots that are known, and draws from them what concerns this robot."""
        team = self.replica.state.team
        of_team = self.replica.is_of_team(self.me)
        role = team.robots[T_ROLE][self.me] if of_team else -1
        self.log.extend(self.following.take_in(self._seen))
        self.asks = not self.following.is_whole
        if self.replica.beginnings[self.me] != self._beginning:
            self._beginning = self.replica.beginnings[self.me]
            self.machine.restore(self._first)
            self.links.forget()
            self._end_said = -1
        if of_team and team.robots[T_ROLE][self.me] not in (role, -1):
            self.acts_from = now + self.charter.hold

    def _seen(self, effect: Noted | Viewed) -> None:
        """One of its own notes has taken effect."""
        if isinstance(effect, Noted) and effect.seat == self.state.seat and len(effect.numbers) == 5:
            serial = effect.numbers[4]
            self.links.waiting = {k: at for k, at in self.links.waiting.items() if at != serial}

    # -- the body

    def frame(self, now: int, frame: Frame) -> list[Reply]:
        """The body sent its readings; gives the answers to it, and to those that came early and follow it."""
        self.heard_body_at = now
        self.muted = frame.muted
        if self._serial_ticked < 0:
            self._serial_ticked = frame.first - 1
        if frame.serial <= self._serial_ticked:
            return [self._replies[frame.serial]] if frame.serial in self._replies else []
        if frame.serial <= self._serial_ticked + WINDOW:
            self._early[frame.serial] = frame
        given = []
        while self._serial_ticked + 1 in self._early:
            self._serial_ticked += 1
            reply = self._answer(now, self._early.pop(self._serial_ticked))
            self._replies[self._serial_ticked] = reply
            self._replies.pop(self._serial_ticked - WINDOW, None)
            given.append(reply)
        return given

    def _answer(self, now: int, frame: Frame) -> Reply:
        """The answer to the next frame."""
        ticked, quiet = None, True
        writes: tuple[tuple[int, int], ...] = ()
        held = not (frame.down or self.may_act(now))
        waits = frame.down or now < self.acts_from
        if not held and not waits:
            ticked, writes, quiet = self._tick(now, frame)
        first, slots = self.following.since(frame.known, MOST_SLOTS)
        return Reply(
            frame.serial,
            self.replica.epochs[self.me],
            held,
            quiet and not waits and not self.links.waiting,
            ticked,
            writes,
            first,
            slots,
            self.whole() if first < 0 else None,
        )

    def _tick(self, now: int, frame: Frame) -> tuple[Ticked, tuple[tuple[int, int], ...], bool]:
        """One tick of the machine: read, react, apply."""
        machine, layout = self.machine, self.machine.layout
        cells = machine.cells
        for cell, value in enumerate(frame.inputs[: layout.inputs], 1):
            if cell not in self._own_cells:
                cells[cell] = 0 if self._given.get(cell, 0) > frame.taken else value
        self.links.read()
        self._share()
        before = machine.snapshot()
        out: list[tuple[int, ...]] = []
        if not machine.ended and not self.links.has_ended():
            machine.tick()
            out = self._commands(now, frame.serial)
        epoch = self.replica.epochs[self.me]
        if machine.ended and not self.links.has_ended() and self._end_said != epoch:
            self._end_said = epoch
            self._note(now, notes.END, 0, 0)
        writes = self._written(now)
        ticked = Ticked(
            tuple(cells[: layout.cells]), tuple(machine.threads[: 2 * len(machine.image.slots)]), tuple(out)
        )
        return ticked, writes, not out and machine.snapshot() == before

    def _commands(self, now: int, serial: int) -> list[tuple[int, ...]]:
        """The commands of the tick, each with the number of its actuator; those to the team go into the log."""
        machine, state = self.machine, self.replica.state
        first = state.robots.ints[ACTUATOR_INDEX][self.me]
        given: list[tuple[int, ...]] = []
        for number in range(machine.image.actuators):
            row = list(machine.out[number * machine.width : (number + 1) * machine.width])
            if not row[0]:
                continue
            given.append((number, *row))
            k = state.actuators.actuator_index[first + number]
            if state.machines.commands[state.robots.ints[PROGRAM][self.me]][COMMAND * row[2] + 2]:
                self._given[state.actuators.ints[A_CELL][k]] = serial
            if k in self.links.actuators:
                wish = self.links.told(k, row)
                if wish is not None:
                    self.links.waiting[k] = self._serial + 1
                    self._note(now, *wish)
        return given

    def _share(self) -> None:
        """Puts what shared variables hold into the cells of the machine."""
        values = self.replica.state.shared.ints[SHARED_VALUE]
        for entry in self.state.store.entries:
            if entry.stamp != FIRST_STAMP:
                values[entry.variable] = entry.value
        for variable, cell in self._variables:
            self.machine.cells[cell] = values[variable]

    def _written(self, now: int) -> tuple[tuple[int, int], ...]:
        """The shared variables that the tick has changed; all others are told."""
        values = self.replica.state.shared.ints[SHARED_VALUE]
        written = [
            (v, self.machine.cells[cell]) for v, cell in self._variables if self.machine.cells[cell] != values[v]
        ]
        for variable, value in written:
            values[variable] = value
            self._step(now, Write(variable, value))
        return tuple(written)

    def stop(self) -> None:
        """The emergency stop: the robot does not act any more in this run."""
        self.stopped = True
