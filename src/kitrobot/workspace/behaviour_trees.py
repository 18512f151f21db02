"""Behaviour trees as files: read as a program's LLL, and written from it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kitrobot.behaviour_trees.lll_to_tree import lll_to_tree
from kitrobot.behaviour_trees.tree_to_lll import tree_to_lll
from kitrobot.behaviour_trees.tree_writer import write_tree
from kitrobot.behaviour_trees.tree_xml import read_trees
from kitrobot.compiler.compilation import compile_text
from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.files.disk import read_bytes
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq
from kitrobot.primitives.robot import Robot


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
