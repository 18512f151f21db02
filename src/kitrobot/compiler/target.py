"""What a program is compiled for: the meaning of the names it calls.

The target of an agent's program is a kind of robot, by its name; that of a team's program is made for the team.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Source
from kitrobot.graph.model import Program
from kitrobot.lll.parse_results import parse, parse_team
from kitrobot.lll.printer import print_program, print_team_program
from kitrobot.lll.tree import Seq, TeamProgram
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence

Target: TypeAlias = Robot


def target_of(program: Program, catalogue: Catalogue) -> Target:
    """The target that a program names.

    Raises KitRobotError when the catalogue has no such robot.
    """
    return catalogue.teams[program.level] if program.level.is_team else catalogue.robot(program.target)


def robot_of(program: Program, catalogue: Catalogue) -> Robot:
    """The robot that runs a program.

    Raises KitRobotError when the catalogue has no such robot, or the program is a team's.
    """
    if program.level.is_team:
        raise KitRobotError(
            Sentence("`{program}` is the program of a team, and here one of a robot is needed", program.name),
            Sentence("choose the program of one robot"),
        )
    return catalogue.robot(program.target)


def program_for(target: Target, name: str) -> Program:
    """A program without vertices for a target."""
    return Program(name, target.name, level=target.level)


def words_for(target: Target) -> Sentence:
    """A target in a sentence: "… has no wheel"."""
    return Sentence("the team") if target.level.is_team else Sentence("the robot `{robot}`", target.name)


@dataclass(frozen=True)
class Read:
    """A text that was read for a target: its instructions, what it declares (of a team's program), its mistakes."""

    seq: Seq
    team: TeamProgram | None
    diagnostics: list[Diagnostic]
    source: Source

    @property
    def ok(self) -> bool:
        """Whether the text is free of errors."""
        return not any(item.is_error for item in self.diagnostics)


def read_for(text: str, target: Target, name: str) -> Read:
    """Reads a text as a program for a target; `name` is the file name that diagnostics show."""
    if target.level.is_team:
        team = parse_team(text, name)
        return Read(team.program.seq, team.program, team.diagnostics, team.source)
    parsed = parse(text, name)
    return Read(parsed.program, None, parsed.diagnostics, parsed.source)


def print_for(seq: Seq, target: Target, crew: Crew) -> str:
    """The text of a program for a target; that of a team's begins with what the team declares. Sets all places."""
    if not target.level.is_team:
        return print_program(seq)
    return print_team_program(TeamProgram([*crew.roles], [*crew.groups], [*crew.works], seq))
