"""LLL → three-address code → image. The program must have been checked for the robot and be free of errors.

Slots are numbered first, in reading order: the program, then each branch followed by what is nested in it. Then each
slot's code is written, one stretch after another. A loop's counter is shared by loops of the same depth in a slot.
"""

from __future__ import annotations

from kitrobot.compiler import rules
from kitrobot.compiler.program.code import FAULT, Cell, Code, Label
from kitrobot.compiler.program.flow import FlowAnalysis
from kitrobot.compiler.program.slots import SlotTree
from kitrobot.compiler.target import Target
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.image import instructions as ops
from kitrobot.image.debug import DebugMap, Origin
from kitrobot.image.machine import Layout
from kitrobot.image.model import (
    LARGEST_VALUE,
    MOST_ARGUMENTS,
    MOST_CELLS,
    MOST_COMMANDS,
    MOST_INSTRUCTIONS,
    MOST_PARALLELS,
    MOST_SLOTS,
    MOST_STOPS,
    Image,
    SlotRecord,
    StopRecord,
)
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
from kitrobot.primitives.robot import Category, Kind, Method, Robot, RobotObject
from kitrobot.text.sentences import Sentence, Word


def lower(program: Seq, target: Target, name: str = "") -> tuple[Image | None, DebugMap, list[Diagnostic]]:
    """The image of a program, or None and why it is too large; and where each instruction came from.

    `name` is the program's name in its mission, kept in the origins.
    """
    lowering = _CodeGenerator(program, target, name)
    too_large = lowering.too_large()
    debug = DebugMap(lowering.code.origins)
    if too_large:
        return None, debug, too_large
    return lowering.image(), debug, []


