"""What a program's names mean for a robot, and what is wrong or odd about it.

Every call is looked up in the robot's definition; every mistake is reported, none stops the reading. What could not be
read (an empty `object`) was reported by the parser and is passed over.
"""

from __future__ import annotations

from kitrobot.compiler import rules
from kitrobot.compiler.program.called_names import CalledNames
from kitrobot.compiler.program.constant_conditions import always_holds
from kitrobot.compiler.program.flow import FlowAnalysis
from kitrobot.compiler.program.overridden_commands import find_overridden_commands
from kitrobot.compiler.target import Target, words_for
from kitrobot.diagnostics.model import Diagnostic, Fix, FixKind, Rule, Source, in_reading_order
from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Joint,
    Node,
    Not,
    Number,
    Or,
    Parallel,
    ParOfSeq,
    Repeat,
    Seq,
    SeqOfPar,
    TeamInstr,
    Wait,
    Where,
    While,
)
from kitrobot.lll.walk import bodies, nodes
from kitrobot.primitives.robot import Category, Kind, Method, Parameter, Robot, RobotObject, ValueType
from kitrobot.text.sentences import COMMA, Help, Sentence, Series, Word


def check(program: Seq, target: Target, source: Source, program_name: str = "") -> list[Diagnostic]:
    """All that is wrong or odd about a program for a target, in reading order.

    `source` is the text the nodes' places point into; `program_name` is set on each diagnostic.
    """
    checker = _Checker(target, source, program_name)
    checker.seq(program, in_loop=False, in_parallel=False)
    if not any(item.is_error for item in checker.found):
        checker.overwritten(program)
    return in_reading_order(checker.found)


