"""Which groups of a team a MOVE can leave empty, by itself or when the one robot that it leaves there fails.

A MOVE takes robots out of a group and of every group in it, so also out of groups around it and of those that share one
with it, unless it lets them stay in there. A role that robots move from or to is such a group, too (`team_sets`).

Of each group it is counted how many more robots can have gone than have come, at most, where a block or a question
names it and at the end; so too for what it holds itself, without the groups in it. Roles have their least number of
robots there. Where robots are left but may fail, those are counted that the mission has: one of them alone, if nobody
takes its place.

Of a team with more groups and places that move or look for robots than `MOST_PAIRS` allows nothing is told: all are
held against each other.

Left to others: groups that one failure empties without a MOVE (names).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kitrobot.compiler.team import rules
from kitrobot.compiler.team.inlining import Report
from kitrobot.compiler.team.names import Atom, Atoms, Names
from kitrobot.compiler.team.sets import TeamSets
from kitrobot.lll.tree import Block, Conditional, Instr, Joint, Members, Move, Node, Parallel, Repeat, Seq, While
from kitrobot.lll.walk import bodies, nodes
from kitrobot.text.sentences import Help, Sentence

MOST_PAIRS = 40_000
"""Pairs of a group with a group, a MOVE, a block or a question that are looked at, at most."""
_MANY = 1_000_000


class _Part(NamedTuple):
    """A group, with the groups in it (`whole`) or without."""

    group: str
    whole: bool


class _Loss(NamedTuple):
    """How many more robots go than come, at most: `net` at the end of a part of the program, `worst` where somebody
    looks for them; `-_MANY` where nobody does.
    """

    net: int = 0
    worst: int = -_MANY


_Losses = dict[_Part, _Loss]
_NOTHING = _Loss()


def report_emptied(whole: Seq, names: Names, report: Report) -> None:
    """Reports each role and group that the MOVEs of a program can leave empty, at the last of them that takes from it.

    Args:
        whole: the team's program, every `PROGRAM` in its place (`inlining`); names unknown in it are nobody's.
        names: the names of the team.
        report: is given what is found.
    """
    moves = [node for node in nodes(whole) if isinstance(node, Move)]
    looking = sum(isinstance(node, Block | Joint) for node in nodes(whole))
    sets = TeamSets(names.crew, whole)
    if moves and len(sets.groups) * (len(sets.groups) + len(moves) + looking) <= MOST_PAIRS:
        _GroupLosses(whole, names, moves, sets).report_losses(report)


class _GroupLosses:
    def __init__(self, whole: Seq, names: Names, moves: list[Move], sets: TeamSets) -> None:
        self.names = names
        self.moves = moves
        self.sets = sets
        self.groups = self.sets.groups
        self.within = {name: self.inner(name) for name in self.groups}
        self.own = {
            name: frozenset(
                atom for one in inside if one == name or one not in self.groups for atom in self.names.atom(one)
            )
            for name, inside in self.groups.items()
        }
        self.all = {
            name: frozenset[Atom]().union(*(self.own[one] for one in inside)) for name, inside in self.within.items()
        }
        self.taken: dict[tuple[str, str], dict[_Part, int]] = {}
        self.changed = frozenset(part for move in moves for part in self.effect(move))
        self.losses = {part: max(loss) for part, loss in self.of(whole).items()}

    def inner(self, group: str) -> frozenset[str]:
        """The groups in a group, it itself among them."""
        waiting, found = [group], {group}
        while waiting:
            inside = {one for one in self.groups[waiting.pop()] if one in self.groups} - found
            found |= inside
            waiting += inside
        return frozenset(found)

    # -- how many go

    def effect(self, move: Move) -> dict[_Part, int]:
        """The parts that a MOVE changes: 1 where robots go, -1 where they come."""
        source, target = str(move.source), str(move.target)
        known = self.taken.get((source, target))
        if known is None:
            known = self.taken[source, target] = dict(self.signs(source, target))
        return known

    def signs(self, source: str, target: str) -> Iterator[tuple[_Part, int]]:
        if source == target or source not in self.within or target not in self.within:
            return
        left = self.within[source]
        for name, inside in self.within.items():
            for part, goes, comes in (
                (_Part(name, True), not left.isdisjoint(inside), target in inside),
                (_Part(name, False), name in left, target == name),
            ):
                if goes is not comes:
                    yield part, 1 if goes else -1

    def of(self, seq: Seq) -> _Losses:
        found: _Losses = {}
        for node in seq.items:
            _then(found, self.by(node))
        return found

    def by(self, node: Instr) -> _Losses:
        if isinstance(node, Move):
            count = node.count if isinstance(node.count, int) else 0
            return {part: _Loss(sign * count) for part, sign in self.effect(node).items()}
        rows = [self.of(body) for body in bodies(node)]
        if isinstance(node, Parallel):
            inside = {part: _beside(row.get(part, _NOTHING) for row in rows) for row in rows for part in row}
        else:
            if isinstance(node, Conditional) and node.orelse is None:
                rows.append({})
            inside = {part: _either(row.get(part, _NOTHING) for row in rows) for row in rows for part in row}
        if isinstance(node, Repeat) and isinstance(node.count, int):
            inside = {part: _again(loss, node.count) for part, loss in inside.items()}
        elif isinstance(node, While):
            inside = {part: _again(loss, _MANY if loss.net > 0 else 0) for part, loss in inside.items()}
        found: _Losses = dict.fromkeys(self.queried_groups(node), _Loss(0, 0))
        _then(found, inside)
        return found

    def queried_groups(self, node: Instr) -> Iterable[_Part]:
        """The parts whose robots an instruction looks for before what stands in it."""
        asked: list[Block | Joint] = [node] if isinstance(node, Block) else []
        condition = getattr(node, "condition", None)
        if isinstance(condition, Node):
            asked += [one for one in nodes(condition) if isinstance(one, Joint)]
        named = {name for one in asked if isinstance(one.members, Members) for name in one.members.names}
        inside = {group for name in named & self.within.keys() for group in self.within[name]}
        return [part for part in self.changed if part.group in inside]

    # -- who is left

    def left(self, group: str, counts: dict[str, int]) -> int:
        """How many robots are left in a group at least, when each role has so many."""

        def count(atoms: Atoms) -> int:
            return sum(counts[one.name] if one.is_role else 1 for one in atoms)

        found = [count(self.staying(group))]
        for name in self.within[group]:
            found.append(count(self.all[name]) - self.losses.get(_Part(name, True), 0))
            found.append(count(self.own[name]) - self.losses.get(_Part(name, False), 0))
        return max(found)

    def staying(self, group: str) -> Atoms:
        """Those of a group whose robots no MOVE takes away."""
        kept = [name for name in self.within[group] if self.losses.get(_Part(name, False), 0) <= 0]
        return frozenset[Atom]().union(*(self.own[name] for name in kept))

    def failures(self, atom: Atom, group: str) -> set[str]:
        """What the groups say of the failure of a robot in a group, those that it is in whatever moves."""
        said = {name: one.failure for name, one in self.names.groups.items() if name in self.groups}
        return {
            failure
            for name, failure in said.items()
            if group in self.within[name]
            or (atom in self.all[name] and atom in self.all[group] and not self.takes_from(name))
        }

    def takes_from(self, group: str) -> Move | None:
        """The last MOVE that takes robots out of a group; None where there is none."""
        part = _Part(group, True)
        return next((one for one in reversed(self.moves) if self.effect(one).get(part, 0) > 0), None)

    # -- what is told

    def report_losses(self, report: Report) -> None:
        crew = self.names.crew
        least = {name: role.least for name, role in self.names.roles.items()}
        players = dict(zip((role.name for role in crew.roles), crew.players, strict=True))
        for group in self.groups:
            move = self.takes_from(group)
            if move is None or self.losses.get(_Part(group, True), 0) <= 0:
                continue
            if self.left(group, least) <= 0:
                fewest = self.names.fewest(group)
                message = Sentence("`{group}` can lose all its members: it may have no more than {few}", group, fewest)
                report(rules.GROUP_EMPTY, message, move, Sentence("move fewer, move some back, or want more in it"))
            elif self.left(group, players) == 1 and (help := self.way_out(group)) is not None:
                message = Sentence(
                    "`{group}` may have one robot left after this MOVE, and none when that one fails", group
                )
                report(rules.GROUP_EMPTY, message, move, help)

    def way_out(self, group: str) -> Help | None:
        """What can be done about the failure of the last robot of a group; None where its failure leaves no gap."""
        help: Help | None = None
        for atom in sorted(self.staying(group) or self.sets.ever((group,))):
            said = self.failures(atom, group)
            if "abort" in said:
                continue
            if "substitute" not in said:
                return Sentence(
                    "move fewer, or write at a group that holds it `on failure abort`, or `on failure substitute` with "
                    "a spare robot of its kind"
                )
            if self.names.crew.spare(atom.kind) <= 0:
                help = Sentence("move fewer, add a spare robot of its kind, or write `on failure abort`")
        return help


def _then(found: _Losses, more: _Losses) -> None:
    """What is lost when something follows, put into `found`."""
    for part, loss in more.items():
        before = found.get(part, _NOTHING)
        worst = max(before.worst, before.net + loss.worst)
        found[part] = _Loss(min(before.net + loss.net, _MANY), worst)


def _either(rows: Iterable[_Loss]) -> _Loss:
    return _Loss(*map(max, zip(*rows, strict=True)))


def _beside(rows: Iterable[_Loss]) -> _Loss:
    """What is lost when several are done at the same time."""
    losses = list(rows)
    net = sum(loss.net for loss in losses)
    going = sum(max(loss.net, 0) for loss in losses)
    return _Loss(min(net, _MANY), max(loss.worst + going - max(loss.net, 0) for loss in losses))


def _again(loss: _Loss, times: int) -> _Loss:
    """What is lost in so many passes; of a loop that loses none, 0 for any number of them."""
    before = max(loss.net, 0) * max(times - 1, 0)
    return _Loss(min(loss.net * times, _MANY), min(loss.worst + before, _MANY))
