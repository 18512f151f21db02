"""Two people's edits of one kit brought together: a three-way merge by parts, and in a part by its settings.

What only one side changed is taken from it; where both changed the same thing differently ours stays, and a sentence
says so. A result that would be no kit (both wired the same part, each in an element of its own) is ours as a whole,
and that is said too. Left to others: files.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import Any

from kitrobot.primitives.kit import Kit, KitPart, Measurement
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.primitives.robot import Board, Texts
from kitrobot.text.sentences import Sentence, Word
from kitrobot.versions.conflicts import Conflict, Decisions
from kitrobot.versions.kits import named_part
from kitrobot.versions.lists import merged_by_name, merged_nameless, merged_order, merged_values

Choose = Callable[[str, Any, Any, Any], Any]

_TEXTS = ("label", "help", "attributes")
_UNKNOWN = ("unknown", "prolog")
_LINES = ("supplies", "steps")
_PARTED = ("parts", "measured", "sources", "modules", "place")
"""Fields of a kit that are merged piece by piece, as its texts are, or not at all."""


def merge_kits(base: Kit | None, ours: Kit, theirs: Kit) -> tuple[Kit, tuple[Conflict, ...]]:
    """The kit with both sides' edits of `base` (None: both added the file), and what both changed differently."""
    if theirs in (base, ours):
        return ours, ()
    if ours == base:
        return theirs, ()
    decisions = Decisions()
    merged = _merged(base or Kit(ours.name, ours.family), ours, theirs, decisions.choose)
    if read_kit(write_kit(merged).encode(), ours.name)[0] is None:
        decisions = Decisions()
        words = Sentence("both changed which parts are wired together: ours is kept as a whole")
        decisions.report(Sentence("the parts of the kit"), words)
        merged = ours
    return merged, tuple(decisions.found)


def _merged(base: Kit, ours: Kit, theirs: Kit, choose: Choose) -> Kit:
    values: dict[str, Any] = {}
    for field in fields(Kit):
        what = Sentence("the {field} of the kit", Word(field.name))
        one, two, three = (getattr(side, field.name) for side in (base, ours, theirs))
        if field.name in _TEXTS:
            values[field.name] = merged_values(what, one, two, three, choose)
        elif field.name in _UNKNOWN:
            values[field.name] = merged_nameless(one, two, three)
        elif field.name in _LINES:
            values[field.name] = _lines(what, one, two, three, choose)
        elif field.name not in _PARTED:
            values[field.name] = choose(what, one, two, three)
    values["parts"] = tuple(_parts(base.parts, ours.parts, theirs.parts, choose))
    values["measured"] = tuple(_measured(base.measured, ours.measured, theirs.measured, choose))
    word = Sentence("the source")
    sources = merged_by_name(base.sources, ours.sources, theirs.sources, lambda one: one.href, word, choose)
    word = Sentence("the module")
    modules = merged_by_name(base.modules, ours.modules, theirs.modules, lambda one: one.name, word, choose)
    return replace(ours, **values, sources=tuple(sources), modules=tuple(modules))


def _parts(
    base: Sequence[KitPart], ours: Sequence[KitPart], theirs: Sequence[KitPart], choose: Choose
) -> list[KitPart]:
    old, mine, other = ({named_part(part): part for part in side} for side in (base, ours, theirs))
    found = []
    for name in merged_order(old, mine, other):
        one, two, three = old.get(name), mine.get(name), other.get(name)
        if two is None or three is None or two == three or two.is_missing or three.is_missing:
            part = choose(Sentence("the part {part} of the kit", name), one, two, three)
        else:
            part = _part(
                name, one if one is not None and not one.is_missing else replace(two, board=Board()), two, three, choose
            )
        if part is not None:
            found.append(part)
    return found


def _part(name: str, one: KitPart, two: KitPart, three: KitPart, choose: Choose) -> KitPart:
    """Both sides' edits of how one part is wired."""
    old, mine, other = one.board, two.board, three.board
    words = Sentence("the {setting} of {vertex}", Word("driver"), name)
    driver = choose(words, old.driver, mine.driver, other.driver)
    settings = merged_values(name, old.settings, mine.settings, other.settings, choose)
    help = merged_values(
        Sentence("the {setting} of {vertex}", Word("help"), name), one.help, two.help, three.help, choose
    )
    return replace(two, board=Board(driver, settings), help=help)


def _lines(
    what: str, base: Sequence[Texts], ours: Sequence[Texts], theirs: Sequence[Texts], choose: Choose
) -> tuple[Texts, ...]:
    """What is needed or done, one by one and language by language; each is known by its English text."""
    old, mine, other = ({line.get("", ""): line for line in side} for side in (base, ours, theirs))
    if any(len(known) < len(side) for known, side in ((old, base), (mine, ours), (other, theirs))):
        whole: tuple[Texts, ...] = choose(what, base, ours, theirs)
        return whole
    found: list[Texts] = []
    for name in merged_order(old, mine, other):
        one, two, three = old.get(name), mine.get(name), other.get(name)
        if two is None or three is None:
            line = choose(what, one, two, three)
        else:
            line = merged_values(what, one or {}, two, three, choose)
        if line is not None:
            found.append(line)
    return tuple(found)


def _measured(
    base: Sequence[Measurement], ours: Sequence[Measurement], theirs: Sequence[Measurement], choose: Choose
) -> list[Measurement]:
    old, mine, other = ({one.devices: one.settings for one in side} for side in (base, ours, theirs))
    found = []
    for devices in merged_order(old, mine, other):
        one, two, three = (side.get(devices, {}) for side in (old, mine, other))
        if settings := merged_values(" ".join(devices), one, two, three, choose):
            found.append(Measurement(devices, settings))
    return found