class _Checker:
    def __init__(self, robot: Robot, source: Source, program_name: str) -> None:
        self.robot = robot
        self.source = source
        self.program_name = program_name
        self.within = program_name
        """The program from which the instruction comes that is looked at."""
        self.flow = FlowAnalysis(robot, self.is_endless)
        self.names = CalledNames(robot)
        self.found: list[Diagnostic] = []

    def report(
        self,
        rule: Rule,
        message: Sentence,
        node: Node,
        help: Help = "",
        start: int | None = None,
        fix: Fix | None = None,
    ) -> None:
        place = self.source.place(node.start if start is None else start, node.end)
        vertices = (node.vertex,) if node.vertex else ()
        self.found.append(rule(message, place, help=help, program=self.within, vertices=vertices, fix=fix))

    def text(self, node: Node) -> str:
        return self.source.text[node.start : node.end]

    def is_endless(self, node: While) -> bool:
        """Whether only a BREAK leaves a loop."""
        return always_holds(node.condition, self.robot)

    # -- instructions

    def seq(self, seq: Seq, *, in_loop: bool, in_parallel: bool) -> None:
        reachable = True
        for node in seq.items:
            if not reachable:
                self.report(
                    rules.NEVER_RUNS,
                    Sentence("this can never run: what stands before it never goes on"),
                    node,
                    Sentence("take it away, or let a BREAK leave the loop before it"),
                )
            within, self.within = self.within, node.program or self.program_name
            self.instruction(node, in_loop, in_parallel)
            self.within = within
            reachable = reachable is not True or self.flow.instruction(node).goes_on

    def instruction(self, node: Instr, in_loop: bool, in_parallel: bool) -> None:
        match node:
            case Call():
                self.action(node)
            case Interrupt():
                if not in_parallel:
                    self.report(
                        rules.MARK_OUTSIDE_PARALLEL,
                        Sentence("the mark ° does nothing outside a parallel"),
                        node,
                        Sentence("take the ° away, or put the action into a branch"),
                        fix=Fix(self.text(node.call), FixKind.UNWRAP) if isinstance(node.call, Call) else None,
                    )
                if isinstance(node.call, Call):
                    self.action(node.call)
            case Repeat():
                if node.count == 0 and node.body.items:
                    help = Sentence("give the loop a number of times, or take it away")
                    self.report(
                        rules.NEVER_RUNS, Sentence("a loop of 0 times never runs its body"), node.body.items[0], help
                    )
                self.seq(node.body, in_loop=True, in_parallel=in_parallel)
            case While():
                if node.condition is not None:
                    self.condition(node.condition)
                if self.is_endless(node):
                    self.idle(node)
                self.seq(node.body, in_loop=True, in_parallel=in_parallel)
            case Conditional():
                self.condition(node.condition)
                self.seq(node.then, in_loop=in_loop, in_parallel=in_parallel)
                if node.orelse is not None:
                    self.seq(node.orelse, in_loop=in_loop, in_parallel=in_parallel)
            case Event():
                self.condition(node.condition)
                self.seq(node.body, in_loop=in_loop, in_parallel=in_parallel)
            case Parallel():
                for branch in node.branches:
                    self.seq(branch, in_loop=False, in_parallel=True)
                self.shared_actuators(node)
            case SeqOfPar() | ParOfSeq():
                self.seq(node.body, in_loop=False, in_parallel=in_parallel)
            case Where():
                self.condition(node.condition)
                for body in bodies(node):
                    self.seq(body, in_loop=False, in_parallel=in_parallel)
            case Break():
                if not in_loop:
                    message = Sentence("BREAK stands in no loop, so it ends the program")
                    if in_parallel:
                        message = Sentence("BREAK stands in no loop, so it ends the branch")
                    help = Sentence("put it into a loop, or leave it if that is meant")
                    self.report(
                        rules.BREAK_OUTSIDE_LOOP,
                        message,
                        node,
                        help,
                    )

    def action(self, call: Call) -> None:
        meaning = self.meaning(call)
        if meaning is None:
            return
        if meaning[1].kind is not Kind.PROCEDURE:
            message = Sentence("`{call}` only reads something, so as an instruction it does nothing", _name(call))
            self.report(rules.VALUE_AS_INSTRUCTION, message, call, Sentence("use it in a condition or as a parameter"))

    def idle(self, node: While) -> None:
        """A loop without end in which nothing takes time and nothing is looked at."""
        if not any(self.does_something(one) for one in nodes(node.body)):
            message = Sentence("this loop does nothing for ever: the robot stays as it is, and nothing comes after it")
            self.report(rules.IDLE_LOOP, message, node, Sentence("put into it what the robot is to do"))
        elif node.body.items and all(self.is_blind(item) for item in node.body.items):
            message = Sentence(
                "nothing in this loop takes time, so it is done every {tick_ms} ms for ever", self.robot.tick_ms
            )
            self.report(rules.IDLE_LOOP, message, node, Sentence("put a WAIT or a test into it, or do it once only"))

    def does_something(self, node: Node) -> bool:
        """Whether an instruction, whatever it holds, does something, takes time, or leaves a loop."""
        if isinstance(node, Call):
            meaning = self.robot.calls.get((node.object, node.method))
            return meaning is None or meaning[1].kind is Kind.PROCEDURE
        return isinstance(node, Wait | Parallel | Event | Break | TeamInstr)

    def is_blind(self, node: Instr) -> bool:
        """Whether an instruction is a call that takes no time, whatever the robot senses."""
        call = node.call if isinstance(node, Interrupt) else node
        if not isinstance(call, Call) or any(isinstance(param, Call) for param in call.params):
            return False
        meaning = self.robot.calls.get((call.object, call.method))
        return meaning is not None and not meaning[1].completes_later

    def overwritten(self, program: Seq) -> None:
        for call, later in find_overridden_commands(program, self.robot):
            message = Sentence("this has no effect: in the same tick `{call}` takes its place", _name(later))
            help = Sentence("put a WAIT between the two, or take one of them away")
            self.report(rules.OVERWRITTEN, message, call, help)

    def shared_actuators(self, node: Parallel) -> None:
        first_branch: dict[str, int] = {}
        told: set[str] = set()
        for index, branch in enumerate(node.branches):
            for call in _calls(branch):
                meaning = self.robot.calls.get((call.object, call.method))
                if meaning is None or meaning[0].category is not Category.ACTUATOR:
                    continue
                if first_branch.setdefault(call.object, index) != index and call.object not in told:
                    told.add(call.object)
                    self.report(
                        rules.SHARED_ACTUATOR,
                        Sentence(
                            "`{object}` is driven by two branches of one parallel; in one tick the last of them wins",
                            call.object,
                        ),
                        call,
                        Sentence("let one branch alone drive it, unless this is meant"),
                    )

    # -- conditions and parameters

    def condition(self, node: Condition) -> None:
        match node:
            case And() | Or():
                self.condition(node.left)
                self.condition(node.right)
            case Not() | Joint():
                self.condition(node.condition)
            case Call():
                meaning = self.meaning(node)
                if meaning is None:
                    return
                if meaning[1].kind is Kind.VALUE:
                    message = Sentence("expected a test, found `{call}`, which is a number", _name(node))
                    self.report(rules.VALUE_FOR_TEST, message, node, self.offer(meaning[0], Kind.TEST))
                elif meaning[1].kind is Kind.PROCEDURE:
                    self.procedure(node, Sentence("a test"), self.offer(meaning[0], Kind.TEST))

    def offer(self, part: RobotObject, kind: Kind) -> Help:
        """Names the methods of that kind which an object's name offers."""
        known = [method.name for method in self.names.methods[part.name] if method.kind is kind]
        return (
            Sentence("`{part}` has {known}", part.name, Series(COMMA, (f"`{name}`" for name in known))) if known else ""
        )

    def procedure(self, call: Call, wanted: str, help: Help) -> None:
        message = Sentence("expected {wanted}, found `{call}`, which is an action", wanted, _name(call))
        self.report(rules.PROCEDURE_FOR_VALUE, message, call, help)

    def meaning(self, call: Call) -> tuple[RobotObject, Method] | None:
        """Looks a call up and checks its parameters; None when its names mean nothing (reported)."""
        if not call.object:
            return None
        meaning = self.robot.calls.get((call.object, call.method))
        if meaning is None:
            methods = sorted(method.name for method in self.names.methods.get(call.object, ()))
            if methods:
                near, help = self.names.suggested(call.method, methods)
                self.report(
                    rules.UNKNOWN_METHOD,
                    Sentence(
                        "`{object}` of {robot} has no `{method}`", call.object, words_for(self.robot), call.method
                    ),
                    call,
                    help,
                    start=call.method_start,
                    fix=self.renaming(call, call.object, near),
                )
            else:
                near, help = self.names.suggested(call.object, self.names.objects)
                self.report(
                    rules.UNKNOWN_OBJECT,
                    Sentence("{robot} has no `{object}`", words_for(self.robot), call.object),
                    call,
                    help,
                    fix=self.renaming(call, near, call.method),
                )
            for param in call.params:
                if isinstance(param, Call):
                    self.meaning(param)
            return None
        part, method = meaning
        wanted, given = len(method.parameters), len(call.params)
        if wanted != given:
            names = ", ".join(parameter.name for parameter in method.parameters)
            self.report(
                rules.PARAMETER_COUNT,
                Sentence.counted(
                    "`{call}` takes {count} parameter, found {found}",
                    "`{call}` takes {count} parameters, found {found}",
                    _name(call),
                    wanted,
                    given,
                ),
                call,
                Sentence("write {call}({names})", _name(call), names),
                fix=self.refilling(call, method),
            )
        for param, parameter in zip(call.params, method.parameters, strict=False):
            self.param(param, part, method, parameter)
        return meaning

    def renaming(self, call: Call, object: str, method: str) -> Fix | None:
        """The same call of the nearest thing that the robot has; None when it has nothing like it."""
        if (object, method) not in self.robot.calls:
            return None
        rest = self.source.text[call.method_start : call.end].removeprefix(call.method)
        text = f"{method}{rest}" if object == call.object else f"{object}.{method}{rest}"
        return Fix(text, FixKind.ELEMENT, f"{object}.{method}")

    def refilling(self, call: Call, method: Method) -> Fix:
        """The same call with as many parameters as it takes: the first ones stay, missing ones are the usual."""
        given = [self.text(param) for param in call.params[: len(method.parameters)]]
        usual = [str(max(0, parameter.default)) for parameter in method.parameters[len(given) :]]
        return Fix(f"{_name(call)}({', '.join(given + usual)})")

    def param(self, node: Node, part: RobotObject, method: Method, parameter: Parameter) -> None:
        if isinstance(node, Number):
            if method.is_limited and not parameter.minimum <= node.value <= parameter.maximum:
                self.report(
                    rules.OUT_OF_RANGE,
                    Sentence(
                        "expected a {parameter} from {minimum} to {maximum} for `{call}`, found {value}",
                        Word(parameter.name),
                        parameter.minimum,
                        parameter.maximum,
                        f"{part.name}.{method.name}",
                        node.value,
                    ),
                    node,
                    Sentence("write a number from {minimum} to {maximum}", parameter.minimum, parameter.maximum),
                    fix=Fix(
                        str(min(max(node.value, parameter.minimum), parameter.maximum)),
                        FixKind.SETTING,
                        parameter.name,
                    ),
                )
            return
        if not isinstance(node, Call):
            return
        meaning = self.meaning(node)
        if meaning is None:
            return
        kind = meaning[1].kind
        boolean = parameter.type is ValueType.BOOLEAN
        asks, given = f"{part.name}.{method.name}", f"`{_name(node)}`"
        if kind is Kind.PROCEDURE:
            self.procedure(node, Sentence("a test") if boolean else Sentence("a number"), "")
        elif kind is Kind.TEST and not boolean:
            self.report(
                rules.TEST_FOR_VALUE,
                Sentence(
                    "expected a number as the {parameter} of `{call}`, found the test {test}",
                    Word(parameter.name),
                    asks,
                    given,
                ),
                node,
                self.offer(meaning[0], Kind.VALUE),
            )
        elif kind is Kind.VALUE and boolean:
            self.report(
                rules.VALUE_FOR_TEST,
                Sentence("expected a test, 0 or 1 for `{call}`, found {found}, which is a number", asks, given),
                node,
                self.offer(meaning[0], Kind.TEST),
            )


def _name(call: Call) -> str:
    return f"{call.object}.{call.method}"


def _calls(seq: Seq) -> list[Call]:
    """The calls that stand as instructions in a body, nested bodies of the same robots included, in reading order."""
    found: list[Call] = []
    for node in seq.items:
        if isinstance(node, Call):
            found.append(node)
        elif isinstance(node, Interrupt):
            if isinstance(node.call, Call):
                found.append(node.call)
        elif not isinstance(node, TeamInstr):
            for body in bodies(node):
                found += _calls(body)
    return found
