"""Files of two people brought together: missions, and kits. What a file is its first bytes say: git names it anyhow."""

from __future__ import annotations

import re
from pathlib import Path

from kitrobot.files import expect_unchanged, read_bytes, replace_file, same_file, saving_in
from kitrobot.mission import Mission, save
from kitrobot.primitives import write_kit
from kitrobot.text import Sentence
from kitrobot.versions.comparison import CompareError, kit_whole, mission_whole
from kitrobot.versions.conflicts import Conflict
from kitrobot.versions.kit_merging import merge_kits
from kitrobot.versions.merging import merge_missions

_KIT = re.compile(rb"(?:\xef\xbb\xbf)?(?:\s|(?><\?.*?\?>)|(?><!--.*?-->))*+<board(?![\w.-])", re.DOTALL)
_BEGINNING = 100_000


def merge_files(base: Path, ours: Path, theirs: Path, out: Path) -> tuple[Conflict, ...]:
    """Merges three `.krt`, or three `.board.xml`, into `out`; an empty base is none (both sides added the file).

    Returns:
        What both changed differently.

    Raises:
        CompareError: some are kits and some are not; nothing is written.
        ProblemsError: one of them cannot be used; nothing is written.
        FileError: one of them cannot be read, or `out` is one of them and was changed meanwhile; nothing is written.
        SaveError: the result could not be written.
    """
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
        text = data[1] if kit == one else data[2] if kit == other else write_kit(kit).encode()
        with saving_in(out):
            _expect_unchanged(paths, data, out)
            replace_file(out, text)
        return conflicts
    ancestor = mission_whole(data[0], base) if data[0].strip() else Mission()
    merged = merge_missions(ancestor, mission_whole(data[1], ours), mission_whole(data[2], theirs))
    with saving_in(out):
        _expect_unchanged(paths, data, out)
        save(out, merged.mission)
    return merged.clashes


def _expect_unchanged(paths: tuple[Path, ...], data: list[bytes], out: Path) -> None:
    for path, before in zip(paths, data, strict=True):
        if same_file(path, out):
            expect_unchanged(path, before)