class _CodeGenerator:
    def __init__(self, program: Seq, robot: Robot, name: str) -> None:
        self.name = name
        self.robot = robot
        self.layout = Layout(robot)
        self.flow = FlowAnalysis(robot)
        self.code = Code()
        self.tree = SlotTree()
        self.tree.add(program, None, marked=False)
        self.stops: dict[StopRecord, int] = {}
        self._counters: dict[tuple[int, int], int] = {}
        self.slot = 0
        self.depth = 0
        self.exits: list[Label] = []
        for slot, branch in enumerate(self.tree.slots):
            self.slot = slot
            branch.entry = len(self.code.rows)
            self.end = self.code.label()
            self.seq(branch.seq)
            self.code.place(self.end)
            self.code.emit(ops.END)

    # -- results

    def too_large(self) -> list[Diagnostic]:
        counts = (
            (
                self.code.cells(self.layout.cells),
                MOST_CELLS,
                Sentence("cells (inputs, variables, counters and constants)"),
            ),
            (len(self.tree.slots), MOST_SLOTS, Sentence("slots (the program and its branches)")),
            (len(self.tree.parallels), MOST_PARALLELS, Word("parallels")),
            (len(self.stops), MOST_STOPS, Sentence("marked actions with a stop")),
            (len(self.layout.commands), MOST_COMMANDS, Sentence("procedures of the robot")),
            (self.layout.most_arguments, MOST_ARGUMENTS, Sentence("parameters of a procedure")),
            (len(self.code.rows), MOST_INSTRUCTIONS, Word("instructions")),
        )
        return [
            rules.TOO_LARGE(
                Sentence("the program needs {count} {what}, and an image holds {most}", count, what, most),
                help=Sentence("split it, or use fewer of them"),
            )
            for count, most, what in counts
            if count > most
        ]

    def image(self) -> Image:
        state, code = self.layout.cells, self.code
        zeros = [0] * (code.counters + code.temporaries)
        return Image(
            fingerprint=self.robot.fingerprint,
            tick_ms=self.robot.tick_ms,
            wait_unit_ms=self.robot.wait_unit_ms,
            inputs=self.layout.inputs,
            variables=len(self.layout.variables),
            counters=code.counters,
            temporaries=code.temporaries,
            constants=len(code.constants),
            cells=(*self.layout.first_values(self.robot), *zeros, *code.constants),
            slots=tuple(SlotRecord(slot.parallel, slot.entry, slot.marked, slot.end) for slot in self.tree.slots),
            parallels=tuple(self.tree.parallels),
            stops=tuple(self.stops),
            commands=tuple(number for number, _, _ in self.layout.commands),
            actuators=len(self.robot.actuators),
            most_arguments=self.layout.most_arguments,
            code=code.assemble(state),
        )

    # -- instructions

    def seq(self, seq: Seq) -> None:
        for node in seq.items:
            self.code.free_temporaries()
            self.code.origin = Origin(node.program or self.name, node.vertex, node.start, node.end)
            if isinstance(node, Call):  # most are, and `match` takes longer to find out
                self.action(node, marked=False)
            else:
                self.instruction(node)

    def body(self, seq: Seq) -> None:
        origin = self.code.origin
        self.seq(seq)
        self.code.origin = origin
        self.code.free_temporaries()

    def instruction(self, node: Instr) -> None:
        code = self.code
        match node:
            case Interrupt():
                assert isinstance(node.call, Call)
                if node.call.vertex is not None:
                    code.origin = Origin(node.program or self.name, node.call.vertex, node.start, node.end)
                self.action(node.call, marked=True)
            case Repeat():
                self.repeat(node)
            case While():
                top, done = code.here(), code.label()
                if node.condition is not None:
                    self.jump_if(node.condition, False, done)
                self.loop_body(node.body, done)
                code.jump(ops.JMP if self.flow.back_edge_is_free(node.body) else ops.LOOP, top)
                code.place(done)
            case Conditional():
                otherwise, done = code.label(), code.label()
                self.jump_if(node.condition, False, otherwise)
                self.body(node.then)
                if node.orelse is not None:
                    code.jump(ops.JMP, done)
                code.place(otherwise)
                if node.orelse is not None:
                    self.body(node.orelse)
                code.place(done)
            case Event():
                top, happened = code.here(), code.label()
                self.jump_if(node.condition, True, happened)
                code.jump(ops.LOOP, top)
                code.place(happened)
                self.body(node.body)
            case Parallel():
                if node.branches:
                    code.emit(ops.FORK, self.tree.number[id(node)])
                    code.emit(ops.JOIN, self.tree.number[id(node)])
                else:
                    code.emit(ops.WAIT, code.constant(1))
            case Wait():
                assert isinstance(node.duration, int)
                ticks = -(-node.duration * self.robot.wait_unit_ms // self.robot.tick_ms)
                code.emit(ops.WAIT, code.constant(min(max(1, ticks), LARGEST_VALUE)))
            case Break():
                code.jump(ops.JMP, self.exits[-1] if self.exits else self.end)

    def repeat(self, node: Repeat) -> None:
        if node.count == 0:
            return
        assert isinstance(node.count, int)
        code = self.code
        counter = Cell("counter", self.counter(self.depth))
        code.emit(ops.MOV, counter, code.constant(node.count))
        top, done = code.here(), code.label()
        self.depth += 1
        self.loop_body(node.body, done)
        self.depth -= 1
        code.emit(ops.SUB, counter, counter, code.constant(1))
        code.emit(ops.CLAMP, counter, code.constant(0), code.constant(node.count))
        code.jump(ops.JZ, done, counter)
        code.jump(ops.JMP if self.flow.back_edge_is_free(node.body) else ops.LOOP, top)
        code.place(done)

    def counter(self, depth: int) -> int:
        """The index of the counter of this slot's loops at that depth; each slot has its own."""
        index = self._counters.setdefault((self.slot, depth), len(self._counters))
        self.code.counters = len(self._counters)
        return index

    def loop_body(self, body: Seq, done: Label) -> None:
        self.exits.append(done)
        self.body(body)
        self.exits.pop()

    def action(self, call: Call, *, marked: bool) -> None:
        part, method = self.robot.calls[call.object, call.method]
        if method.kind is not Kind.PROCEDURE:
            return
        if part.category is Category.ACTUATOR:
            self.command(call, part, method, marked)
        elif method.action == "clear":
            self.code.emit(ops.MOV, FAULT, self.code.constant(0))
        else:
            self.assign(call, part, method)

    def command(self, call: Call, part: RobotObject, method: Method, marked: bool) -> None:
        code = self.code
        if marked and method.stop is not None and self.tree.slots[self.slot].parallel is not None:
            stop = StopRecord(self.slot, self.layout.command[part.name, method.stop])
            code.emit(ops.ARM, self.stops.setdefault(stop, len(self.stops)))
        code.emit(ops.ACT, self.layout.command[part.name, method.name], self.arguments(call, method), len(call.params))
        if method.completes_later:
            waiting = code.here()
            code.emit(ops.YIELD)
            code.jump(ops.JZ, waiting, Cell("state", self.layout.done[part.name]))

    def arguments(self, call: Call, method: Method) -> Cell:
        code = self.code
        if not call.params:
            return FAULT
        literals = tuple(param.value for param in call.params if isinstance(param, Number))
        if len(literals) == len(call.params):
            return code.constant_run(literals)
        first = code.temporary_run(len(call.params))
        for offset, (param, parameter) in enumerate(zip(call.params, method.parameters, strict=True)):
            cell = Cell("temporary", first.number + offset)
            value, low, high = self.value(param)
            code.emit(ops.MOV, cell, value)
            self.clamp(cell, low, high, parameter.minimum, parameter.maximum)
        return first

    def assign(self, call: Call, part: RobotObject, method: Method) -> None:
        variable = Cell("state", self.layout.variables[part.name])
        value, low, high = self.value(call.params[0])
        if method.action == "set":
            self.code.emit(ops.MOV, variable, value)
            self.clamp(variable, low, high, part.minimum, part.maximum)
        else:
            self.code.emit(ops.ADD if method.action == "add" else ops.SUB, variable, variable, value)
            self.clamp(variable, 1, 0, part.minimum, part.maximum)

    def clamp(self, cell: Cell, low: int, high: int, minimum: int, maximum: int) -> None:
        """Clamps a cell to minimum…maximum, unless its value, known to be low…high, needs none."""
        if not minimum <= low <= high <= maximum:
            self.code.emit(ops.CLAMP, cell, self.code.constant(minimum), self.code.constant(maximum))

    # -- values and conditions

    def value(self, param: Param) -> tuple[Cell, int, int]:
        """The cell that holds a parameter's value, and the range it is known to lie in."""
        if isinstance(param, Number):
            return self.code.constant(param.value), param.value, param.value
        assert isinstance(param, Call)
        part, method = self.robot.calls[param.object, param.method]
        if method.kind is Kind.VALUE:
            return self.cell(part), part.minimum, part.maximum
        return self.compare(param), 0, 1

    def cell(self, part: RobotObject) -> Cell:
        match part.category:
            case Category.SENSOR:
                return Cell("state", self.layout.sensors[part.name])
            case Category.VARIABLE:
                return Cell("state", self.layout.variables[part.name])
            case _:
                return FAULT

    def compare(self, call: Call) -> Cell:
        """Computes a test into a temporary: 1 true, 0 false."""
        code = self.code
        part, method = self.robot.calls[call.object, call.method]
        if method.to is not None:
            other = code.constant(method.to)
        else:
            other, _, _ = self.value(call.params[0])
        result = code.temporary_run(1)
        match method.test:
            case "equal":
                code.emit(ops.EQ, result, self.cell(part), other)
            case "less":
                code.emit(ops.LT, result, self.cell(part), other)
            case _:
                code.emit(ops.LT, result, other, self.cell(part))
        return result

    def jump_if(self, condition: Condition, wanted: bool, label: Label) -> None:
        """Jumps to a label when a condition is as wanted, else goes on."""
        match condition:
            case Not():
                self.jump_if(condition.condition, not wanted, label)
            case And() | Or():
                if isinstance(condition, And) is wanted:
                    skip = self.code.label()
                    self.jump_if(condition.left, not wanted, skip)
                    self.jump_if(condition.right, wanted, label)
                    self.code.place(skip)
                else:
                    self.jump_if(condition.left, wanted, label)
                    self.jump_if(condition.right, wanted, label)
            case Call():
                part, method = self.robot.calls[condition.object, condition.method]
                if (
                    method.test == "equal"
                    and method.to is not None
                    and (method.to == 0 or (method.to, part.minimum, part.maximum) == (1, 0, 1))
                ):
                    self.code.jump(ops.JNZ if wanted is (method.to != 0) else ops.JZ, label, self.cell(part))
                else:
                    self.code.jump(ops.JNZ if wanted else ops.JZ, label, self.compare(condition))
                self.code.free_temporaries()
