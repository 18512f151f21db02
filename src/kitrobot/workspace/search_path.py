"""The folders that are searched for the parts of a mission: robots, constructors, and the file of its world."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.world.lookup import SHIPPED, find_world


@dataclass(frozen=True)
class SearchPath:
    """The folders of a mission, and what was read from them already.

    Attributes:
        folder: the mission's own; robots and constructors are read from it.
        before: folders in which the world is looked for first, the first one first.
        within: a link to a world's file must stay in this folder or one of the others; None: it may lead anywhere.
        known: the robots and constructors, where they were read before.
    """

    folder: Path
    before: tuple[Path, ...] = ()
    within: Path | None = None
    known: Catalogue | None = None

    def catalogue(self) -> Catalogue:
        """The robots and constructors at hand, without those that a mission brings along."""
        return self.known if self.known is not None else load_catalogue([self.folder])

    def world_file(self, href: str) -> Path | None:
        """The file of a mission's world, in one of the folders or shipped; None when there is none."""
        path = find_world(href, [*self.before, self.folder])
        if path is None or self.within is None:
            return path
        real = path.resolve()
        inside = (*self.before, self.folder, self.within, SHIPPED)
        return path if any(folder.resolve() in real.parents for folder in inside) else None
