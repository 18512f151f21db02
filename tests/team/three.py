"""Three members of a team as a model for `exploring`: the machines that ship, a network, and programs.

A state is the three members, the letters under way, how far the programs are, and the faults that are still to come.
Letters arrive in any order, those to one that crashed never; one may be lost, or arrive twice; a member may crash (with
or without all that it sent), or be cut off until it is heard again. Time goes on in beats: heartbeats of a beat arrive
in it or, between those that are cut off, not at all. A step of time is as many beats as pass until somebody sends
something else, tells its host something, or gains or loses the right to act in a role.

Members and letters are numbered, and their steps are looked up. After a beat, times are made relative to `NOW`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple, TypeVar

from kitrobot.team import (
    EVERYONE,
    Announce,
    Change,
    Charter,
    Done,
    Event,
    Granted,
    Member,
    Message,
    Received,
    Seat,
    Sending,
    Take,
    Time,
    first_state,
    may_act,
    step,
)
from kitrobot.team.applying import applied
from kitrobot.team.commands import Batch, Command
from kitrobot.team.messages import Ballot, Heartbeat
from kitrobot.team.tables import View, first_tables
from tests.team.exploring import Step
from tests.team.moving import LEASE, NOW, relative
from tests.team.step_laws import step_breaks

SIZE = 3
T = TypeVar("T")

LONGEST = 40
"""Beats that pass at most in one step of time."""
MEMBERS = range(SIZE)


MOST_ROUNDS = 100
"""Of letters that call for letters."""


class Faults(NamedTuple):
    """What may still go wrong, how often; `late`: how often time goes on while letters are under way."""

    lost: int = 0
    doubled: int = 0
    crashes: int = 0
    cuts: int = 0
    late: int = 0


NO_FAULTS = Faults()


class Program(NamedTuple):
    """How far a member's program is: whether it came to the meeting and asked for a unit, the units (unit, number) that
    it was given, and those that it said are done.
    """

    came: bool = False
    asked: bool = False
    given: tuple[tuple[int, int], ...] = ()
    said: tuple[tuple[int, int], ...] = ()


class Team(NamedTuple):
    """A state; `down` has crashed, `cut` is cut off from the others, -1: nobody."""

    members: tuple[int, ...]
    programs: tuple[Program, ...]
    letters: frozenset[int]
    faults: Faults
    down: int = -1
    cut: int = -1


@dataclass(frozen=True)
class Plan:
    """What is explored.

    Attributes:
        answers: for each member what it says in meeting 0; -1: it does not come.
        takers: members that ask for a unit of work 0.
        letters: most letters under way; a step that sends more is not taken.
    """

    charter: Charter
    faults: Faults = NO_FAULTS
    answers: tuple[int, int, int] = (-1, -1, -1)
    takers: tuple[int, ...] = ()
    letters: int = 6


class Effect(NamedTuple):
    """A step of one member: the member after it, the letters it sends, what it tells, a law that it breaks."""

    member: int
    letters: tuple[int, ...]
    told: tuple[Change, ...]
    broken: str


Law = Callable[["Three", Team], bool]


class Three:
    """The model. `laws` hold of states, those of single steps are in `step_breaks`."""

    def __init__(self, plan: Plan, laws: tuple[Law, ...]) -> None:
        self.plan = plan
        self.laws = laws
        self.states: list[Member] = []
        self.letters: list[tuple[int, Message]] = []
        self.numbers: dict[object, int] = {}
        self.effects: dict[tuple[int, object], Effect] = {}
        self.calm: dict[int, int] = {}
        self.known: dict[object, bool] = {}
        self.views: dict[tuple[Batch, ...], View] = {}

    # What is numbered.

    def member(self, state: Member) -> int:
        number = self.numbers.get(state)
        if number is None:
            number = self.numbers[state] = len(self.states)
            self.states.append(state)
        return number

    def letter(self, to: int, message: Message) -> int:
        number = self.numbers.get((to, message))
        if number is None:
            number = self.numbers[to, message] = len(self.letters)
            self.letters.append((to, message))
        return number

    def acting(self, number: int, role: int) -> bool:
        """Whether a member may act in a role now."""
        key = number, role
        if key not in self.known:
            state = self.states[number]
            self.known[key] = may_act(self.plan.charter, state, role, state.now)
        return self.known[key]

    # Steps of one member.

    def effect(self, number: int, event: Event | int, now: int = NOW) -> Effect:
        """A step, looked up where it was made before; an event that is a number is a letter."""
        key = number, (event if now == NOW else (event, now))
        found = self.effects.get(key)
        if found is None:
            before = self.states[number]
            happens: Event = Received(self.letters[event][1]) if isinstance(event, int) else event
            stepped = step(self.plan.charter, before, now, happens)
            spent = stepped.state._replace(spent=(0,) * SIZE)
            letters = tuple(self.sent(before.seat.member, stepped.messages))
            broken = step_breaks(before, stepped)
            found = self.effects[key] = Effect(self.member(spent), letters, stepped.changes, broken)
        return found

    def sent(self, member: int, messages: tuple[Sending, ...]) -> Iterator[int]:
        for to, message in messages:
            for other in MEMBERS if to == EVERYONE else (to,):
                if other != member:
                    yield self.letter(other, message)

    def relative(self, number: int) -> int:
        """The member at `NOW`, with what is long over made equal."""
        if number not in self.calm:
            self.calm[number] = self.member(relative(self.states[number]))
        return self.calm[number]

    # Steps of the team.

    def first(self) -> Team:
        """All have heard each other, and nothing else has happened."""
        started = tuple(self.member(first_state(self.plan.charter, Seat(m, 0), NOW)) for m in MEMBERS)
        team = Team(started, (Program(),) * SIZE, frozenset(), self.plan.faults)
        for _ in range(2 * LEASE):
            team = self.beat(team)[0]
        assert not team.letters
        return team

    def after(self, team: Team, member: int, effect: Effect) -> Team:
        """The team after a step of one member."""
        numbers = team.members
        letters, programs = team.letters, team.programs
        if effect.letters:
            letters = letters.union(
                one
                for one in effect.letters
                for to in (self.letters[one][0],)
                if to != team.down and (team.cut < 0 or team.cut not in (member, to))
            )
        for change in effect.told:
            if isinstance(change, Granted) and change.member == member and change.unit >= 0:
                mine = programs[member]
                unit = change.unit, change.number
                if unit not in mine.given:
                    programs = _with(programs, member, mine._replace(given=(*mine.given, unit)))
        return team._replace(members=_with(numbers, member, effect.member), letters=letters, programs=programs)

    def steps(self, team: Team) -> Iterator[Step[Team]]:
        faults = team.faults
        for letter in team.letters:
            gone = team._replace(letters=team.letters - {letter})
            to = self.letters[letter][0]
            effect = self.effect(team.members[to], letter)
            yield from self.fitting("arrives", letter, self.after(gone, to, effect), effect.broken)
            if faults.lost:
                yield from self.fitting("is lost", letter, gone._replace(faults=faults._replace(lost=faults.lost - 1)))
            if faults.doubled:
                twice = team._replace(faults=faults._replace(doubled=faults.doubled - 1))
                yield from self.fitting(
                    "arrives, and will once more", letter, self.after(twice, to, effect), effect.broken
                )
        for member in MEMBERS:
            if member == team.down:
                continue
            for words, event, program in self.wishes(team, member):
                effect = self.effect(team.members[member], event)
                after = self.after(team._replace(programs=_with(team.programs, member, program)), member, effect)
                yield from self.fitting(f"{member} {words}", -1, after, effect.broken)
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

    def wishes(self, team: Team, member: int) -> Iterator[tuple[str, Event, Program]]:
        """What a program may do next."""
        program = team.programs[member]
        answer = self.plan.answers[member]
        if answer >= 0 and not program.came:
            yield f"comes to the meeting and says {answer}", Announce(0, 0, answer), program._replace(came=True)
        if member in self.plan.takers and not program.asked:
            yield "asks for a unit", Take(0), program._replace(asked=True)
        for unit in program.given:
            if unit not in program.said:
                words = f"says that unit {unit[0]} (holder {unit[1]}) is done"
                yield words, Done(0, *unit), program._replace(said=(*program.said, unit))

    def time(self, team: Team) -> tuple[int, Team, str]:
        """Beats pass until somebody does something at a timeout, or none does for long."""
        rights = self.rights(team)
        after = team
        for beat in range(1, LONGEST + 1):
            after, told, broken = self.beat(after)
            if broken or told or after.letters != team.letters or self.rights(after) != rights or self.breaks(after):
                return beat, after, broken
        return LONGEST, after, ""

    def rights(self, team: Team) -> list[tuple[int, int]]:
        """(role, member) of all that may act."""
        return [
            (role, member)
            for role in range(len(self.plan.charter.roles))
            for member in MEMBERS
            if member != team.down and self.acting(team.members[member], role)
        ]

    def beat(self, team: Team) -> tuple[Team, bool, str]:
        """One beat; whether a host was told something; a law that was broken."""
        now, told, broken = NOW + self.plan.charter.beat, False, ""
        heartbeats: list[tuple[int, int]] = []
        running = [member for member in MEMBERS if member != team.down]

        def stepped(member: int, event: Event | int) -> None:
            nonlocal team, told, broken
            effect = self.effect(team.members[member], event, now)
            told, broken = told or bool(effect.told), broken or effect.broken
            beats = [one for one in effect.letters if isinstance(self.letters[one][1], Heartbeat)]
            heartbeats.extend((member, one) for one in beats)
            team = self.after(team, member, effect._replace(letters=tuple(x for x in effect.letters if x not in beats)))

        for member in running:
            stepped(member, Time())
        for sender, letter in list(heartbeats):
            to = self.letters[letter][0]
            if to in running and team.cut not in (sender, to):
                stepped(to, letter)
        return team._replace(members=tuple(self.relative(number) for number in team.members)), told, broken

    def quiet(self, team: Team) -> Team:
        """The team when every letter has arrived, in the order of sending, and every program has gone on."""
        for _ in range(MOST_ROUNDS):
            for letter in sorted(team.letters):
                to = self.letters[letter][0]
                team = team._replace(letters=team.letters - {letter})
                team = self.after(team, to, self.effect(team.members[to], letter))
            for member in MEMBERS:
                for _, event, program in self.wishes(team, member) if member != team.down else ():
                    team = team._replace(programs=_with(team.programs, member, program))
                    team = self.after(team, member, self.effect(team.members[member], event))
            if not team.letters:
                return team
        raise AssertionError("letters call for letters without end")

    def view(self, decided: tuple[Batch, ...]) -> View:
        """The view that these slots, the first ones of the log, have made."""
        if decided not in self.views:
            tables = first_tables(self.plan.charter)
            for value in decided:
                tables, _ = applied(self.plan.charter, tables, value)
            self.views[decided] = tables.view
        return self.views[decided]

    # Laws and words.

    def breaks(self, team: Team) -> bool:
        return any(not law(self, team) for law in self.laws)

    def broken(self, team: Team) -> str:
        return next((_named(law) for law in self.laws if not law(self, team)), "")

    def tell(self, letter: int, words: str) -> str:
        if letter < 0:
            return words
        to, message = self.letters[letter]
        rest = ", ".join(
            f"{name} {_plain(getattr(message, name))}" for name in type(message).__slots__ if name != "sender"
        )
        return f"{type(message).__name__} of {message.sender.member} to {to} ({rest}) {words}"


def _plain(value: object) -> str:
    if isinstance(value, Command):
        return f"{value.body!r} of {value.seat.member}"
    if isinstance(value, Ballot):
        return f"{value.round}.{value.rank}"
    return "[" + ", ".join(map(_plain, value)) + "]" if isinstance(value, tuple) else repr(value)


def _named(law: Law) -> str:
    return law.__name__.replace("_", " ")


def _with(row: tuple[T, ...], index: int, value: T) -> tuple[T, ...]:
    return (*row[:index], value, *row[index + 1 :])
