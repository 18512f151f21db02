"""The worlds that a mission can take place in: those of its folder, then those that are shipped."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.diagnostics.regular import open_regular
from kitrobot.files.disk import FileError, read_bytes
from kitrobot.workspace.file_check import first_element
from kitrobot.world.lookup import EMPTY, SHIPPED
from kitrobot.world.model import World
from kitrobot.world.xml_reader import read_world

MOST_WORLDS = 100
_BEGINNING = 4096


@dataclass(frozen=True)
class FoundWorld:
    """A world at hand: `href` is what a mission calls it, "" for the empty one; without `world` its file is no good."""

    href: str
    shipped: bool
    world: World | None
    problems: tuple[Diagnostic, ...]


def worlds_at_hand(folders: Sequence[Path]) -> list[FoundWorld]:
    """Every world of the folders, where the first one wins name by name, then the shipped ones; in order of names."""
    found: dict[str, FoundWorld] = {}
    for folder in (*folders, SHIPPED):
        for path in _files(folder):
            if path.name not in found and len(found) < MOST_WORLDS:
                world, problems = read_world_file(path)
                href = "" if path.name == EMPTY else path.name
                found[path.name] = FoundWorld(href, folder == SHIPPED, world, problems)
    return list(found.values())


def read_world_file(path: Path) -> tuple[World | None, tuple[Diagnostic, ...]]:
    """The world of a file and what is wrong with it."""
    try:
        world, problems = read_world(read_bytes(path), path.name)
    except FileError as error:
        return None, (error.as_diagnostic(),)
    return world, tuple(problems)


def _files(folder: Path) -> Iterator[Path]:
    try:
        paths = sorted(path for path in folder.glob("*.xml") if path.is_file())
    except OSError:
        return
    for path in paths:
        try:
            with open_regular(path) as stream:
                beginning = stream.read(_BEGINNING)
        except OSError:
            continue
        if (
            path.name.lower().endswith(".world.xml")
            or first_element(beginning.decode("utf-8-sig", "replace")) == "world"
        ):
            yield path
