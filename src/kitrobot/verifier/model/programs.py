"""Programs as transition tables: the result of one tick for each program state and each set of sensed values.

The interpreter itself (`kitrobot_onboard.interpreter.tick`) computes a reaction, once for each pair of state and sensed
values that comes up. There is no second meaning of a program.

A *local state* is everything that can change in an image except its inputs and its shared variables: the live cells
(whose value may still be read), the position of each thread, which parallels are active and which stops are armed. Of
two states that differ only in dead cells, one is stored.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import compress

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.instructions import ACT, BY_NUMBER, CLAMP, END, EQ, FORK, LT, Role
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.stops import stops_in

MOST_OUTCOMES = 4096
"""Reactions to the values that one robot may sense in one state, at most."""


class AbstractionError(KitRobotError):
    """A part of a mission has no discrete form that can be explored."""


_DIRECTIONS = (0, 1, -1)
"""The directions of the procedures of wheels: stop, forward, back."""


def direction_on_road(procedure: int, agent: str, part: str, name: str) -> int:
    """The direction in which a procedure of wheels moves a robot along its road.

    Raises:
        AbstractionError: it ends by itself after a length; the model has no lengths there.
    """
    if procedure < len(_DIRECTIONS):
        return _DIRECTIONS[procedure]
    raise AbstractionError(
        Sentence(
            "`{agent}` drives a distance or turns on a road (`{call}`), and Check knows no lengths there",
            agent,
            f"{part}.{name}",
        ),
        Sentence("let it drive on until a sensor says where it is"),
    )


@dataclass(frozen=True, slots=True)
class Reaction:
    """The result of one tick: the state after it, its commands, and the shared variables after it.

    Attributes:
        local: the number of the local state after the tick.
        commands: (actuator, command, first argument) in the order of the actuators; 0 where there is no argument.
        seconds: of each command its second argument; 0 where there is none.
        more: of each command the arguments behind these.
        shared: the values of the robot's shared variables after the tick, in the order of its XML.
        ended: whether the program has ended.
        stops: the bits of actuators that were stopped, and of those that go on although a marked action's parallel
            is over (`stops.stops_in`).
    """

    local: int
    commands: tuple[tuple[int, int, int], ...]
    shared: tuple[int, ...]
    ended: bool
    seconds: tuple[int, ...] = ()
    stops: tuple[int, int] = (0, 0)
    more: tuple[tuple[int, ...], ...] = ()


class ProgramTable:
    """The reactions of one program, computed on demand.

    Args:
        image: the program.
        robot: the robot that it runs on.
        observed: names of variables that properties read, so that they are never dead.
    """

    def __init__(self, image: Image, robot: Robot, observed: Collection[str] = ()) -> None:
        self.machine = Machine(image, robot, watch=True)
        layout = self.machine.layout
        self.inputs = layout.inputs
        """Sensors, then one flag for each actuator that takes longer."""
        self.shared = [layout.variables[one.name] for one in robot.variables if one.shared]
        self._reads = _cells_read(image)
        self._read_by: dict[tuple[int, ...], frozenset[int]] = {}
        """The cells that are read where these instructions run."""
        self._apart = {*range(1, 1 + layout.inputs), *self.shared}
        self._observed = {layout.variables[name] for name in observed if name in layout.variables}
        self._live = live_cells(image)
        self._dead: dict[tuple[int, ...], list[int]] = {}
        slots = 2 * len(image.slots)
        at_slots = 4 + 2 * slots
        at_parallels = at_slots + 5 * len(image.parallels)
        stops = at_parallels + 3 * len(image.stops)
        self._at_threads = image.first_constant
        """The place of the threads in a local state, behind the cells."""
        self._at_pars = self._at_threads + slots
        self._at_stops = self._at_pars + len(image.parallels)
        self._threads, self._active = slice(0, slots), slice(at_slots, at_parallels, 5)
        self._armed = slice(at_parallels, stops, 3)
        self._numbers: dict[tuple[int, ...], int] = {}
        self._locals: list[tuple[int, ...]] = []
        self._known: dict[tuple[int, tuple[int | None, ...], tuple[int, ...]], tuple[Reaction, ...]] = {}
        self.first_shared = tuple(int(self.machine.cells[cell]) for cell in self.shared)
        self.first = self.current()
        self.may_end = _may_end(image)
        """Whether the program can come to its end."""
        self.ticks = 0
        """The number of ticks that the interpreter computed."""

    @property
    def is_observed(self) -> bool:
        """Whether properties read any of its variables."""
        return bool(self._observed)

    def __len__(self) -> int:
        """How many local states have come up."""
        return len(self._locals)

    def value(self, local: int, cell: int) -> int:
        """What a cell of the robot's own holds in a local state; it must be one of `observed`."""
        return self._locals[local][cell]

    def has_ended(self, local: int) -> bool:
        """Whether the program has ended in a local state."""
        return self._locals[local][self._at_threads] < 0

    def places(self, local: int) -> list[tuple[int, int]]:
        """(slot, instruction) of each live thread."""
        self._restore(local)
        return self.machine.active()

    def react(
        self,
        local: int,
        sensed: tuple[int | None, ...],
        shared: tuple[int, ...],
        choices: Mapping[int, Sequence[int]],
    ) -> tuple[Reaction, ...]:
        """All reactions that one tick can have.

        Args:
            local: the local state before it.
            sensed: the value of each input; None for one that may be any of its `choices`.
            shared: the values of the shared variables.
            choices: of each input without a value (counted from 0) the values to try.

        Raises:
            AbstractionError: there are more than `MOST_OUTCOMES`.
        """
        key = local, sensed, shared
        known = self._known.get(key)
        if known is None:
            tried = (reaction for reaction, _ in self.tries(local, sensed, shared, choices))
            known = self._known[key] = tuple(dict.fromkeys(tried))
        return known

    def tries(
        self,
        local: int,
        sensed: tuple[int | None, ...],
        shared: tuple[int, ...],
        choices: Mapping[int, Sequence[int]],
    ) -> Iterator[tuple[Reaction, dict[int, int]]]:
        """The same, one after another, each with the values that were chosen, by input: only those that the tick reads,
        since any other makes no difference.
        """
        waiting: list[dict[int, int]] = [{}]
        tried = 0
        while waiting:
            chosen = waiting.pop()
            reaction, read = self.run_tick(local, sensed, shared, chosen)
            open_ones = [at for at, value in enumerate(sensed) if value is None and at not in chosen and at + 1 in read]
            if not open_ones:
                yield reaction, chosen
                continue
            at = open_ones[0]
            tried += len(choices[at])
            if tried > MOST_OUTCOMES:
                raise AbstractionError(
                    Sentence("`{robot}` may read too many different values at once", self.machine.robot.name),
                    Sentence("compare a sensor with numbers instead of copying its value into a variable"),
                )
            waiting += [{**chosen, at: value} for value in choices[at]]

    def run_tick(
        self, local: int, sensed: tuple[int | None, ...], shared: tuple[int, ...], chosen: Mapping[int, int]
    ) -> tuple[Reaction, frozenset[int]]:
        """One tick of the machine, with these values where several are possible; also the cells that it read."""
        machine = self.machine
        self._restore(local)
        cells = machine.cells
        for at, value in enumerate(sensed):
            cells[1 + at] = chosen.get(at, 0) if value is None else value
        for cell, value in zip(self.shared, shared, strict=True):
            cells[cell] = value
        armed = machine.pars[:] if machine.image.stops else ()
        commanded = self._run(machine)
        stops = stops_in(armed, machine)
        commands = tuple(
            (machine.layout.commands[machine.out[at + 2]][0], machine.out[at + 2], self._argument(at, 0))
            for at in commanded
        )
        seconds = tuple(self._argument(at, 1) for at in commanded)
        self.ticks += 1
        ran = tuple(machine.seen)
        read = self._read_by.get(ran)
        if read is None:
            read = self._read_by[ran] = frozenset[int]().union(*compress(self._reads, ran))
        after = tuple(int(cells[cell]) for cell in self.shared)
        more = tuple(tuple(machine.out[at + 5 : at + 3 + self._arguments(at)]) for at in commanded)
        return Reaction(self.current(), commands, after, machine.ended, seconds, stops, more), read

    def _arguments(self, at: int) -> int:
        """How many arguments the command has that begins there in `out`."""
        machine = self.machine
        _, actuator, procedure = machine.layout.commands[machine.out[at + 2]]
        return len(machine.robot.calls[actuator, procedure][1].parameters)

    def _argument(self, at: int, number: int) -> int:
        return int(self.machine.out[at + 3 + number]) if self._arguments(at) > number else 0

    @staticmethod
    def _run(machine: Machine) -> list[int]:
        """Runs one tick of the machine; returns the places of the commands in `out`."""
        machine.run_tick()
        return [at for at in range(0, machine.width * machine.image.actuators, machine.width) if machine.out[at]]

    def current(self) -> int:
        """The number of the local state that the machine is in."""
        cells, threads, pars = self.machine.cells[: self._at_threads], self.machine.threads, self.machine.pars
        for cell in self._dead_at(tuple(threads[self._threads][::2])):
            cells[cell] = 0
        local = (*cells, *threads[self._threads], *pars[self._active], *pars[self._armed])
        number = self._numbers.get(local)
        if number is None:
            number = self._numbers[local] = len(self._locals)
            self._locals.append(local)
        return number

    def _restore(self, local: int) -> None:
        """Puts the machine into a local state; its constants and the records of the image are as ever."""
        machine, numbers = self.machine, self._locals[local]
        machine.cells[: self._at_threads] = numbers[: self._at_threads]
        machine.threads[self._threads] = numbers[self._at_threads : self._at_pars]
        machine.pars[self._active] = numbers[self._at_pars : self._at_stops]
        machine.pars[self._armed] = numbers[self._at_stops :]

    def _dead_at(self, places: tuple[int, ...]) -> list[int]:
        """The cells that are left out of a local state where the threads stand there (-1: not running)."""
        found = self._dead.get(places)
        if found is None:
            live = self._observed.union(*(self._live[pc] for pc in places if pc >= 0)) - self._apart
            count = self.machine.image.first_constant
            found = self._dead[places] = [cell for cell in range(count) if cell not in live]
        return found


