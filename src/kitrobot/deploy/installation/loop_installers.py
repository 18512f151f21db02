"""Which way each board comes to the loop."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kitrobot.deploy.line.receiver import MICROBIT, Receiver
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP
from kitrobot.deploy.minification.tree_shaking import UsedParts
from kitrobot.deploy.package.board_package import BoardPackage, LoopInstaller
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.package import FAMILIES, Package

LOOP_INSTALLERS: tuple[tuple[str, LoopInstaller], ...] = (
    (MICROBIT, FLASH_LOOP),
    *((family, COMPILED_LOOP) for family in FAMILIES),
)
"""Families of boards with the installers of their boards: a micro:bit is that of 2016 or a V2."""


def loop_installer(board: Receiver) -> LoopInstaller:
    """The installer of the board that a receiver is in touch with."""
    return FLASH_LOOP if board.is_2016 else COMPILED_LOOP


def build_for_all_boards(package: Package, drivers: Mapping[str, UsedParts | None]) -> Iterator[BoardPackage]:
    """The packages for all kinds of boards that have these drivers."""
    for family, installer in LOOP_INSTALLERS:
        if not package.missing(drivers, family):
            yield package.build(family, drivers, installer)
