"""The loop on a board that compiles it from files: any MicroPython with memory for that."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass

from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.package.board_package import BoardPackage, LoopFiles
from kitrobot.deploy.package.memory import image_bytes, package_bytes
from kitrobot.deploy.package.onboard_bundle import ONBOARD, loop_files, minified_module
from kitrobot.deploy.package.program_file import ProgramFile
from kitrobot.deploy.package.start_script import start_file


@dataclass(frozen=True)
class CompiledLoop:
    """The `LoopInstaller` of these boards: everything is a file."""

    def build_files(self, family: str, requests: str, store: Callable[[bytes], str]) -> LoopFiles:
        interpreter = store(minified_module(ONBOARD / "interpreter.py"))[: -len(".py")]
        contents = [minified_module(path) for path in (ONBOARD / "ports" / f"{family}.py", *loop_files())]
        names = [store(content) for content in contents]
        sizes = [len(content) for content in contents]
        return LoopFiles(interpreter, names, start_file(interpreter, list(zip(names, sizes, strict=True)), requests))

    def memory_bytes(self, program: ProgramFile, built: BoardPackage, file_bytes: int) -> tuple[int, int]:
        return image_bytes(program.image), package_bytes(built)

    def refuse_without_room(
        self, board: Receiver, wanted: Mapping[str, int], staying: Collection[str], modules: Collection[str]
    ) -> None:
        """Refuses nothing: such a board has room for many packages, and says itself when it has none."""

    def install(self, board: Receiver, modules: Collection[str], *, fresh: bool) -> Mapping[str, int]:
        return {}


COMPILED_LOOP = CompiledLoop()
