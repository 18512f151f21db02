"""Files held against each other: missions, kits and what else reads as text."""

from __future__ import annotations

from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError, Source
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.files.disk import read_bytes
from kitrobot.files.embedded_mission import read_carried
from kitrobot.files.layout import lay_out_file
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.rules import NO_PROGRAM
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.kit_xml import KIT_SUFFIX, read_kit
from kitrobot.text.sentences import Sentence
from kitrobot.versions.comparison import Difference, differences, text_differences
from kitrobot.versions.kits import kit_differences


class CompareError(KitRobotError):
    """Two files that cannot be held against each other."""


def compare_files(before: Path, after: Path) -> list[Difference]:
    """What is different between two `.krt` (or pictures that carry one), two `.board.xml`, or two `.lll` by their true
    layout.

    Raises:
        CompareError: they are not two of a kind.
        ProblemsError: what one of them says cannot be used.
        FileError: one of them cannot be read.
    """
    kits = [path for path in (before, after) if path.name.lower().endswith(KIT_SUFFIX)]
    if len(kits) == 1:
        raise CompareError(
            Sentence("expected two kits, found one and something else"),
            Sentence("name two files that end in .board.xml"),
        )
    if kits:
        one, other = (kit_whole(read_bytes(path), path) for path in (before, after))
        return [Difference(kind, words) for kind, words in kit_differences(one, other)]
    kinds = {before.suffix.lower(), after.suffix.lower()}
    if kinds == {".lll"}:
        return text_differences(_laid_out(before), _laid_out(after))
    if ".lll" in kinds:
        raise CompareError(
            Sentence("expected two missions or two LLL texts, found one of each"), Sentence("convert one of them first")
        )
    return differences(mission_whole(read_carried(before), before), mission_whole(read_carried(after), after))


def mission_whole(data: bytes, path: Path) -> Mission:
    """The mission in the bytes of a file, all of which can be used.

    Raises:
        ProblemsError: some of it cannot.
    """
    mission, diagnostics = read_mission(data, str(path))
    if mission is None or any(item.is_error and item.code != NO_PROGRAM.code for item in diagnostics):
        source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
        raise ProblemsError(
            Sentence("`{path}` cannot be used", path), Sentence("mend it first"), tuple(diagnostics), (source,)
        )
    return mission


def kit_whole(data: bytes, path: Path) -> Kit:
    """The kit in the bytes of a file, as `mission_whole`."""
    kit, diagnostics = read_kit(data, str(path))
    if kit is None:
        source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
        raise ProblemsError(
            Sentence("`{path}` cannot be used", path), Sentence("mend it first"), tuple(diagnostics), (source,)
        )
    return kit


def _laid_out(path: Path) -> str:
    layout = lay_out_file(path)
    if layout.text is None:
        raise ProblemsError(
            Sentence("`{path}` cannot be used", path), Sentence("mend it first"), layout.diagnostics, (layout.source,)
        )
    return layout.text
