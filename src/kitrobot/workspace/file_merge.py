"""Merges of two people's edits, with a check of the result: missions, and files of missions and kits.

A merge of two valid missions can be invalid where one side removed what the other uses. A problem of the result that
neither side had is a conflict, so the merge does not count as clean. The kind of a file follows from its first bytes,
since git may give it any name.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.files.disk import expect_unchanged, read_bytes, replace_file, same_file, saving_in
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import save, write_mission
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.text.sentences import Sentence
from kitrobot.versions.conflicts import Conflict
from kitrobot.versions.file_comparison import CompareError, kit_whole, mission_whole
from kitrobot.versions.kit_merge import merge_kits
from kitrobot.versions.mission_merge import MergeResult, merge_missions
from kitrobot.workspace.mission_loader import OpenMission, read_mission_data
from kitrobot.workspace.search_path import SearchPath

_KIT = re.compile(rb"(?:\xef\xbb\xbf)?(?:\s|(?><\?.*?\?>)|(?><!--.*?-->))*+<board(?![\w.-])", re.DOTALL)
_BEGINNING = 100_000


def merge_checked(
    base: Mission,
    ours: Mission,
    theirs: Mission,
    opened: Callable[[Mission], OpenMission],
    taken: Collection[str] = (),
) -> MergeResult:
    """The mission with both sides' edits, and what is wrong with it that is wrong with neither side as a conflict.

    Args:
        base: what both began with.
        ours: our mission.
        theirs: theirs.
        opened: a mission among the robots, parts and worlds that it is to be used with.
        taken: names of conflicts in which theirs is taken.
    """
    merged = merge_missions(base, ours, theirs, taken)
    if merged.mission in (ours, theirs):
        return merged
    found = _errors(opened(merged.mission))
    if not found:
        return merged
    known = {*_errors(opened(ours)), *_errors(opened(theirs))}
    clashes = tuple(
        Conflict(message, message, Sentence("the two do not fit together: {problem}", message), open=False)
        for code, message in dict.fromkeys(found)
        if (code, message) not in known
    )
    return replace(merged, clashes=(*merged.clashes, *clashes))


def _errors(opened: OpenMission) -> list[tuple[str, str]]:
    """Code and sentence of each error."""
    return [(item.code, item.message) for item in opened.check().problems if item.is_error]


class FileMerge(NamedTuple):
    """What became of files: the conflicts, and where the result is neither of the two, what reading them left out."""

    conflicts: tuple[Conflict, ...]
    left_out: tuple[Diagnostic, ...] = ()
    sources: tuple[Source, ...] = ()


def merge_files(base: Path, ours: Path, theirs: Path, out: Path) -> FileMerge:
    """Merges three `.krt`, or three `.board.xml`, into `out`; an empty base is none (both sides added the file).

    Raises:
        OutputPlaceError: `out` is a file that is read, and not `ours`; nothing is written.
        CompareError: some are kits and some are not; nothing is written.
        ProblemsError: one of them cannot be used; nothing is written.
        FileError: one of them cannot be read, or `out` is one of them and was changed meanwhile; nothing is written.
        SaveError: the result could not be written.
    """
    over = same_file(ours, out)
    if not over:
        expect_output(out, base, theirs)
    paths = (base, ours, theirs)
    data = [read_bytes(path) for path in paths]
    kits = [_KIT.match(one[:_BEGINNING]) is not None for one in data if one.strip()]
    if any(kits) and not all(kits):
        raise CompareError(
            Sentence("expected three kits, found one or two and something else"),
            Sentence("name three files that end in .board.xml"),
        )
    if any(kits):
        old = kit_whole(data[0], base) if data[0].strip() else None
        one, other = kit_whole(data[1], ours), kit_whole(data[2], theirs)
        kit, conflicts = merge_kits(old, one, other)
        # A file that says all of it stays as its person wrote it.
        text = data[1] if kit == one else data[2] if kit == other else None
        with saving_in(out):
            _expect_unchanged(paths, data, out)
            replace_file(out, write_kit(kit).encode() if text is None else text, over_input=over)
        return FileMerge(conflicts) if text is not None else _with_warnings(conflicts, paths, data, read_kit)
    ancestor = mission_whole(data[0], base) if data[0].strip() else Mission()
    search = SearchPath(out.parent)
    search = replace(search, known=search.catalogue())
    our_mission, their_mission = mission_whole(data[1], ours), mission_whole(data[2], theirs)
    merged = merge_checked(
        ancestor,
        our_mission,
        their_mission,
        lambda mission: read_mission_data(write_mission(mission), str(out), search),
    )
    text = data[1] if merged.mission == our_mission else data[2] if merged.mission == their_mission else None
    with saving_in(out):
        _expect_unchanged(paths, data, out)
        save(out, merged.mission, text, over_input=over)
    return FileMerge(merged.clashes) if text is not None else _with_warnings(merged.clashes, paths, data, read_mission)


def _with_warnings(
    conflicts: tuple[Conflict, ...],
    paths: Sequence[Path],
    data: Sequence[bytes],
    read: Callable[[bytes, str], tuple[Any, list[Diagnostic]]],
) -> FileMerge:
    """The conflicts, and what reading the two sides left out."""
    found = [item for one, path in zip(data[1:], paths[1:], strict=True) for item in read(one, str(path))[1]]
    sources = [Source(str(path), one.decode("utf-8-sig", "replace")) for one, path in zip(data, paths, strict=True)]
    return FileMerge(conflicts, tuple(item for item in found if item.code.startswith("xml-")), tuple(sources))


def _expect_unchanged(paths: tuple[Path, ...], data: list[bytes], out: Path) -> None:
    for path, before in zip(paths, data, strict=True):
        if same_file(path, out):
            expect_unchanged(path, before)
