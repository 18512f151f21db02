"""The programs of a team's agents for real robots."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from kitrobot.boards.programs import ready_program
from kitrobot.boards.sent_programs import store_sent_program
from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.target import robot_of
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.team_objects import with_team
from kitrobot.robots import board_operations
from kitrobot.robots.board_operations import Progress, SendResult
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.recording_context import recording_context_of
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.traces import parts_of


class BoardsError(KitRobotError):
    """It cannot be so said which agent has which board."""


def agent_program(opened: OpenMission, name: str, folder: Path | None = None, kit: Kit | None = None) -> BoardProgram:
    """What an agent of a mission runs, made ready for a board that is a member of its team.

    Args:
        opened: the mission.
        name: of the agent.
        folder: where drivers of the user's own may lie; None: beside the mission.
        kit: what its robot is built of; None: as the robot's XML says.

    Raises:
        BoardsError: the mission has no such agent.
        ProblemsError: its program has errors, with all that is to be said of it.
        KitRobotError: a driver is missing, or the program fits no board.
    """
    names = [agent.name for agent in opened.mission.team.agents]
    if name not in names:
        raise no_agent(name, names)
    agent = opened.mission.team.agents[names.index(name)]
    program = opened.program(agent.program)
    found = opened.report.problems
    if not opened.report.ok:
        raise ProblemsError(
            Sentence("`{mission}` has errors, so it was not run", opened.name), "", found, opened.all_sources
        )
    compiled: CompiledProgram | None
    if agent.program == opened.mission.social:
        robot: Robot = with_team(opened.catalogue.robots[agent.robot], opened.mission.team.works)
        compiled = opened.team.kinds.get(agent.robot) if opened.team is not None else None
    else:
        robot = robot_of(program, opened.catalogue)
        compiled = opened.compiled.get(program.name)
    beside = folder or (opened.path.parent if opened.path is not None else None)
    ready = ready_program(program.name, robot, compiled, found, opened.all_sources, beside, member=True, kit=kit)
    if opened.world is None or compiled is None:
        return ready
    return replace(
        ready, recording_context=recording_context_of(opened.mission, opened.world, parts_of(opened), robot, compiled)
    )


def send_team(
    opened: OpenMission,
    boards: Mapping[str, str],
    progress: Progress = lambda address, stage, done, total: None,
    *,
    replace: bool = False,
    fresh: bool = False,
    kit: Kit | None = None,
) -> list[SendResult]:
    """Puts the programs of agents onto their boards, which then wait for `kitrobot team`; none of them is started.

    Args:
        opened: the mission.
        boards: the ports, by agents.
        progress: is told how far it is.
        replace: as of `deploy.deploy`.
        fresh: as of `deploy.deploy`.
        kit: what all their robots are built of; None: as the robots' XML says.

    Raises:
        KitRobotError: what can be said before anything is sent.
    """
    programs = {port: agent_program(opened, name, kit=kit) for name, port in boards.items()}
    sent = board_operations.send_programs(programs, progress, replace=replace, fresh=fresh)
    for one in sent:
        if one.deployed is not None:
            store_sent_program(programs[one.address], [one.deployed.program])
    return sent


def no_agent(name: str, names: list[str]) -> BoardsError:
    """The error of an agent that a mission has not."""
    return BoardsError(
        Sentence("this mission has no agent `{agent}`", name),
        did_you_mean(name, names) or Sentence("its agents: {names}", listed(names)),
    )


def boards_of(given: list[str], names: list[str]) -> Mapping[str, str]:
    """The ports of agents, by name, as they are given: `AGENT=PORT`.

    Raises:
        BoardsError: something else is given, there is no such agent, or an agent or a port is given twice.
    """
    pairs = []
    for text in given:
        name, equal, port = (part.strip() for part in text.partition("="))
        if not (name and equal and port):
            raise BoardsError(
                Sentence("`{text}` does not say which agent has which board", text),
                Sentence("write it as AGENT=PORT, such as {example}", f"{names[0]}=/dev/ttyACM0"),
            )
        pairs.append((name, port))
    return check_boards(pairs, names)


def check_boards(pairs: Iterable[tuple[str, str]], names: list[str]) -> Mapping[str, str]:
    """The ports of agents, by name, of pairs of both.

    Raises:
        BoardsError: there is no such agent, or an agent or a port is given twice.
    """
    found: dict[str, str] = {}
    for name, port in pairs:
        if name not in names:
            raise no_agent(name, names)
        if name in found:
            raise BoardsError(
                Sentence("two boards are given to `{agent}`", name), Sentence("an agent has one board; take one away")
            )
        if port in found.values():
            other = next(one for one, taken in found.items() if taken == port)
            raise BoardsError(
                Sentence("`{agent}` and `{other}` are both given the board on `{port}`", other, name, port),
                Sentence("each agent needs a board of its own; `kitrobot boards` lists those that are there"),
            )
        found[name] = port
    return found
