"""What is different between two missions, or two LLL texts, in words.

Programs are found again by name, or by what they hold when they were renamed; vertices by their id, unless another
element stands at another place under the same one. What stands in a
chain is held against the same chain, so one instruction put in is one difference and not one for each that follows.
Nothing different is ever left out: where no words fit better, the part that differs is named.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace

from kitrobot.compiler.common_order import common_order
from kitrobot.graph.model import Note, Program, Vertex
from kitrobot.mission.model import Mission
from kitrobot.text.sentences import Sentence, Word
from kitrobot.versions.outline import PARKED, Outline
from kitrobot.versions.own_parts import TOLD_HERE, own_part_differences
from kitrobot.versions.own_worlds import world_differences
from kitrobot.versions.phrases import named, quoted, short, value, where
from kitrobot.versions.program_renames import renamed_programs
from kitrobot.versions.team import team_differences


@dataclass(frozen=True)
class Difference:
    """One difference. `kind` is one of a few words for programs to read; `vertex` is "" when it is about none."""

    kind: str
    words: str
    program: str = ""
    vertex: str = ""

    @property
    def sentence(self) -> str:
        """The words, after the program that they are about."""
        return f"{self.program}: {self.words}" if self.program else self.words


def differences(before: Mission, after: Mission) -> list[Difference]:
    """What makes `after` of `before`; empty when they are equal."""
    found = list(_programs(before, after))
    found += [Difference(kind, words) for kind, words in team_differences(before.team, after.team)]
    found += [Difference(kind, words) for kind, words in world_differences(before, after)]
    found += [Difference(kind, words) for kind, words in own_part_differences(before, after)]
    for field in fields(Mission):
        one, other = getattr(before, field.name), getattr(after, field.name)
        if field.name not in ("programs", "team", "world_href", "own_world", *TOLD_HERE) and one != other:
            found.append(
                Difference(
                    "mission",
                    Sentence(
                        "the {field} of the mission: {before} → {after}", Word(field.name), short(one), short(other)
                    ),
                )
            )
    return found


def text_differences(before: str, after: str) -> list[Difference]:
    """What is different between two LLL texts, both in the true layout, by their lines."""
    old, new = before.removesuffix("\n").split("\n"), after.removesuffix("\n").split("\n")
    found = []
    i = k = 0
    for j, m in (*common_order(old, new), (len(old), len(new))):
        pairs = min(j - i, m - k)
        for step in range(pairs):
            words = Sentence(
                "line {line}: `{old}` → `{new}`", k + step + 1, old[i + step].strip(), new[k + step].strip()
            )
            found.append(Difference("line-changed", words))
        found += [
            Difference("line-removed", Sentence("line {line} removed: `{old}`", at + 1, old[at].strip()))
            for at in range(i + pairs, j)
        ]
        found += [
            Difference("line-added", Sentence("line {line} added: `{new}`", at + 1, new[at].strip()))
            for at in range(k + pairs, m)
        ]
        i, k = j + 1, m + 1
    return found


def _programs(before: Mission, after: Mission) -> Iterator[Difference]:
    renamed = renamed_programs(before, after)
    came_from = {new: old for old, new in renamed.items()}
    kept = {renamed.get(program.name, program.name) for program in before.programs}
    was = {program.name: program for program in reversed(before.programs)}
    now = {program.name for program in after.programs}
    for program in before.programs:
        name = renamed.get(program.name, program.name)
        if name not in now:
            yield Difference("program-removed", Sentence("the program {program} removed", program.name))
    for program in after.programs:
        old = was.get(came_from.get(program.name, program.name))
        if old is None:
            yield Difference(
                "program-added",
                Sentence("the program {program} added, for the robot {robot}", program.name, program.target)
                if not program.level.is_team
                else Sentence("the program {program} added, of the level {level}", program.name, Word(program.level)),
            )
            continue
        if old.name != program.name:
            yield Difference(
                "program-renamed", Sentence("the program {before} renamed to {after}", old.name, program.name)
            )
        yield from _program(old, program)
    order = [name for name in (renamed.get(one.name, one.name) for one in before.programs) if name in now]
    if order != [program.name for program in after.programs if program.name in kept]:
        yield Difference("order", Sentence("the programs stand in another order"))


def _program(before: Program, after: Program) -> Iterator[Difference]:
    name = after.name
    if before.level != after.level:
        words = Sentence("the level: {before} → {after}", Word(before.level), Word(after.level))
        yield Difference("level", words, name)
    elif before.target != after.target:
        yield Difference("robot", Sentence("the robot: {before} → {after}", before.target, after.target), name)
    old, new = Outline(before), Outline(after)
    told = False
    for found in _vertices(old, new, name):
        told = told or found.kind in ("added", "removed", "moved")
        yield found
    if told or (before.arcs == after.arcs and [v.id for v in before.vertices] == [v.id for v in after.vertices]):
        return
    arcs = [{(arc.source, arc.out, arc.target, arc.at) for arc in program.arcs} for program in (before, after)]
    for source, out, target, at in sorted(arcs[0] - arcs[1]):
        yield Difference(
            "arc-removed",
            Sentence("the arc {source}.{out} → {target}.{at} removed", source, out, target, at),
            name,
            source,
        )
    for source, out, target, at in sorted(arcs[1] - arcs[0]):
        yield Difference(
            "arc-added", Sentence("the arc {source}.{out} → {target}.{at} added", source, out, target, at), name, source
        )
    if arcs[0] == arcs[1]:
        yield Difference("order", Sentence("the same vertices and arcs in another order of the file"), name)


def _is_another(before: Vertex, after: Vertex, moved: set[str]) -> bool:
    """Whether two parts only share their id: another element at another place."""
    return before.element != after.element and after.id in moved


def _vertices(old: Outline, new: Outline, name: str) -> Iterator[Difference]:
    moved = _moved(old, new)
    for id, vertex in old.vertices.items():
        now = new.vertices.get(id)
        if now is None or _is_another(vertex, now, moved):
            yield Difference(
                "removed", Sentence("{vertex} removed, it stood{where}", named(vertex), where(old, id)), name, id
            )
    for id, vertex in new.vertices.items():
        before = old.vertices.get(id)
        if before is None or _is_another(before, vertex, moved):
            yield Difference("added", Sentence("{vertex} added{where}", named(vertex), where(new, id)), name, id)
            yield from _inside(Vertex(id, vertex.element, vertex.settings), vertex, name)
            continue
        if id in moved:
            yield Difference("moved", Sentence("{vertex} moved{where}", named(vertex), where(new, id)), name, id)
        yield from _inside(before, vertex, name)


def _inside(before: Vertex, after: Vertex, name: str) -> Iterator[Difference]:
    """What is different in a vertex itself."""
    what = named(after)
    if before.element != after.element:
        yield Difference(
            "element", Sentence("{before} became {after}", named(before), Word(after.element)), name, after.id
        )
        # Its settings are those of another part: one added says none of them either.
        before = replace(before, settings=after.settings)
    for setting in dict.fromkeys((*before.settings, *after.settings)):
        one, other = before.settings.get(setting), after.settings.get(setting)
        if one != other:
            words = Sentence(
                "the {setting} of {vertex}: {before} → {after}", Word(setting), what, value(one), value(other)
            )
            yield Difference("setting", words, name, after.id)
    for old_note, new_note in _note_pairs(before.notes, after.notes):
        if old_note is None and new_note is not None:
            yield Difference(
                "note-added", Sentence("a note at {vertex} added: {note}", what, quoted(new_note.text)), name, after.id
            )
        elif old_note is not None and new_note is None:
            yield Difference(
                "note-removed",
                Sentence("the note {note} at {vertex} removed", quoted(old_note.text), what),
                name,
                after.id,
            )
        elif old_note is not None and new_note is not None:
            words = Sentence(
                "the note at {vertex}: {before} → {after}", what, quoted(old_note.text), quoted(new_note.text)
            )
            yield Difference("note", words, name, after.id)
    for field in fields(Vertex):
        one_value, other_value = getattr(before, field.name), getattr(after, field.name)
        if field.name not in ("id", "element", "settings", "notes") and one_value != other_value:
            words = Sentence(
                "the {setting} of {vertex}: {before} → {after}",
                Word(field.name),
                what,
                short(one_value),
                short(other_value),
            )
            yield Difference("vertex", words, name, after.id)
    if before.settings == after.settings and list(before.settings) != list(after.settings):
        yield Difference("order", Sentence("the settings of {vertex} stand in another order", what), name, after.id)


def _note_pairs(before: Sequence[Note], after: Sequence[Note]) -> list[tuple[Note | None, Note | None]]:
    """The notes that differ, old beside new where they stand at one place."""
    had, has = {(note.at, note.text) for note in before}, {(note.at, note.text) for note in after}
    old = [note for note in before if (note.at, note.text) not in has]
    new: dict[str, deque[Note]] = {}
    for note in after:
        if (note.at, note.text) not in had:
            new.setdefault(note.at, deque()).append(note)
    pairs: list[tuple[Note | None, Note | None]] = [
        (note, new[note.at].popleft() if new.get(note.at) else None) for note in old
    ]
    pairs += [(None, note) for notes in new.values() for note in notes]
    if not pairs and list(before) != list(after):
        pairs = [(note, None) for note in before] + [(None, note) for note in after]
    return pairs


def _moved(old: Outline, new: Outline) -> set[str]:
    """Vertices that stand in another chain now, or before or behind others than they did; as few as explain it."""
    both = old.spots.keys() & new.spots.keys()
    home = {id: _home(old, id) for id in both}
    moved = {id for id in both if home[id] != _home(new, id)}
    for members in new.chains.values():
        stayed = [id for id in members if id in both and id not in moved]
        places = [old.spots[id].index for id in stayed]
        if len({old.spots[id].chain for id in stayed}) == 1:
            keep = _longest_rising(places)
            moved |= {id for at, id in enumerate(stayed) if at not in keep}
    return moved


def _home(outline: Outline, id: str) -> tuple[str, str]:
    holder, slot = outline.spots[id].chain
    return ("", PARKED) if slot == PARKED else (holder, slot)


def _longest_rising(places: Sequence[int]) -> set[int]:
    """The indices of a longest rising selection."""
    ends: list[int] = []
    values: list[int] = []
    before: list[int] = []
    for at, place in enumerate(places):
        length = bisect_left(values, place)
        before.append(ends[length - 1] if length else -1)
        ends[length : length + 1] = [at]
        values[length : length + 1] = [place]
    found: set[int] = set()
    at = ends[-1] if ends else -1
    while at >= 0:
        found.add(at)
        at = before[at]
    return found