def _operands(image: Image) -> Iterator[tuple[int, int, int, int]]:
    code = image.code
    for at in range(0, len(code), 4):
        yield code[at], code[at + 1], code[at + 2], code[at + 3]


@lru_cache(64)
def _cells_read(image: Image) -> tuple[frozenset[int], ...]:
    """The cells that each instruction reads."""
    found = []
    for number, a, b, c in _operands(image):
        op = BY_NUMBER[number]
        read = {cell for role, cell in ((op.a, a), (op.b, b), (op.c, c)) if role is Role.READ}
        if number == CLAMP:
            read.add(a)
        elif number == ACT:
            read.update(range(b, b + c))
        found.append(frozenset(read))
    return tuple(found)


@lru_cache(64)
def _following(image: Image) -> tuple[tuple[int, ...], ...]:
    """Of each instruction, those that may come next, in its thread or as the first of a branch that it starts."""
    found = []
    for pc, (number, a, b, c) in enumerate(_operands(image)):
        op = BY_NUMBER[number]
        nexts = [pc + 1] if op.falls_through else []
        if op.jumps:
            nexts.append(b + 256 * c)
        if number == FORK:
            nexts += [slot.entry for slot in image.slots if slot.parallel == a]
        found.append(tuple(nexts))
    return tuple(found)


