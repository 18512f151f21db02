"""The oracle: LLL interpreted straight from its syntax tree, written for clarity, not for speed.

It is an independent reading of the language's definition (LLL: syntax, meaning): nothing of the compiler or of the
onboard interpreter is used or imitated. A thread is a Python generator that walks its body; `yield` means "give up the
tick". A `Branch` is such a thread with its slot; a `Run` is one execution of a parallel.

A tick: sample the inputs, clamped; step every live thread once, in slot order (threads that a step starts have higher
slots, so they take their first step in the same tick); settle the parallels, outer first; hand out at most one command
an actuator, in the order of the actuators.

Readings, where the definition leaves room:

1.  Slots number the *static* branches of the text in reading order, also those inside `0*()` or after a BREAK.
2.  A parallel that is over is settled at the end of the tick; its thread goes on in the next one. So a parallel costs
    at least one tick, and an outer parallel can never be over in the very tick in which an inner one ends in a branch
    that is not abandoned.
3.  "Forced when one is left" (all marked): forced when *at most* one is left; two that end in one tick leave none.
4.  Branches are counted as they stand in the text, whether they are still running or not. A branch that holds nothing
    does not exist (the parser drops it).
5.  A stop gives way when the command that would win its actuator was posted in this tick by a thread of another slot
    than the one of the marked action: an outer, an inner or a neighbouring branch, its command marked or not, itself
    ended or abandoned in this tick or not. The slot's own commands never protect.
6.  A stop is itself a command of its branch, so where the stops of two branches meet on one actuator the second gives
    way to the first; where two of one branch meet the last wins. Their order is that of the slots (as everywhere in a
    tick), in a slot that of their first appearance in the text. All this shows only on a robot with several stop
    procedures for one actuator.
7.  A marked action that is `later` and has already been done is stopped all the same: the rule says "each".
8.  A marked action of a variable, or a marked operation, marks the branch and has nothing to stop.
9.  Clamping an input to its sensor's range does not raise the fault; only variables and procedures do.
10. What Add and Sub are given is taken as it is; only the sum is clamped. What a test is given is taken as it is.
11. A call of a value or test as an instruction does nothing.
12. A BREAK that leaves an inner loop without blocking makes the outer pass one that can go round without blocking
    (see `passes`), and statements that can never run are no way round.
13. `0*` has no passes; `1*` has no back edge.
14. After the program's own thread has ended nothing happens any more; inputs are still sampled, variables stay.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Not,
    Number,
    Or,
    Parallel,
    Param,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.primitives.robot import Category, Method, Robot, RobotObject
from tests.oracle.passes import back_edge_costs_a_tick
from tests.oracle.reading import Stop, bodies, clamp, is_marked, stops_in_text, ticks_of_wait

Thread = Generator[None, None, bool]
"""Yields to give up the tick; returns whether it was left by BREAK."""


class Outcome(NamedTuple):
    """What one tick did: the commands handed to the devices, and the variables, fault flag and end after it."""

    commands: list[tuple[str, list[int]]]
    variables: dict[str, int]
    fault: int
    ended: bool


class Command(NamedTuple):
    """A posted command."""

    slot: int
    procedure: str
    arguments: list[int]


@dataclass
class Branch:
    """A live or ended thread: the program, or one branch of a running parallel.

    `stops` are the stops due for the marked actions it has started (actuator, procedure).
    """

    slot: int
    body: Seq
    marked: bool
    thread: Thread = field(init=False)
    ended: bool = False
    run: Run | None = None
    stops: set[Stop] = field(default_factory=set)

    def step(self) -> None:
        """Runs until the thread ends or blocks."""
        try:
            next(self.thread)
        except StopIteration:
            self.ended = True


@dataclass
class Run:
    """One execution of a parallel."""

    branches: list[Branch]
    settled: bool = False

    def is_over(self) -> bool:
        """Whether all branches have ended, or those that are left are to be forced."""
        left = [branch for branch in self.branches if not branch.ended]
        if not left:
            return True
        if all(branch.marked for branch in self.branches):
            return len(self.branches) >= 2 and len(left) == 1
        return all(branch.marked for branch in left)


class Oracle:
    """A program on a robot. `tick` does one reaction; inputs and done flags hold until they are given again."""

    def __init__(self, program: Seq, robot: Robot) -> None:
        self.robot = robot
        self.variables = {variable.name: variable.initial for variable in robot.variables}
        self.inputs = {sensor.name: clamp(0, sensor.minimum, sensor.maximum) for sensor in robot.sensors}
        self.done = {actuator.name: True for actuator in robot.actuators}
        self.fault = 0
        self.slots = {id(body): slot for slot, body in enumerate(bodies(program))}
        self.posted: dict[str, Command] = {}
        self.program = self.start(program, marked=False)

    # ---- the tick ---------------------------------------------------------------------------------------

    def tick(self, inputs: Mapping[str, int] | None = None, done: Mapping[str, bool] | None = None) -> Outcome:
        """One reaction to these inputs (sensor → value) and done flags (actuator → done)."""
        for sensor in self.robot.sensors:
            if inputs and sensor.name in inputs:
                self.inputs[sensor.name] = clamp(inputs[sensor.name], sensor.minimum, sensor.maximum)
        self.done.update(done or {})
        self.posted = {}

        for slot in range(len(self.slots)):
            # Looked up afresh each time: the step of an outer thread may just have started this one.
            for branch in live_branches(self.program):
                if branch.slot == slot:
                    branch.step()
                    break
        for branch, actuator, procedure in sorted(self.settle(self.program), key=lambda stop: stop[0].slot):
            winner = self.posted.get(actuator)
            if winner is None or winner.slot == branch.slot:
                self.posted[actuator] = Command(branch.slot, procedure, [])

        commands = [
            (f"{actuator.name}.{command.procedure}", command.arguments)
            for actuator in self.robot.actuators
            if (command := self.posted.get(actuator.name))
        ]
        return Outcome(commands, dict(self.variables), self.fault, self.program.ended)

    def settle(self, branch: Branch) -> Iterator[tuple[Branch, str, str]]:
        """Settles the parallels below this live branch, outer first; gives the stops that are due."""
        run = branch.run
        if run is None:
            return
        if run.is_over():
            run.settled = True
            yield from self.stops_of(run)
        else:
            for inner in run.branches:
                if not inner.ended:
                    yield from self.settle(inner)

    def stops_of(self, run: Run) -> Iterator[tuple[Branch, str, str]]:
        """The stops due when a parallel is over: its own, and those of the parallels that are abandoned with it."""
        for branch in run.branches:
            # A dictionary as a set that keeps the order.
            for actuator, procedure in dict.fromkeys(stops_in_text(branch.body, self.robot)):
                if (actuator, procedure) in branch.stops:
                    yield branch, actuator, procedure
            if not branch.ended and branch.run is not None:
                yield from self.stops_of(branch.run)

    def start(self, body: Seq, marked: bool) -> Branch:
        branch = Branch(self.slots[id(body)], body, marked)
        branch.thread = self.do_all(body, branch)
        return branch

    # ---- instructions -----------------------------------------------------------------------------------

    def do_all(self, seq: Seq, branch: Branch) -> Thread:
        for item in seq.items:
            left_by_break = yield from self.do(item, branch)
            if left_by_break:
                return True
        return False

    def do(self, item: Instr, branch: Branch) -> Thread:
        match item:
            case Break():
                return True
            case Call():
                yield from self.do_call(item, branch)
            case Interrupt():
                assert isinstance(item.call, Call)
                yield from self.do_call(item.call, branch, marked=True)
            case Wait():
                assert isinstance(item.duration, int)
                for _ in range(ticks_of_wait(item.duration, self.robot)):
                    yield
            case Conditional():
                if self.holds(item.condition):
                    return (yield from self.do_all(item.then, branch))
                if item.orelse is not None:
                    return (yield from self.do_all(item.orelse, branch))
            case Event():
                while not self.holds(item.condition):
                    yield
                return (yield from self.do_all(item.body, branch))
            case Repeat():
                yield from self.do_repeat(item, branch)
            case While():
                yield from self.do_while(item, branch)
            case Parallel():
                branch.run = Run([self.start(body, is_marked(body)) for body in item.branches])
                while not branch.run.settled:
                    yield
                branch.run = None
        return False

    def do_repeat(self, loop: Repeat, branch: Branch) -> Thread:
        assert isinstance(loop.count, int)
        for left in reversed(range(loop.count)):
            left_by_break = yield from self.do_all(loop.body, branch)
            if left_by_break:
                break
            if left and back_edge_costs_a_tick(loop.body, self.robot):
                yield
        return False

    def do_while(self, loop: While, branch: Branch) -> Thread:
        while loop.condition is None or self.holds(loop.condition):
            left_by_break = yield from self.do_all(loop.body, branch)
            if left_by_break:
                break
            if back_edge_costs_a_tick(loop.body, self.robot):
                yield
        return False

    def do_call(self, call: Call, branch: Branch, marked: bool = False) -> Thread:
        part, method = self.robot.calls[call.object, call.method]
        if part.category is Category.ACTUATOR:
            arguments = [
                self.clamped(self.value(given), parameter.minimum, parameter.maximum)
                for given, parameter in zip(call.params, method.parameters, strict=True)
            ]
            self.posted[part.name] = Command(branch.slot, method.name, arguments)
            if marked and method.stop is not None:
                branch.stops.add((part.name, method.stop))
            if method.completes_later:
                yield
                while not self.done[part.name]:
                    yield
        elif method.action == "clear":
            self.fault = 0
        elif method.action:
            self.change(part, method, self.value(call.params[0]))
        return False

    def change(self, variable: RobotObject, method: Method, amount: int) -> None:
        before = self.variables[variable.name]
        after = {"set": amount, "add": before + amount, "sub": before - amount}[method.action]
        self.variables[variable.name] = self.clamped(after, variable.minimum, variable.maximum)

    def clamped(self, value: int, minimum: int, maximum: int) -> int:
        result = clamp(value, minimum, maximum)
        if result != value:
            self.fault = 1
        return result

    # ---- conditions and values --------------------------------------------------------------------------

    def holds(self, condition: Condition) -> bool:
        match condition:
            case And():
                return self.holds(condition.left) and self.holds(condition.right)
            case Or():
                return self.holds(condition.left) or self.holds(condition.right)
            case Not():
                return not self.holds(condition.condition)
            case Call():
                return self.value(condition) != 0
        raise AssertionError(condition)

    def value(self, param: Param) -> int:
        """The value of a parameter; a test is 1 or 0."""
        if isinstance(param, Number):
            return param.value
        assert isinstance(param, Call)
        part, method = self.robot.calls[param.object, param.method]
        current = self.current(part)
        if not method.test:
            return current
        other = method.to if method.to is not None else self.value(param.params[0])
        return int({"equal": current == other, "less": current < other, "greater": current > other}[method.test])

    def current(self, part: RobotObject) -> int:
        match part.category:
            case Category.SENSOR:
                return self.inputs[part.name]
            case Category.VARIABLE:
                return self.variables[part.name]
        return self.fault


# ---- what runs ------------------------------------------------------------------------------------------


def live_branches(branch: Branch) -> Iterator[Branch]:
    """This branch and all below it that have not ended."""
    if branch.ended:
        return
    yield branch
    if branch.run is not None:
        for inner in branch.run.branches:
            yield from live_branches(inner)
