"""Lists of things with names, three-way merged: which things are in the result, and in which order."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

from kitrobot.text.sentences import Sentence, Word

T = TypeVar("T")


def merged_by_name(
    base: Sequence[T],
    ours: Sequence[T],
    theirs: Sequence[T],
    name_of: Callable[[T], Hashable],
    what: str,
    choose: Callable[[str, Any, Any, Any], Any],
    title_of: Callable[[T], Sentence] | None = None,
) -> list[T]:
    """Lists of things with names; as a whole where a name stands twice.

    Args:
        base: what both began with.
        ours: our list.
        theirs: theirs.
        name_of: by what a thing is found again.
        what: what the things are, such as *the agent*.
        choose: decides between the three of a thing, None where it is not there.
        title_of: what a thing is called in a sentence; without it, `what` and its name.
    """
    sides = [{name_of(item): item for item in side} for side in (base, ours, theirs)]
    if any(len(side) != len(list_) for side, list_ in zip(sides, (base, ours, theirs), strict=True)):
        found: list[T] = choose(Sentence("the list with {what} …", what), list(base), list(ours), list(theirs))
        return found
    old, mine, other = sides
    kept: dict[Hashable, Any] = {}
    for name, one in {**other, **mine}.items():
        title = title_of(one) if title_of is not None else Sentence("{what} {name}", what, str(name))
        kept[name] = choose(title, old.get(name), mine.get(name), other.get(name))
    return [kept[name] for name in merged_order(old, mine, other) if kept[name] is not None]


def merged_values(
    what: str,
    base: Mapping[str, T],
    ours: Mapping[str, T],
    theirs: Mapping[str, T],
    choose: Callable[[str, Any, Any, Any], Any],
) -> dict[str, T]:
    """Values by name, each merged by itself; the one without a name is what `what` says."""
    found: dict[str, T] = {}
    for name in merged_order(base, ours, theirs):
        title = Sentence("the {setting} of {vertex}", Word(name), what) if name else what
        value = choose(title, base.get(name), ours.get(name), theirs.get(name))
        if value is not None:
            found[name] = value
    return found


def merged_nameless(base: Sequence[T], ours: Sequence[T], theirs: Sequence[T]) -> tuple[T, ...]:
    """Ours without what they took away, and with what they brought."""
    before, here, there = set(base), set(ours), set(theirs)
    kept = [part for part in ours if part not in before or part in there]
    return (*kept, *(part for part in theirs if part not in before and part not in here))


def merged_order(base: Iterable[Any], ours: Iterable[Any], theirs: Iterable[Any]) -> list[Any]:
    """Everybody's names: in our order, what only they have behind what it follows with them."""
    old, mine, other = list(base), list(ours), list(theirs)
    if mine == old:
        theirs_too = set(other)
        return [*other, *(name for name in mine if name not in theirs_too)]
    have = set(mine)
    behind: dict[Any, list[Any]] = {}  # what only they have, by the name before it; None at the end
    before: Any = None
    for name in other:
        if name not in have:
            behind.setdefault(before, []).append(name)
        else:
            before = name
    return [one for name in (*mine, None) for one in (*([] if name is None else [name]), *behind.get(name, ()))]