def _may_end(image: Image) -> bool:
    """Whether the program's own thread can come to an END, as far as its jumps say."""
    following, code = _following(image), image.code
    seen, waiting = {image.slots[0].entry}, [image.slots[0].entry]
    while waiting:
        pc = waiting.pop()
        if code[4 * pc] == END:
            return True
        nexts = following[pc][:1] if code[4 * pc] == FORK else following[pc]
        waiting += [to for to in nexts if to not in seen]
        seen.update(nexts)
    return False


@lru_cache(64)
def live_cells(image: Image) -> tuple[frozenset[int], ...]:
    """Of each instruction, the cells that the thread which comes to it, and those that it starts, may still read
    before they are written.
    """
    reads = _cells_read(image)
    following = _following(image)
    # CLAMP writes what it reads, and the fault flag now and then: neither makes a cell dead.
    writes = [
        a if BY_NUMBER[number].a is Role.WRITTEN and number != CLAMP else -1 for number, a, _, _ in _operands(image)
    ]
    live: list[frozenset[int]] = [frozenset()] * len(reads)
    changed = True
    while changed:
        changed = False
        for pc in range(len(reads) - 1, -1, -1):
            after = frozenset().union(*(live[to] for to in following[pc]))
            now = (after - {writes[pc]}) | reads[pc]
            if now != live[pc]:
                live[pc] = now
                changed = True
    return tuple(live)


def value_classes(image: Image, cell: int, least: int, most: int) -> tuple[int, ...]:
    """Values of an input between `least` and `most`, one of each class that the program can tell apart.

    Where the input is compared with constants only, the constants cut its range into classes; where its value goes
    anywhere else (a variable, a sum, an argument, a comparison with another cell), each value is a class of its own.
    """
    cuts = {least}
    for number, a, b, c in _operands(image):
        op = BY_NUMBER[number]
        roles = (op.a, a), (op.b, b), (op.c, c)
        used = [at for at, (role, operand) in enumerate(roles) if role is Role.READ and operand == cell]
        if number == ACT and b <= cell < b + c:
            return tuple(range(least, most + 1))
        if not used:
            continue
        if op.jumps or op.name == "NOT":
            cuts |= {0, 1}
            continue
        other = roles[3 - used[0]][1] if number in (EQ, LT) else -1
        if other < image.first_constant:
            return tuple(range(least, most + 1))
        constant = image.cells[other]
        cuts |= {constant, constant + 1}
    return tuple(sorted(value for value in cuts if least <= value <= most))


def greatest_argument(image: Image, command: int, most: int) -> int:
    """The greatest first argument that a program can give to a command; `most` where it is computed."""
    writers: dict[int, list[int]] = {}
    for number, a, b, _ in _operands(image):
        if BY_NUMBER[number].a is Role.WRITTEN:
            writers.setdefault(a, []).append(b if BY_NUMBER[number].name == "MOV" else -1)
    greatest = 0
    for number, a, b, c in _operands(image):
        if number != ACT or a != command or c == 0:
            continue
        sources = [b] if b >= image.first_constant else writers.get(b, [-1])
        if any(cell < image.first_constant for cell in sources):
            return most
        greatest = max(greatest, *(image.cells[cell] for cell in sources))
    return min(greatest, most)
