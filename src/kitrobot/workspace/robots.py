"""A robot by the word that people gave: the name of one that is at hand, or a `.robot.xml` file."""

from __future__ import annotations

from pathlib import Path

from kitrobot.diagnostics.model import Source
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.files.disk import read_bytes
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.text.sentences import Sentence


def find_robot(word: str, folder: Path | None = None) -> Robot:
    """The robot that `word` means; names are looked up among the shipped, the user's, and those of `folder`.

    Raises:
        KitRobotError: no robot has that name.
        FileError: the file cannot be read.
        ProblemsError: the file is no good robot.
    """
    if names_a_file(word):
        return read_robot_file(Path(word))
    return load_catalogue([folder] if folder else []).robot(word)


def names_a_file(word: str) -> bool:
    """Whether a word is the path of an XML file, and not a name."""
    return word.lower().endswith(".xml") or "/" in word or "\\" in word


def read_robot_file(path: Path) -> Robot:
    """The robot of a file.

    Raises:
        FileError: the file cannot be read.
        ProblemsError: the file is no good robot.
    """
    data = read_bytes(path)
    robot, diagnostics = read_robot(data, str(path))
    if robot is None:
        source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
        raise ProblemsError(
            Sentence("the robot of `{path}` cannot be used", path),
            Sentence("mend its file"),
            tuple(diagnostics),
            (source,),
        )
    return robot
