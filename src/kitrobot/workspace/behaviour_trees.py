"""Behaviour trees as files: read as a program's LLL, and written from it.

`read_behaviour_tree` and `save_behaviour_tree` are the functions of `import kitrobot`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from os import PathLike, fspath
from pathlib import Path

from kitrobot.behaviour_trees.lll_to_tree import lll_to_tree
from kitrobot.behaviour_trees.tree_to_lll import tree_to_lll
from kitrobot.behaviour_trees.tree_writer import write_tree
from kitrobot.behaviour_trees.tree_xml import read_trees
from kitrobot.compiler.compilation import compile_program, compile_text
from kitrobot.compiler.program.checker import check
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.files.disk import read_bytes, write_atomic
from kitrobot.graph.model import Program
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.robots import find_robot


@dataclass(frozen=True)
class ReadTree:
    """A tree that was read for a robot: its program as LLL (None when it has none), what was found, and the texts that
    this points into.
    """

    text: Source | None
    diagnostics: list[Diagnostic]
    sources: tuple[Source, ...]


def open_tree(path: Path, robot: Robot) -> ReadTree:
    """The program of a file of behaviour trees for a robot.

    Raises:
        FileError: the file cannot be read.
    """
    return read_tree(read_bytes(path), str(path), robot)


def read_tree(data: bytes, name: str, robot: Robot) -> ReadTree:
    """The program of the bytes of a file of that name for a robot."""
    sources = (Source(name, data.decode("utf-8-sig", errors="replace")),)
    file, found = read_trees(data, name)
    if file is None:
        return ReadTree(None, found, sources)
    program, refused = tree_to_lll(file, robot)
    if refused:
        return ReadTree(None, found + refused, sources)
    text = Source(f"{Path(name).stem}.lll", print_program(program))
    return ReadTree(text, found, (*sources, text))


def tree_problems(data: bytes, name: str, robot: Robot | None) -> tuple[list[Diagnostic], tuple[Source, ...]]:
    """Every problem of a file of behaviour trees (without a robot: of its form), and the texts that they point into."""
    if robot is None:
        return read_trees(data, name)[1], (Source(name, data.decode("utf-8-sig", errors="replace")),)
    read = read_tree(data, name, robot)
    if read.text is None:
        return read.diagnostics, read.sources
    return read.diagnostics + compile_text(read.text.text, robot, read.text.name).diagnostics, read.sources


def tree_file(program: Seq, robot: Robot, source: Source, name: str) -> tuple[bytes | None, list[Diagnostic]]:
    """The file of a program's tree, None when it has none, and why. `source`: the text of its places."""
    root, found = lll_to_tree(program, robot, source, name)
    return (None if found else write_tree(root, name, robot).encode()), found


def read_behaviour_tree(path: str | PathLike[str], robot: str | PathLike[str] | Robot, name: str = "") -> Program:
    """The graph of a behaviour tree of BehaviorTree.CPP 4, for a mission.

    Args:
        path: the tree's `.xml`.
        robot: a robot, the name of one that is at hand, or the path of a `.robot.xml`.
        name: what agents of the mission call it; empty: as the file is called.

    Raises:
        ProblemsError: the file has mistakes, or its tree means something else as a program; `diagnostics` says what.
        KitRobotError: the file cannot be read, or there is no such robot.
    """
    place, kind = Path(path), _robot(robot)
    read = open_tree(place, kind)
    name = name or place.stem
    failed = Sentence("the behaviour tree `{path}` has errors", place)
    if read.text is None:
        raise ProblemsError(failed, "", tuple(read.diagnostics), read.sources)
    parsed = parse(read.text.text, read.text.name)
    found = [*read.diagnostics, *parsed.diagnostics, *check(parsed.program, kind, parsed.source)]
    if any(item.is_error for item in found):
        raise ProblemsError(failed, "", tuple(found), read.sources)
    return lll_to_graph(parsed.program, kind, load_catalogue(), name)


def save_behaviour_tree(program: Program, path: str | PathLike[str], robot: str | PathLike[str] | Robot) -> None:
    """Writes a program as a behaviour tree of BehaviorTree.CPP 4; the same program gives the same bytes.

    Args:
        program: the graph of one robot's program.
        path: the `.xml`; a file that was there is replaced.
        robot: a robot, the name of one that is at hand, or the path of a `.robot.xml`.

    Raises:
        ProblemsError: the program has mistakes, or no tree means the same; `diagnostics` says what.
        KitRobotError: the file cannot be written, or there is no such robot.
    """
    kind = _robot(robot)
    catalogue = load_catalogue()
    catalogue.robots[kind.name] = kind
    compiled = compile_program(replace(program, target=kind.name), catalogue)
    data, refused = tree_file(compiled.program, kind, compiled.source, program.name) if compiled.ok else (None, [])
    if data is None:
        raise ProblemsError(
            Sentence("the program `{name}` has no behaviour tree", program.name),
            "",
            (*compiled.diagnostics, *refused),
            (compiled.source,),
        )
    write_atomic(Path(path), data)


def _robot(given: str | PathLike[str] | Robot) -> Robot:
    return given if isinstance(given, Robot) else find_robot(fspath(given))
