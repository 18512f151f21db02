"""What two people gave other names in a mission, and the three versions of it brought to one name for each thing.

Something was renamed where it is gone and something that is equal but for its name has come; programs are found again
by what they hold. Where both gave one thing another name ours stays, unless theirs was decided on, and a sentence says
so. A name that the other side gave to something new is not taken: then nothing is followed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from kitrobot.mission.model import Mission
from kitrobot.text.sentences import Sentence, Word
from kitrobot.versions.conflicts import Decisions
from kitrobot.versions.program_renames import renamed_programs
from kitrobot.versions.references import NameKind, with_names

Sides = tuple[Mission, Mission, Mission]
"""What both began with, ours, theirs."""


class _NamedPart(NamedTuple):
    """Something with a name. `owner`: the robot of a variable, else ""; `rest`: what it is but for its name."""

    owner: str
    name: str
    rest: str


def with_one_name(base: Mission, ours: Mission, theirs: Mission, decisions: Decisions) -> Sides:
    """The three, each thing by one name in all of them, and so wherever it is named."""
    sides = base, ours, theirs
    for kind in NameKind:
        sides = _of_kind(sides, kind, decisions)
    return sides


def _of_kind(sides: Sides, kind: NameKind, decisions: Decisions) -> Sides:
    base, ours, theirs = sides
    mine, other = _renamed(kind, base, ours), _renamed(kind, base, theirs)
    there = [{(one.owner, one.name) for one in _things(kind, side)} for side in sides]
    changes: tuple[dict[str, dict[str, str]], ...] = (defaultdict(dict), defaultdict(dict), defaultdict(dict))
    for owner, old in {**mine, **other}:
        names = old, mine.get((owner, old), old), other.get((owner, old), old)
        new = _one_of(kind, names, decisions)
        if any(new != name and (owner, new) in known for name, known in zip(names, there, strict=True)):
            continue
        for name, change in zip(names, changes, strict=True):
            change[owner][name] = new
    found = []
    for side, change in zip(sides, changes, strict=True):
        for owner, renames in change.items():
            side = with_names(side, kind, renames, owner)
        found.append(side)
    return found[0], found[1], found[2]


def _one_of(kind: NameKind, names: tuple[str, str, str], decisions: Decisions) -> str:
    old, mine, other = names
    if other in (old, mine):
        return mine
    if mine == old:
        return other
    what = Sentence("the name of the {kind} {name}", Word(kind.value), old)
    takes = decisions.takes(
        what,
        Sentence("{what} was changed in both: ours is kept", what),
        Sentence("{what} was changed in both: theirs is taken", what),
        mine,
        other,
    )
    return other if takes else mine


def _renamed(kind: NameKind, before: Mission, after: Mission) -> Mapping[tuple[str, str], str]:
    """Owner and old name → new name."""
    if kind is NameKind.PROGRAM:
        return {("", old): new for old, new in renamed_programs(before, after).items()}
    old, new = _things(kind, before), _things(kind, after)
    had, has = {(one.owner, one.name) for one in old}, {(one.owner, one.name) for one in new}
    gone, come = _by_rest(old, has), _by_rest(new, had)
    found: dict[tuple[str, str], str] = {}
    for rest, things in gone.items():
        others = come.get(rest, [])
        # Of several that are alike nobody can say which became which, but by their order.
        if len(things) == len(others):
            found.update(((one.owner, one.name), to.name) for one, to in zip(things, others, strict=True))
    return found


def _by_rest(things: Iterable[_NamedPart], known: set[tuple[str, str]]) -> Mapping[tuple[str, str], list[_NamedPart]]:
    """Those that the other version has not, by owner and what they are."""
    found: defaultdict[tuple[str, str], list[_NamedPart]] = defaultdict(list)
    for one in things:
        if (one.owner, one.name) not in known:
            found[one.owner, one.rest].append(one)
    return found


def _things(kind: NameKind, mission: Mission) -> list[_NamedPart]:
    world, team = mission.own_world, mission.team
    match kind:
        case NameKind.VARIABLE:
            # Its label and its methods say what it is called.
            bare = [(one.robot, one.variable) for one in mission.variables]
            rests = [replace(one, name="", label={}, methods=()) for _, one in bare]
            return [_NamedPart(robot, one.name, repr(rest)) for (robot, one), rest in zip(bare, rests, strict=True)]
        case NameKind.PART:
            return _alike(mission.constructors, lambda one: replace(one, name="", label={}, template=None, reads=()))
        case NameKind.PROGRAM:
            return [_NamedPart("", one.name, "") for one in mission.programs]
        case NameKind.AGENT:
            return _alike(team.agents, lambda one: (one.program, one.robot, one.start_name))
        case NameKind.ROLE:
            return _alike(team.roles, lambda one: (one.robot, one.least, one.most))
        case NameKind.GROUP:
            return _alike(team.groups, lambda one: (one.members.names, one.failure))
        case NameKind.WORK:
            return _alike(team.works, lambda one: (one.units, one.lease))
        case _:
            rows: Sequence[Any] = getattr(world, f"{kind.value}s") if world is not None else ()
            return _alike(rows, lambda one: replace(one, name=""))


def _alike(things: Iterable[Any], rest: Callable[[Any], object]) -> list[_NamedPart]:
    return [_NamedPart("", one.name, repr(rest(one))) for one in things]
