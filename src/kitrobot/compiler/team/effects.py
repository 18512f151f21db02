"""Effects in a team's program that a substitute would do twice.

A substitute begins the outermost block in which its role was lost from the start (`team_points`), with own variables
as they are in the beginning and with what all share as it stands; what the team agreed in the block is told it again.
What a robot does with its own body the substitute does with another one. So two kinds of lines matter: a shared
variable is changed by what it was (`Add`, `Sub`, the opposite of itself), and a box of a storehouse is moved.

Such a line of a member that may be replaced is told, except where doing the block again does not do it again:

- between `Take()` and `Done()` of a work, because an unfinished unit is free again and is done anew on purpose;
- where the program asks first, in a condition around the line or an event before it, a shared variable that is changed
  along with it; for a box, where it asks any sensor or shared variable first and counts no passes around it;
- at the end of a pass of a loop that goes by sensors or by what all share: the substitute begins with the next pass.

In a SeqOfPar a condition that the team answers is not asked first in this sense: its answer is told again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from kitrobot.compiler.team import rules
from kitrobot.compiler.team.inlining import Report
from kitrobot.compiler.team.lines import has_blocks
from kitrobot.compiler.team.names import Atom, Names
from kitrobot.compiler.team.sets import TeamSets
from kitrobot.lll.tree import (
    Block,
    Call,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Joint,
    Members,
    Node,
    Number,
    Parallel,
    ParOfSeq,
    Repeat,
    Seq,
    SeqOfPar,
    Where,
    While,
)
from kitrobot.lll.walk import bodies, nodes
from kitrobot.primitives.automatic import DONE, TAKE
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.robot import Category, Method, Robot, RobotObject
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence

MovesBoxes = Callable[[RobotObject], bool]
"""Whether the procedures of a part move boxes between a storehouse and a robot."""


def report_effects_done_twice(
    whole: Seq, crew: Crew, robots: Mapping[str, Robot], moves_boxes: MovesBoxes, report: Report
) -> None:
    """Reports each line of a team's program that a substitute would do twice, once.

    Args:
        whole: the team's program without a mistake, every `PROGRAM` in its place (`inlining`).
        crew: what the team declares, and its agents.
        robots: the kinds of robots at hand.
        moves_boxes: whether a part moves boxes.
        report: is given what is found, in reading order.
    """
    _RepeatedEffects(whole, crew, robots, moves_boxes, report).outside(whole)


@dataclass(frozen=True)
class _LineContext:
    """What is known at a line: who does it, and what a substitute would find out before it does it again.

    Attributes:
        members: those who do it and may be replaced.
        lockstep: whether each line is followed by a meeting.
        found_out: whether a shared variable is asked first that is changed along with it.
        looked: whether a sensor or something shared is asked first.
        counted: whether passes around it are counted.
        ends_pass: whether with it ends a pass of a loop that goes by sensors or by what all share.
        units: works of which a unit is under way.
    """

    members: frozenset[Atom]
    lockstep: bool
    found_out: bool = False
    looked: bool = False
    counted: bool = False
    ends_pass: bool = False
    units: frozenset[str] = frozenset()


class _RepeatedEffects:
    def __init__(
        self, whole: Seq, crew: Crew, robots: Mapping[str, Robot], moves_boxes: MovesBoxes, report: Report
    ) -> None:
        names, sets = Names(crew), TeamSets(crew, whole)
        self.names = names
        self.groups = [(one.failure, names.atoms((name,)), sets.ever((name,))) for name, one in names.groups.items()]
        self.robots = robots
        self.moves_boxes = moves_boxes
        self.report = report
        self.reported: set[tuple[str | None, int, int]] = set()

    # -- who may be replaced

    def is_replaced(self, atom: Atom) -> bool:
        """Whether a substitute may come in its place: a group that it may be in says so, and none ends the team."""
        wanted = any(failure == "substitute" and atom in ever for failure, _, ever in self.groups)
        return wanted and not any(failure == "abort" and atom in first for failure, first, _ in self.groups)

    # -- down the program

    def outside(self, seq: Seq) -> None:
        """Looks for the blocks; outside of them nobody does anything alone."""
        for node in seq.items:
            if isinstance(node, Block):
                self.block(node, None)
            else:
                for body in bodies(node):
                    self.outside(body)

    def block(self, node: Block, around: _LineContext | None) -> None:
        """The lines of a block; `around`: where it stands in another one, from whose start it is all done again."""
        assert isinstance(node.members, Members), "no template"
        here = around or _LineContext(frozenset(), lockstep=False)
        members = frozenset(filter(self.is_replaced, self.names.atoms(node.members.names)))
        here = replace(here, members=members, lockstep=isinstance(node, SeqOfPar))
        if here.members:
            for body in bodies(node):
                self.body(body, self.behind(here, node.condition, body) if isinstance(node, Where) else here)

    def body(self, seq: Seq, here: _LineContext) -> None:
        for at, node in enumerate(seq.items):
            last = all(self.is_at_once(other) for other in seq.items[at + 1 :]) and not here.lockstep
            self.line(node, replace(here, ends_pass=here.ends_pass and last))
            done = {one.object for one in nodes(node) if isinstance(one, Call) and one.method == DONE}
            taken = {node.object} if isinstance(node, Call) and node.method == TAKE else set()
            here = replace(here, units=here.units - done | (taken & self.names.works.keys()))
            if isinstance(node, Event) and not self.is_replayed(node, here):
                here = self.behind(here, node.condition, Seq([*node.body.items, *seq.items[at + 1 :]]))

    def line(self, node: Instr, here: _LineContext) -> None:
        match node:
            case Call():
                self.call(node, here)
            case Interrupt():
                if isinstance(node.call, Call):
                    self.call(node.call, here)
            case SeqOfPar() | ParOfSeq() | Where():
                self.block(node, here)
            case While() | Conditional() | Event():
                self.choice(node, here)
            case Repeat():
                counted = here.counted or node.count != 1
                self.body(node.body, replace(here, counted=counted, ends_pass=False))
            case Parallel():
                # Each branch is done beside the others, so the end of one is not the end of a pass.
                for branch in node.branches:
                    self.body(branch, replace(here, lockstep=False, ends_pass=False))

    def choice(self, node: While | Conditional | Event, here: _LineContext) -> None:
        if self.is_replayed(node, here):
            for body in bodies(node):
                self.body(body, here)
            return
        for body in bodies(node):
            inside = replace(self.behind(here, node.condition, body), lockstep=False)
            if isinstance(node, While):
                goes_on = node.condition is None or self.asks_what_stays(node.condition, here)
                inside = replace(inside, ends_pass=goes_on and not here.counted)
            self.body(body, inside)

    def is_replayed(self, node: While | Conditional | Event, here: _LineContext) -> bool:
        """Whether all members go the same way here: a substitute is told the answer that was given."""
        if not here.lockstep:
            return False
        inside = nodes(node.condition) if node.condition is not None else []
        calls = [one for one in inside if isinstance(one, Call)]
        joint = has_blocks(node) or any(isinstance(one, Joint) for one in inside)
        return joint or all(self.is_shared(one, here) for one in calls)

    def behind(self, here: _LineContext, condition: Node | None, body: Seq) -> _LineContext:
        """What a substitute knows in a body before which a condition is asked anew."""
        if condition is None:
            return here
        shared = {one.object for one in nodes(condition) if isinstance(one, Call) and self.is_shared(one, here)}
        found_out = any(
            one.object in shared and self.changes(one, here) for one in nodes(body) if isinstance(one, Call)
        )
        return replace(
            here,
            found_out=here.found_out or found_out,
            looked=here.looked or self.asks_what_stays(condition, here),
        )

    # -- calls

    def meanings(self, call: Call, here: _LineContext) -> list[tuple[Atom, RobotObject, Method]]:
        """What a call is for each of the members that know it."""
        found = []
        for atom in sorted(here.members):
            robot = self.robots.get(atom.kind)
            meaning = robot.calls.get((call.object, call.method)) if robot is not None else None
            if meaning is not None:
                found.append((atom, *meaning))
        return found

    def is_shared(self, call: Call, here: _LineContext) -> bool:
        return call.object in self.names.works or any(part.shared for _, part, _ in self.meanings(call, here))

    def changes(self, call: Call, here: _LineContext) -> bool:
        return any(part.shared and method.action for _, part, method in self.meanings(call, here))

    def asks_what_stays(self, condition: Node, here: _LineContext) -> bool:
        """Whether a condition looks at sensors or at what all share; own variables begin anew."""
        calls = [one for one in nodes(condition) if isinstance(one, Call)]
        return any(
            self.is_shared(one, here)
            or any(part.category is Category.SENSOR for _, part, _ in self.meanings(one, here))
            for one in calls
        )

    def is_at_once(self, node: Instr) -> bool:
        """Whether a line is over in the tick in which it begins, for any robot that knows it."""
        if not isinstance(node, Call) or node.object in self.names.works:
            return False
        known = (robot.calls.get((node.object, node.method)) for robot in self.robots.values())
        return not any(meaning is not None and meaning[1].completes_later for meaning in known)

    def call(self, call: Call, here: _LineContext) -> None:
        key = (call.program, call.start, call.end)
        if key in self.reported or here.found_out or here.units or here.ends_pass:
            return
        meanings = self.meanings(call, here)
        variable = [atom for atom, part, method in meanings if _adds(call, part, method)]
        boxes = [atom for atom, part, _ in meanings if part.category is Category.ACTUATOR and self.moves_boxes(part)]
        if variable:
            self.report_effect(call, variable, here)
        elif boxes and (here.counted or not here.looked):
            self.report_effect(call, boxes, here)

    def report_effect(self, call: Call, atoms: list[Atom], here: _LineContext) -> None:
        self.reported.add((call.program, call.start, call.end))
        message = Sentence(
            "`{call}` may be done twice: a substitute for {members} begins the block around it from its start",
            f"{call.object}.{call.method}",
            listed([f"`{atom.name}`" for atom in atoms]),
        )
        help: Help = Sentence(
            "do it between Take() and Done() of a work, "
            "or ask a shared variable first and set it right behind this line"
        )
        if here.lockstep:
            help = Sentence(
                "do it between Take() and Done() of a work, "
                "or in a ParOfSeq that asks a shared variable first and sets it right behind this line"
            )
        self.report(rules.DONE_TWICE, message, call, help)


def _adds(call: Call, part: RobotObject, method: Method) -> bool:
    """Whether a call makes of a shared variable something that depends on what it was."""
    if part.category is not Category.VARIABLE or not part.shared:
        return False
    if method.action in ("add", "sub"):
        return not any(isinstance(param, Number) and param.value == 0 for param in call.params)
    if method.action != "set":
        return False
    return any(isinstance(param, Call) and _opposite(param, part) for param in call.params)


def _opposite(param: Call, part: RobotObject) -> bool:
    """Whether a parameter is yes exactly while a variable of yes and no is no."""
    method = part.method(param.method) if param.object == part.name else None
    return method is not None and method.test == "equal" and method.to == 0
