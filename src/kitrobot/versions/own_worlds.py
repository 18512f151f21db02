"""The worlds that missions bring along, held against each other: differences in words, and three-way merges.

Things with names are found again by them; walls, floors, lines, boxes, balls and zones have none and are found again by
what they are. What stands at one place of the list in both and differs is one thing that changed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from typing import Any

from kitrobot.mission.model import Mission
from kitrobot.text.sentences import COMMA, Sentence, Series, Word
from kitrobot.versions.lists import merged_by_name, merged_nameless, merged_values
from kitrobot.world.model import World
from kitrobot.world.xml_reader import KINDS

Choose = Callable[[str, Any, Any, Any], Any]

_NAMELESS = ("wall", "floor", "line", "box", "ball", "zone")
_UNITS = ("_mm", "_rad")


def world_differences(before: Mission, after: Mission) -> Iterator[tuple[str, str]]:
    """The kind of each difference between the places of two missions, and its words."""
    old, new = before.own_world, after.own_world
    if old is not None and new is not None:
        yield from _within(old, new)
    elif before.world_href != after.world_href or old != new:
        yield "world", Sentence("the world: {before} → {after}", _named(before), _named(after))


def _named(mission: Mission) -> str:
    if mission.own_world is not None:
        return Sentence("its own, {world}", mission.own_world.name)
    return mission.world_href or Word("empty")


def _within(old: World, new: World) -> Iterator[tuple[str, str]]:
    lists = [field for field, _ in KINDS.values()]
    for field in fields(World):
        if field.name not in lists and getattr(old, field.name) != getattr(new, field.name):
            yield "world", Sentence("the world: its {what} changed", _word(field.name))
    for kind, (name, _) in KINDS.items():
        was, now = getattr(old, name), getattr(new, name)
        if kind in _NAMELESS:
            yield from _nameless(kind, was, now)
        else:
            yield from _by_name(kind, was, now)


def _nameless(kind: str, old: Sequence[Any], new: Sequence[Any]) -> Iterator[tuple[str, str]]:
    gone, come = _beyond(old, new), _beyond(new, old)
    if len(old) == len(new) and gone == come:
        for at in gone:
            yield "world-thing", Sentence("the world: {kind} {name} changed", Word(kind), at + 1)
        gone, come = [], []
    for at in gone:
        yield "world-thing-removed", Sentence("the world: {kind} {name} removed", Word(kind), at + 1)
    for at in come:
        yield "world-thing-added", Sentence("the world: {kind} {name} added", Word(kind), at + 1)
    if old != new and sorted(map(repr, old)) == sorted(map(repr, new)):
        yield "order", Sentence("the world: its {kind}s stand in another order", Word(kind))


def _beyond(parts: Sequence[Any], others: Sequence[Any]) -> list[int]:
    """Where parts stand that the others have not, or not so often."""
    left = Counter(others)
    found = []
    for at, part in enumerate(parts):
        left[part] -= 1
        if left[part] < 0:
            found.append(at)
    return found


def _by_name(kind: str, old: Sequence[Any], new: Sequence[Any]) -> Iterator[tuple[str, str]]:
    was, now = {part.name: part for part in old}, {part.name: part for part in new}
    if len(was) != len(old) or len(now) != len(new):
        if old != new:
            yield "world-thing", Sentence("the world: its {kind}s changed", Word(kind))
        return
    for name in was:
        if name not in now:
            yield "world-thing-removed", Sentence("the world: {kind} {name} removed", Word(kind), name)
    for name, part in now.items():
        if name not in was:
            yield "world-thing-added", Sentence("the world: {kind} {name} added", Word(kind), name)
            continue
        one = was[name]
        changed = [_word(field.name) for field in fields(part) if getattr(one, field.name) != getattr(part, field.name)]
        if changed:
            yield (
                "world-thing",
                Sentence("the world: {kind} {name}: {changed} changed", Word(kind), name, Series(COMMA, changed)),
            )
    if list(old) != list(new) and was == now:
        yield "order", Sentence("the world: its {kind}s stand in another order", Word(kind))


def _word(field: str) -> Word:
    """A field as people call it: its name without the unit."""
    for unit in _UNITS:
        field = field.removesuffix(unit)
    return Word(field.replace("_", " "))


def merge_places(base: Mission, ours: Mission, theirs: Mission, choose: Choose) -> tuple[str, World | None]:
    """Where the merged mission takes place: the name of a world's file, and the world of its own.

    Worlds of their own are merged thing by thing, a value that both changed by `choose`.
    """
    one, mine, other = base.own_world, ours.own_world, theirs.own_world
    if one is None or mine is None or other is None:
        sides = [(side.world_href, side.own_world) for side in (base, ours, theirs)]
        found: tuple[str, World | None] = choose(Sentence("the world of the mission"), *sides)
        return found
    values: dict[str, Any] = {}
    kinds = {name: kind for kind, (name, _) in KINDS.items()}
    for field in fields(World):
        old, first, second = (getattr(side, field.name) for side in (one, mine, other))
        kind = kinds.get(field.name)
        if field.name in ("unknown", "prolog") or kind in _NAMELESS:
            values[field.name] = merged_nameless(old, first, second)
        elif field.name == "attributes":
            values[field.name] = merged_values(Sentence("the world"), old, first, second, choose)
        elif kind is None:
            values[field.name] = choose(Sentence("the {word} of the world", _word(field.name)), old, first, second)
        else:
            values[field.name] = tuple(
                merged_by_name(old, first, second, lambda part: part.name, Sentence("the {kind}", Word(kind)), choose)
            )
    return "", replace(mine, **values)
