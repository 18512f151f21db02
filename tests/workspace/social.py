"""Missions whose agents run a program of the whole team, from its text."""

from __future__ import annotations

from pathlib import Path

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.lll.parse_results import parse_team
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.crew import Crew, CrewProgram
from kitrobot.primitives.levels import Level
from kitrobot.workspace.mission_loader import OpenMission, open_mission

WORLD = """<world version="1" name="room" width="3000" height="3000">
  <help>A room.</help>
  {starts}
</world>
"""


def social_mission(text: str, agents: dict[str, str]) -> Mission:
    """A mission in which agents, each of its kind of robot, run the program of this text."""
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    team = parsed.program
    declared = (tuple(team.roles), tuple(team.groups), tuple(team.works))
    crew = Crew(tuple(agents.items()), (CrewProgram("team", "", Level.SOCIAL),), *declared)
    parts = load_catalogue().extended([], [], crew)
    program = lll_to_graph(team.seq, parts.teams[Level.SOCIAL], parts, "team")
    members = [Agent(name, "team", "", robot) for name, robot in agents.items()]
    return Mission(
        programs=[program],
        team=Team(members, [], team.roles, team.groups, team.works),
        world_href="room.world.xml",
    )


def opened(mission: Mission, folder: Path) -> OpenMission:
    """The mission as a file, opened, in a room with a start for each of its agents."""
    starts = [
        f'<start name="{one.name}" x="400" y="{300 + 300 * n}" heading="0"/>'
        for n, one in enumerate(mission.team.agents)
    ]
    (folder / "room.world.xml").write_text(WORLD.format(starts="\n  ".join(starts)), encoding="utf-8")
    (folder / "team.krt").write_bytes(write_mission(mission))
    return open_mission(folder / "team.krt")
