"""Kits at hand: shipped, the user's own, and those beside a mission."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from kitrobot.deploy.kits.kits import kit_problems
from kitrobot.deploy.package.package import Package
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Severity, Source, rule
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.diagnostics.regular import open_regular
from kitrobot.files.disk import read_bytes
from kitrobot.primitives.catalogue import SHIPPED
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.kit_xml import KIT_SUFFIX, read_kit
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.text.suggestions import did_you_mean
from kitrobot.user_folders import config_folder
from kitrobot.workspace.robots import names_a_file

MOST_KITS = 200
"""Files of kits that are looked at, at most."""

LARGEST_KIT_BYTES = 1_000_000

KIT_WIRING = rule(
    "board-wiring",
    Severity.ERROR,
    "A kit's wiring cannot be right",
    "A kit (`NAME.board.xml`) names drivers that there are, settings that they know, pins that its board has, and each"
    " pin for one thing. Only a bus, the motors of two drivers and pins that are only read may be named twice.",
)


class NoKitError(KitRobotError):
    """There is no kit of that name."""


def kits_at_hand(folder: Path | None = None) -> dict[str, Kit]:
    """The kits by their names; those of a later folder win. A file with an error gives none."""
    found: dict[str, Kit] = {}
    for path in _files(folder):
        try:
            with open_regular(path) as stream:
                data = stream.read(LARGEST_KIT_BYTES)
        except OSError:
            continue
        kit, _ = read_kit(data, str(path))
        if kit is not None:
            found[kit.name] = kit
    return found


def _files(folder: Path | None) -> Iterator[Path]:
    for each in (SHIPPED, config_folder(), *([folder] if folder is not None else [])):
        yield from sorted(each.glob(f"*{KIT_SUFFIX}"))[:MOST_KITS]


def find_kit(word: str, folder: Path | None = None) -> Kit:
    """The kit that `word` means: the name of one at hand, or a `.board.xml` file.

    Raises:
        NoKitError: no kit has that name.
        FileError: the file cannot be read.
        ProblemsError: the file is no good kit.
    """
    if names_a_file(word):
        return read_kit_file(Path(word))
    return kit_named(word, folder)


def kit_named(name: str, folder: Path | None = None) -> Kit:
    """The kit of that name among those at hand.

    Raises:
        NoKitError: no kit has that name.
    """
    kits = kits_at_hand(folder)
    if name not in kits:
        help = did_you_mean(name, kits) or Sentence("kits at hand: {names}", Series(COMMA, sorted(kits)))
        raise NoKitError(Sentence("there is no kit named `{name}`", name), help)
    return kits[name]


def read_kit_file(path: Path) -> Kit:
    """The kit of a file.

    Raises:
        FileError: the file cannot be read.
        ProblemsError: the file is no good kit.
    """
    data = read_bytes(path)
    kit, found = read_kit(data, str(path))
    found += [] if kit is None else wiring_problems(kit, path.parent)
    if kit is None or any(one.is_error for one in found):
        source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
        raise ProblemsError(
            Sentence("the kit of `{path}` cannot be used", path), Sentence("mend its file"), tuple(found), (source,)
        )
    return kit


def wiring_problems(kit: Kit, folder: Path) -> list[Diagnostic]:
    """What is wrong with a kit's wiring; drivers of one's own are looked for in `folder` too."""
    package = Package((config_folder(), folder))
    return [
        KIT_WIRING(problem.message, part.place or Place(kit.name), help=problem.help)
        for part, problem in kit_problems(kit, package)
    ]
