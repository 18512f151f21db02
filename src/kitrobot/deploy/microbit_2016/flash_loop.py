"""The loop on a micro:bit of 2016: compiled by the board once, and executed from its flash from then on."""

from __future__ import annotations

import ast
import copy
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.microbit_2016.flash_code import FlashBlock, WithNames, build_block, literals_of, sign_of
from kitrobot.deploy.microbit_2016.flash_install import freeze
from kitrobot.deploy.microbit_2016.flash_memory import OWN_BYTES, program_bytes
from kitrobot.deploy.microbit_2016.flash_room import refuse_what_has_no_room
from kitrobot.deploy.microbit_2016.flash_start import start_from_flash
from kitrobot.deploy.minification.minifier import shortened
from kitrobot.deploy.package.board_package import BoardPackage, LoopFiles
from kitrobot.deploy.package.onboard_bundle import (
    LITERAL_NAMES,
    join_statements,
    linked_trees,
    module_names,
    short_text,
)
from kitrobot.deploy.package.program_file import ProgramFile

IN_FLASH = (
    ("interpreter",),
    ("reaction", "robot"),
    ("ports/microbit", "link", "dispatch", "receive", "actuation", "request_checks", "device_setup"),
    ("reports",),
)
"""The modules of the loop that the board compiles together."""


@cache
def loop_block() -> FlashBlock:
    """The interpreter, the port and the loop."""
    groups = []
    for names in IN_FLASH:
        body: list[ast.stmt] = [
            one for tree in linked_trees(names) for one in tree.body if isinstance(one, ast.FunctionDef)
        ]
        text = shortened(ast.Module(copy.deepcopy(body), []))
        groups.append([one for one in ast.parse(text).body if isinstance(one, ast.FunctionDef)])
    found = literals_of([function for group in groups for function in group])
    names_of = dict(zip(found, (module_names()[name] for name in LITERAL_NAMES), strict=False))
    for group in groups:
        for function in group:
            WithNames(names_of).visit(function)
    return build_block(groups, {name: value for value, name in names_of.items()})


def statements_beside() -> Sequence[str]:
    """The statements beside functions of the modules that run from flash, and the literals of these functions."""
    names = [name for group in IN_FLASH for name in group]
    # What is imported whole, `begin` imports too.
    rest = [
        one for tree in linked_trees(names) for one in tree.body if not isinstance(one, ast.FunctionDef | ast.Import)
    ]
    texts = [short_text(ast.unparse(one)) for one in rest]
    return join_statements([*texts, *(f"{name}={value}" for name, value in loop_block().literals.items())])


@dataclass(frozen=True)
class FlashLoop:
    """The `LoopInstaller` of this board: a block of its flash holds the loop, and no file does."""

    def build_files(self, family: str, requests: str, store: Callable[[bytes], str]) -> LoopFiles:
        block = loop_block()
        return LoopFiles(block.name, (), start_from_flash(block, statements_beside(), requests))

    def memory_bytes(self, program: ProgramFile, built: BoardPackage, file_bytes: int) -> tuple[int, int]:
        return program_bytes(program, built, file_bytes), OWN_BYTES

    def refuse_without_room(
        self, board: Receiver, wanted: Mapping[str, int], staying: Collection[str], modules: Collection[str]
    ) -> None:
        refuse_what_has_no_room(board, loop_block(), wanted, staying, map(sign_of, modules))

    def install(self, board: Receiver, modules: Collection[str], *, fresh: bool) -> Mapping[str, int]:
        block = loop_block()
        sent = freeze(board, block, set(map(sign_of, modules)), fresh=fresh)
        return {block.name: sent} if sent else {}


FLASH_LOOP = FlashLoop()
