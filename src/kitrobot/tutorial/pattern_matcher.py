"""Whether a program is what a pattern says: trees are compared, never texts.

A pattern is LLL with holes. A hole takes whatever stands in its place, within its range; one that occurs twice takes
the same twice. There are two ways to compare:

- *whole*: the program is the pattern. A body's hole takes any run of instructions; all else is as written.
- *contains*: the pattern stands somewhere in the program. Its instructions stand in one body in that order, with
  others between them; each may also stand deeper, in a loop or a choice of its own; a branch of a parallel may be any
  branch; a test may be one side of a longer condition; a marked action is its action. So a person may do more than was
  asked, in another order, and is still understood.

Comments do not count. The work of one comparison is bounded: what cannot be told within `MOST_STEPS` is not there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Conditional,
    Event,
    Hole,
    Interrupt,
    Joint,
    Members,
    Move,
    Node,
    Not,
    Number,
    Or,
    Parallel,
    ParOfSeq,
    ProgramCall,
    Repeat,
    Seq,
    SeqOfPar,
    Wait,
    Where,
    While,
)
from kitrobot.lll.walk import children, nodes
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.templates import holes
from kitrobot.tutorial.model import Pattern, Tutorial
from kitrobot.tutorial.teams import team_fits

MOST_STEPS = 200_000
"""Comparisons of two nodes for one pattern and program, at most."""


def steps_fit(tutorial: Tutorial, programs: Mapping[str, Seq], crew: Crew | None = None) -> list[bool]:
    """For each step, whether the programs (by name) and the team are as it wants them; events are no matter here.

    The `agents` of `crew` are those that run the team's program; without a crew nothing that is wanted of a team holds.
    """
    walked: dict[int, list[Node]] = {}
    return [
        all(team_fits(want, crew) for want in step.team)
        and all(any(_holds(pattern, programs, walked) for pattern in row) for row in step.wants)
        for step in tutorial.steps
    ]


def _holds(pattern: Pattern, programs: Mapping[str, Seq], walked: dict[int, list[Node]]) -> bool:
    meant = [seq for name, seq in programs.items() if pattern.program in ("", name)]
    wanted = pattern.programs
    for seq in meant:
        wanted -= fits(pattern, seq, walked)
        if wanted == 0:
            return True
    return False


def fits(pattern: Pattern, program: Seq, walked: dict[int, list[Node]] | None = None) -> bool:
    """Whether one program is what the pattern says.

    `walked` keeps what was walked through, for other patterns on the same programs.
    """
    code = pattern.code
    matching = _PatternMatcher(pattern, {} if walked is None else walked)
    try:
        if pattern.whole:
            body = code if isinstance(code, Seq) else Seq([code])  # type: ignore[list-item]
            return any(True for _ in matching.ways(body, program))
        if isinstance(code, And | Or | Not):
            return any(True for _ in matching.anywhere(code, program))
        items = code.items if isinstance(code, Seq) else [code]
        return any(True for _ in matching.somewhere(items, program))
    except _MatchLimitError:
        return False


class _MatchLimitError(Exception):
    """The work is not worth it."""


class _PatternMatcher:
    """One comparison; `walked` is shared by those of one program.

    Each method gives one `None` for every way to bind the holes; `bound` is what they hold then.
    """

    def __init__(self, pattern: Pattern, walked: dict[int, list[Node]]) -> None:
        self.walked = walked
        self.whole = pattern.whole
        self.ranges = pattern.ranges
        self.bound: dict[str, Any] = {}
        self.steps = 0
        self.known: dict[tuple[int, int], bool] = {}
        self.tests = {
            child.name
            for node in nodes(pattern.code)
            if not isinstance(node, Call)
            for child in children(node)
            if isinstance(child, Hole)
        }
        names = Counter(hole.name for hole, _, _ in holes(pattern.code))
        self.shared = {name for name, times in names.items() if times > 1}
        self.tied: dict[int, bool] = {}

    def is_free(self, pattern: Any) -> bool:
        """Whether nothing in it is bound elsewhere: then one way is as good as another."""
        if not self.shared:
            return True
        if not isinstance(pattern, Node):
            return not (isinstance(pattern, Hole) and pattern.name in self.shared)
        known = self.tied.get(id(pattern))
        if known is None:
            own = isinstance(pattern, Hole) and pattern.name in self.shared
            known = own or any(hole.name in self.shared for hole, _, _ in holes(pattern))
            self.tied[id(pattern)] = known
        return not known

    def ways(self, pattern: Any, value: Any) -> Iterator[None]:
        """A node of the pattern against a node of the program."""
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise _MatchLimitError
        if not isinstance(value, Node) or not self.is_free(pattern):
            yield from self._ways(pattern, value)
            return
        key = id(pattern), id(value)
        known = self.known.get(key)
        if known is None:
            known = self.known[key] = any(True for _ in self._ways(pattern, value))
        if known:
            yield

    def _ways(self, pattern: Any, value: Any) -> Iterator[None]:
        if isinstance(pattern, Hole):
            yield from self.hole(pattern, value)
        elif isinstance(pattern, int | str):
            if pattern == value:
                yield
        elif isinstance(pattern, Seq):
            if isinstance(value, Seq):
                yield from self.body(pattern, value)
        elif isinstance(value, Interrupt) and isinstance(pattern, Call) and not self.whole:
            yield from self.ways(pattern, value.call)
        elif type(pattern) is type(value):
            yield from self.parts(pattern, value)

    def parts(self, pattern: Node, value: Any) -> Iterator[None]:
        match pattern:
            case Number():
                if pattern.value == value.value:
                    yield
            case Call():
                same = (pattern.object, pattern.method) == (value.object, value.method)
                if same and len(pattern.params) == len(value.params):
                    yield from self.all(list(zip(pattern.params, value.params, strict=True)))
            case Interrupt():
                yield from self.ways(pattern.call, value.call)
            case Repeat():
                yield from self.all([(pattern.count, value.count), (pattern.body, value.body)])
            case While() if pattern.condition is None or value.condition is None:
                if pattern.condition is value.condition:
                    yield from self.ways(pattern.body, value.body)
            case While() | Event():
                for _ in self.condition(pattern.condition, value.condition):
                    yield from self.ways(pattern.body, value.body)
            case Conditional():
                yield from self.choice(pattern, value, [(pattern.then, value.then)])
            case Parallel():
                more = len(value.branches) - len(pattern.branches)
                if more == 0 or (more > 0 and not self.whole):
                    yield from self.branches(pattern.branches, value.branches)
            case Wait():
                yield from self.ways(pattern.duration, value.duration)
            case SeqOfPar() | ParOfSeq() | Where() | Joint() | Members() | ProgramCall() | Move():
                yield from self.of_team(pattern, value)
            case Break():
                yield
            case And() | Or():
                yield from self.all([(pattern.left, value.left), (pattern.right, value.right)])
                if not self.whole:
                    yield from self.all([(pattern.left, value.right), (pattern.right, value.left)])
            case Not():
                yield from self.ways(pattern.condition, value.condition)

    def choice(self, pattern: Conditional | Where, value: Any, parts: list[tuple[Any, Any]]) -> Iterator[None]:
        """A condition, these parts, and what is done otherwise."""
        if pattern.orelse is not None:
            parts.append((pattern.orelse, value.orelse))
        elif self.whole and value.orelse is not None:
            return
        for _ in self.condition(pattern.condition, value.condition):
            yield from self.all(parts)

    def of_team(self, pattern: Node, value: Any) -> Iterator[None]:
        """What stands in a team's program only. A set is the same in any order; a hole takes any set."""
        match pattern:
            case Members():
                if set(pattern.names) == set(value.names):
                    yield
            case SeqOfPar() | ParOfSeq():
                yield from self.all([(pattern.members, value.members), (pattern.body, value.body)])
            case Where():
                yield from self.choice(pattern, value, [(pattern.members, value.members), (pattern.then, value.then)])
            case Joint():
                if pattern.quantifier == value.quantifier:
                    for _ in self.ways(pattern.members, value.members):
                        yield from self.condition(pattern.condition, value.condition)
            case ProgramCall():
                yield from self.ways(pattern.name, value.name)
            case Move():
                names = [(pattern.source, value.source), (pattern.target, value.target)]
                yield from self.all([(pattern.count, value.count), *names])

    def all(self, pairs: list[tuple[Any, Any]]) -> Iterator[None]:
        if not pairs:
            yield
            return
        (pattern, value), *rest = pairs
        for _ in self.ways(pattern, value):
            yield from self.all(rest)

    def hole(self, hole: Hole, value: Any) -> Iterator[None]:
        """Takes what stands there. A test that is not there yet is taken only where the range lets it be missing."""
        taken = value.value if isinstance(value, Number) else value
        missing = isinstance(taken, Call) and not taken.object
        bounds = self.ranges.get(hole.name)
        if bounds is None:
            if missing:
                return
        else:
            size = len(taken.items) if isinstance(taken, Seq) else 0 if missing else taken
            if not isinstance(size, int):
                size = 1 if hole.name in self.tests else -1
            if not bounds[0] <= size <= bounds[1]:
                return
        if hole.name not in self.shared:
            yield
        elif hole.name in self.bound:
            if self.bound[hole.name] == taken:
                yield
        else:
            self.bound[hole.name] = taken
            try:
                yield
            finally:
                del self.bound[hole.name]

    def condition(self, pattern: Any, value: Any) -> Iterator[None]:
        """A test; one side of a longer condition will do."""
        yield from self.ways(pattern, value)
        if self.whole or isinstance(pattern, Hole):
            return
        waiting = [value]
        while waiting:
            part = waiting.pop()
            if isinstance(part, And | Or):
                for side in (part.right, part.left):
                    yield from self.ways(pattern, side)
                    waiting.append(side)

    def anywhere(self, pattern: Node, program: Seq) -> Iterator[None]:
        """A condition, wherever in the program it stands."""
        for node in self.inside(program):
            if type(node) is type(pattern):
                yield from self.ways(pattern, node)

    # -- bodies

    def body(self, pattern: Seq, value: Seq) -> Iterator[None]:
        if not self.whole:
            held = self.hole(pattern.hole, value) if pattern.hole is not None else iter((None,))
            for _ in held:
                yield from self.somewhere(pattern.items, value)
            return
        before, behind = pattern.items[: pattern.hole_at], pattern.items[pattern.hole_at :]
        if pattern.hole is None:
            before, behind = pattern.items, []
        taken = len(value.items) - len(pattern.items)
        if taken < 0 or (taken > 0 and pattern.hole is None):
            return
        end = len(before) + taken
        pairs = [*zip(before, value.items, strict=False), *zip(behind, value.items[end:], strict=True)]
        middle = Seq(value.items[len(before) : end])
        for _ in self.hole(pattern.hole, middle) if pattern.hole is not None else iter((None,)):
            yield from self.all(pairs)

    def somewhere(self, patterns: list[Any], body: Seq) -> Iterator[None]:
        """Instructions in that order in one body: this one, or one inside it."""
        if not patterns:
            yield
            return
        if len(patterns) == 1:
            yield from self.item(patterns[0], body)
            return
        for inner in self.inside(body):
            if type(inner) is Seq and len(inner.items) >= len(patterns):
                yield from self.in_order(patterns, inner.items)

    def in_order(self, patterns: list[Any], items: list[Any]) -> Iterator[None]:
        if not patterns:
            yield
            return
        pattern, *rest = patterns
        free = self.is_free(pattern)
        for at, item in enumerate(items):
            found = False
            for _ in self.item(pattern, item):
                found = True
                yield from self.in_order(rest, items[at + 1 :])
                if free:
                    break
            if found and free:
                return  # a later place leaves less room for the rest

    def item(self, pattern: Any, item: Any) -> Iterator[None]:
        """An instruction: this one, or one inside it."""
        kind = type(pattern)
        for node in self.inside(item):
            found = type(node)
            if kind is found:
                if kind is Call and (node.method != pattern.method or node.object != pattern.object):
                    continue
            elif kind is not Call or found is not Interrupt or self.whole:
                continue
            yield from self.ways(pattern, node)

    def inside(self, root: Any) -> list[Any]:
        """A node of the program and all inside it."""
        found = self.walked.get(id(root))
        if found is None:
            found = self.walked[id(root)] = nodes(root)
        return found

    def branches(self, patterns: list[Seq], values: list[Seq]) -> Iterator[None]:
        """Each branch of the pattern as another branch of the program, in any order."""
        if not patterns:
            yield
            return
        pattern, *rest = patterns
        for at, value in enumerate(values):
            for _ in self.ways(pattern, value):
                yield from self.branches(rest, values[:at] + values[at + 1 :])
