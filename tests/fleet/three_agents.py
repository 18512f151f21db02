"""Three agents of a fleet as a model for `exploring`: the hosts that ship, a network, and faults.

A state is the three agents, the letters under way, and the faults that are still to come. An agent is an `AgentHost`:
its member of the protocol, its replica of the team's tables, the machine that runs its program, the notes that it waits
for and the leases that it watches. Letters arrive in any order, those to one that crashed never; one may be lost, or
arrive twice; an agent may crash (with or without all that it sent), or be cut off until it is heard again.

A program goes on in one step until it gives a note or waits. Time goes on in beats: heartbeats of a beat arrive in it
or, between those that are cut off, not at all. A step of time is as many beats as pass until somebody sends something
else, takes a slot in, or gains or loses the right to act in a role.

Agents and letters are numbered, and their steps are looked up. After a beat, times are made relative to `NOW`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple, TypeVar

from kitrobot.fleet.body_messages import Frame
from kitrobot.fleet.charter import charter_of
from kitrobot.fleet.host import AgentHost
from kitrobot.fleet.replica import Effect
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import T_ROLE, T_SEAT
from kitrobot.sim.team.meetings import find_members
from kitrobot.team.commands import Batch, Command, Note
from kitrobot.team.messages import EVERYONE, Ballot, Heartbeat, Message, OutgoingMessage
from kitrobot.team.state import Member
from kitrobot.team.table_transitions import apply_batch
from kitrobot.team.tables import View, initial_tables
from tests.fleet.slot_laws import before_effect, slot_breaks
from tests.team.relative_time import LEASE, NOW, relative
from tests.team.state_exploration import Step

SIZE = 3
MEMBERS = range(SIZE)
T = TypeVar("T")

LONGEST = 60
"""Beats that pass at most in one step of time."""

MOST_ROUNDS = 200
"""Of letters that call for letters."""

MOST_TICKS = 40
"""Ticks of a program in one step."""


class Faults(NamedTuple):
    """What may still go wrong, how often; `late`: how often time goes on while letters are under way."""

    lost: int = 0
    doubled: int = 0
    crashes: int = 0
    cuts: int = 0
    late: int = 0


NO_FAULTS = Faults()


class Agent(NamedTuple):
    """An `AgentHost` as a value; each field holds the attribute of that name, or what `restore` says."""

    state: Member
    slot: int
    rows: tuple[tuple[int, ...], ...]
    machine: tuple[tuple[int, ...], ...]
    waiting: tuple[tuple[int, int], ...]
    joins: bool
    acts_from: int
    units: tuple[tuple[tuple[int, int, int], int], ...]
    freeing: frozenset[tuple[int, int, int]]
    beginning: int
    end_said: int
    serial: int
    unsent: tuple[Note, ...]


class Team(NamedTuple):
    """A state; `down` has crashed, `cut` is cut off from the others, -1: nobody."""

    agents: tuple[int, ...]
    letters: frozenset[int]
    faults: Faults
    down: int = -1
    cut: int = -1


@dataclass(frozen=True)
class Plan:
    """What is explored.

    Attributes:
        mission: makes the run before its first step.
        letters: most letters under way; a step that sends more is not taken.
        prompt: whether a program goes on at once when something happened to its agent; else at any time later too.
        unit_lease_ms: how long a unit of work may be held; 0: for good.
    """

    mission: Callable[[], Simulation]
    faults: Faults = NO_FAULTS
    letters: int = 6
    prompt: bool = False
    unit_lease_ms: int = 0


class Reaction(NamedTuple):
    """A step of one agent: the agent after it, the letters it sends, whether it took a slot in, a law it breaks."""

    agent: int
    letters: tuple[int, ...]
    told: bool
    broken: str


Law = Callable[["ThreeAgents", Team], bool]


class Bench:
    """One host that takes the form of any state of its agent."""

    def __init__(self, plan: Plan, me: int) -> None:
        simulation = plan.mission()
        if plan.unit_lease_ms:
            works = [replace(work, lease=plan.unit_lease_ms / 1000) for work in simulation.mission.team.works]  # type: ignore[arg-type]
            simulation.mission = replace(simulation.mission, team=replace(simulation.mission.team, works=works))
        self.charter = charter_of(simulation, LEASE)
        self.host = AgentHost(simulation, me, self.charter, 0, NOW)
        self.broken = ""
        self.slots = 0
        self._apply = self.host.replica.apply
        self.host.replica.apply = self._watch  # type: ignore[method-assign]
        self._rows: tuple[tuple[int, ...], ...] | None = None

    def _watch(self, slot: int, effects: Iterable[Effect]) -> list[Event]:
        """Takes a slot in, effect by effect, and holds each against the laws."""
        replica, events = self.host.replica, list[Event]()
        for effect in effects:
            before = before_effect(replica)
            events += self._apply(slot, (effect,))
            self.broken = self.broken or slot_breaks(before, effect, replica)
            replica.slot = slot
        if replica.slot == slot:
            events += self._apply(slot, ())
        self.slots += 1
        return events

    def read(self) -> Agent:
        """The host as a value."""
        host = self.host
        self._rows = tuple(map(tuple, host.replica.packed()))
        return Agent(
            host.state._replace(spent=(0,) * SIZE),
            host.replica.slot,
            self._rows,
            tuple(map(tuple, host.machine.snapshot())),
            tuple(sorted(host.team_devices.waiting.items())),
            host.team_devices.joins,
            host.acts_from,
            tuple(sorted(host._units.items())),
            frozenset(host._freeing),
            host._beginning,
            host._end_reported,
            host._serial,
            tuple(host._unsent),
        )

    def restore(self, agent: Agent, now: int) -> None:
        """Gives the host a form that `read` gave."""
        host, replica = self.host, self.host.replica
        if agent.rows != self._rows:
            for own, row in zip(replica._rows(), agent.rows, strict=True):
                own[:] = row
            find_members(replica.state.team)
            replica.state.team.numbers[:] = agent.rows[0]
            self._rows = agent.rows
        replica.slot = agent.slot
        host.replication._known = agent.slot
        host.replication._ahead.clear()
        host.replication._recent.clear()
        host.state = agent.state
        host.machine.restore(tuple(map(list, agent.machine)))  # type: ignore[arg-type]
        host.team_devices.waiting = dict(agent.waiting)
        host.team_devices.joins = agent.joins
        host.acts_from = agent.acts_from
        host._units = dict(agent.units)
        host._freeing = set(agent.freeing)
        host._beginning = agent.beginning
        host._end_reported = agent.end_said
        host._serial = agent.serial
        host._unsent.clear()
        host._unsent.extend(agent.unsent)
        host.body_heard_at = now
        host.sendings, host.log, host._effects = [], [], []
        self.broken, self.slots = "", 0
        # Serials of frames only keep their order; each step begins with the first one.
        host._serial_ticked, host._tick = 0, None
        host._replies.clear()
        host._early.clear()
        host._tick_runner._given.clear()

    def go_on(self, now: int) -> None:
        """Ticks of the program until it gives a note, waits, or may not act."""
        host = self.host
        inputs = (0,) * host.machine.layout.inputs
        for serial in range(1, MOST_TICKS):
            (reply,) = host.frame(now, Frame(serial, host.replica.slot, False, False, inputs, serial))
            if reply.ticked is None or reply.quiet or host.sendings or host.team_devices.waiting or self.slots:
                break
        host.replies = []


class ThreeAgents:
    """The model. `laws` hold of states; those of slots are in `slot_laws`."""

    def __init__(self, plan: Plan, laws: tuple[Law, ...]) -> None:
        self.plan = plan
        self.laws = laws
        self.are_prompt = False
        self.benches = [Bench(plan, me) for me in MEMBERS]
        self.begun = [bench.read() for bench in self.benches]
        self.charter = self.benches[0].charter
        self.states: list[Agent] = []
        self.letters: list[tuple[int, Message]] = []
        self.numbers: dict[object, int] = {}
        self.reactions: dict[tuple[int, object, int], Reaction] = {}
        self.calm: dict[int, int] = {}
        self.beats: dict[Team, tuple[Team, bool, str]] = {}
        self.known: dict[object, Any] = {}
        self.views: dict[tuple[Batch, ...], View] = {}

    # What is numbered.

    def agent(self, value: Agent) -> int:
        number = self.numbers.get(value)
        if number is None:
            number = self.numbers[value] = len(self.states)
            self.states.append(value)
        return number

    def letter(self, to: int, message: Message) -> int:
        number = self.numbers.get((to, message))
        if number is None:
            number = self.numbers[to, message] = len(self.letters)
            self.letters.append((to, message))
        return number

    def seat(self, member: int, number: int) -> int:
        """The place in the team in which an agent may act now, as it knows the team; -1: none."""
        key = "seat", member, number
        if key not in self.known:
            bench = self.benches[member]
            bench.restore(self.states[number], NOW)
            robots = bench.host.replica.state.team.robots
            acts = robots[T_ROLE][member] >= 0 and bench.host.acts_from <= NOW and bench.host.may_act(NOW)
            self.known[key] = robots[T_SEAT][member] if acts else -1
        found: int = self.known[key]
        return found

    # Steps of one agent.

    def reaction(self, member: int, number: int, what: str | int, now: int = NOW) -> Reaction:
        """A step, looked up where it was made before: a letter by its number, "time", or "program".

        Where programs are prompt, the program goes on in the same step.
        """
        key = number, what, now
        found = self.reactions.get(key)
        if found is None:
            bench = self.benches[member]
            bench.restore(self.states[number], now)
            if what == "time":
                bench.host.time(now)
            elif isinstance(what, int):
                bench.host.receive(now, self.letters[what][1])
            if what == "program" or self.are_prompt:
                bench.go_on(now)
            letters = tuple(self.sent(member, bench.host.sendings))
            broken = bench.broken
            if any(str(said).startswith("refused") for said in bench.host.log):
                broken = "no message of an agent that follows the protocol is refused"
            after = self.agent(bench.read())
            found = self.reactions[key] = Reaction(after, letters, bench.slots > 0, broken)
        return found

    def sent(self, member: int, messages: Sequence[OutgoingMessage]) -> Iterator[int]:
        for to, message in messages:
            for other in MEMBERS if to == EVERYONE else (to,):
                if other != member:
                    yield self.letter(other, message)

    def relative(self, number: int) -> int:
        """The agent at `NOW`, with what is long over made equal."""
        if number not in self.calm:
            agent = self.states[number]
            ms = NOW - agent.state.now
            units = tuple((unit, max(at + ms, NOW - 4 * LEASE)) for unit, at in agent.units)
            acts_from = max(agent.acts_from + ms, NOW)
            self.calm[number] = self.agent(
                agent._replace(state=relative(agent.state), units=units, acts_from=acts_from)
            )
        return self.calm[number]

    # Steps of the team.

    def first(self) -> Team:
        """All have heard each other, and nothing else has happened."""
        self.are_prompt = False
        self.reactions.clear()
        started = tuple(map(self.agent, self.begun))
        team = Team(started, frozenset(), self.plan.faults)
        for _ in range(2 * LEASE):
            team = self.beat(team)[0]
        assert not team.letters
        self.are_prompt = self.plan.prompt
        self.reactions.clear()
        self.beats.clear()
        return team

    def after(self, team: Team, member: int, reaction: Reaction) -> Team:
        """The team after a step of one agent."""
        letters = team.letters
        if not reaction.letters and reaction.agent == team.agents[member]:
            return team
        if reaction.letters:
            letters = letters.union(
                one
                for one in reaction.letters
                for to in (self.letters[one][0],)
                if to != team.down and (team.cut < 0 or team.cut not in (member, to))
            )
        return Team(_with(team.agents, member, reaction.agent), letters, team.faults, team.down, team.cut)

    def steps(self, team: Team) -> Iterator[Step[Team]]:
        faults = team.faults
        for letter in team.letters:
            gone = team._replace(letters=team.letters - {letter})
            to = self.letters[letter][0]
            reaction = self.reaction(to, team.agents[to], letter)
            yield from self.fitting("arrives", letter, self.after(gone, to, reaction), reaction.broken)
            if faults.lost:
                yield from self.fitting("is lost", letter, gone._replace(faults=faults._replace(lost=faults.lost - 1)))
            if faults.doubled:
                twice = team._replace(faults=faults._replace(doubled=faults.doubled - 1))
                words = "arrives, and will once more"
                yield from self.fitting(words, letter, self.after(twice, to, reaction), reaction.broken)
        for member in MEMBERS:
            if member == team.down:
                continue
            reaction = self.reaction(member, team.agents[member], "program")
            if reaction.agent != team.agents[member]:
                words = f"the program of {member} goes on"
                yield from self.fitting(words, -1, self.after(team, member, reaction), reaction.broken)
            if faults.crashes:
                left = faults._replace(crashes=faults.crashes - 1)
                letters = frozenset(one for one in team.letters if self.letters[one][0] != member)
                crashed = team._replace(down=member, letters=letters, faults=left)
                yield Step(partial(str, f"{member} crashes"), crashed)
                own = frozenset(one for one in letters if self.letters[one][1].sender.member == member)
                if own:
                    words = f"{member} crashes, and what it sent is lost"
                    yield Step(partial(str, words), crashed._replace(letters=letters - own))
            if faults.cuts and team.cut < 0:
                left = faults._replace(cuts=faults.cuts - 1)
                yield Step(partial(str, f"{member} is cut off from the others"), team._replace(cut=member, faults=left))
        if team.cut >= 0:
            yield Step(partial(str, f"{team.cut} is in reach of the others again"), team._replace(cut=-1))
        if not team.letters or faults.late:
            beats, after, broken = self.time(team)
            if team.letters:
                after = after._replace(faults=after.faults._replace(late=after.faults.late - 1))
            yield from self.fitting(f"{beats} beats pass", -1, after, broken)

    def fitting(self, words: str, letter: int, team: Team, broken: str = "") -> Iterator[Step[Team]]:
        """The step, if no more letters are under way than there may be."""
        if len(team.letters) <= self.plan.letters:
            yield Step(partial(self.tell, letter, words), team, broken)

    def time(self, team: Team) -> tuple[int, Team, str]:
        """Beats pass until somebody does something at a timeout, or none does for long."""
        rights = self.rights(team)
        after = team
        for beat in range(1, LONGEST + 1):
            after, told, broken = self.beat(after)
            if broken or told or after.letters != team.letters or self.rights(after) != rights or self.breaks(after):
                return beat, after, broken
        return LONGEST, after, ""

    def rights(self, team: Team) -> list[int]:
        """The places in the team in which agents may act."""
        return [self.seat(member, team.agents[member]) for member in MEMBERS if member != team.down]

    def beat(self, team: Team) -> tuple[Team, bool, str]:
        """One beat; whether somebody took a slot in; a law that was broken. Looked up where it was made before."""
        calm = Team(team.agents, frozenset(), NO_FAULTS, team.down, team.cut)
        found = self.beats.get(calm)
        if found is None:
            found = self.beats[calm] = self.first_beat(calm)
        after, told, broken = found
        return Team(after.agents, after.letters | team.letters, team.faults, team.down, team.cut), told, broken

    def first_beat(self, team: Team) -> tuple[Team, bool, str]:
        """A beat that was not made before."""
        now, told, broken = NOW + self.charter.beat, False, ""
        heartbeats: list[tuple[int, int]] = []
        running = [member for member in MEMBERS if member != team.down]

        def stepped(member: int, what: str | int) -> None:
            nonlocal team, told, broken
            reaction = self.reaction(member, team.agents[member], what, now)
            told, broken = told or reaction.told, broken or reaction.broken
            beats = [one for one in reaction.letters if isinstance(self.letters[one][1], Heartbeat)]
            heartbeats.extend((member, one) for one in beats)
            others = tuple(one for one in reaction.letters if one not in beats)
            team = self.after(team, member, reaction._replace(letters=others))

        for member in running:
            stepped(member, "time")
        for sender, letter in list(heartbeats):
            to = self.letters[letter][0]
            if to in running and team.cut not in (sender, to):
                stepped(to, letter)
        return team._replace(agents=tuple(self.relative(number) for number in team.agents)), told, broken

    def quiet(self, team: Team) -> Team:
        """The team when every letter has arrived, in the order of sending, and every program has gone on."""
        for _ in range(MOST_ROUNDS):
            before = team
            for letter in sorted(team.letters):
                to = self.letters[letter][0]
                team = Team(team.agents, team.letters - {letter}, team.faults, team.down, team.cut)
                team = self.after(team, to, self.reaction(to, team.agents[to], letter))
            for member in MEMBERS:
                if member != team.down:
                    team = self.after(team, member, self.reaction(member, team.agents[member], "program"))
            if team == before:
                return team
        raise AssertionError("letters call for letters without end")

    def view(self, decided: tuple[Batch, ...]) -> View:
        """The view that these slots, the first ones of the log, have made."""
        if decided not in self.views:
            tables = initial_tables(self.charter)
            for value in decided:
                tables, _ = apply_batch(tables, value)
            self.views[decided] = tables.view
        return self.views[decided]

    # Laws and words.

    def breaks(self, team: Team) -> bool:
        return any(not law(self, team) for law in self.laws)

    def broken(self, team: Team) -> str:
        return next((law.__name__.replace("_", " ") for law in self.laws if not law(self, team)), "")

    def tell(self, letter: int, words: str) -> str:
        if letter < 0:
            return words
        to, message = self.letters[letter]
        rest = ", ".join(
            f"{name} {_plain(getattr(message, name))}" for name in message.__struct_fields__ if name != "sender"
        )
        return f"{type(message).__name__} of {message.sender.member} to {to} ({rest}) {words}"


def _plain(value: object) -> str:
    if isinstance(value, Command):
        return f"{value.body!r} of {value.seat.member}"
    if isinstance(value, Ballot):
        return f"{value.round}.{value.rank}"
    return "[" + ", ".join(map(_plain, value)) + "]" if isinstance(value, tuple) else repr(value)


def _with(row: tuple[T, ...], index: int, value: T) -> tuple[T, ...]:
    return (*row[:index], value, *row[index + 1 :])
