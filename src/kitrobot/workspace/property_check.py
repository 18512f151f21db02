"""Whether the properties that a mission or an exercise asks for can be understood, and speak of what is there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kitrobot.diagnostics.model import Diagnostic, Place
from kitrobot.exercise.goals import CheckGoal
from kitrobot.exercise.model import Exercise
from kitrobot.exercise.rules import GOAL
from kitrobot.files.places import Places
from kitrobot.mission.model import Mission, Team
from kitrobot.mission.property_forms import is_ready
from kitrobot.mission.rules import PROPERTY
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.team_objects import has_team, with_team
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.verifier.properties.conditions import Member


def property_problems(mission: Mission, catalogue: Catalogue, places: Places | None) -> Iterator[Diagnostic]:
    """What is wrong with the properties of a mission; nothing is said of robots that are not at hand."""
    named = _named_in(mission, catalogue) if mission.properties else None
    if named is None:
        return
    # Reading missions has no need of it.
    from kitrobot.verifier.properties.conditions import PropertyError, parse_condition

    def place(name: str, attribute: str) -> Place | None:
        return places.asked(name, attribute) if places is not None else None

    seen: set[str] = set()
    for one in mission.properties:
        if is_ready(one.name):
            message = Sentence("`{name}` is the name of a property that is checked unasked", one.name)
            yield PROPERTY(message, place(one.name, "name"), help=Sentence("choose another name"))
        elif one.name in seen:
            message = Sentence("two properties are called `{name}`", one.name)
            yield PROPERTY(message, place(one.name, "name"), help=Sentence("choose another name"))
        seen.add(one.name)
        for attribute, text in one.conditions:
            try:
                parse_condition(text, *named)
            except PropertyError as error:
                message = Sentence("the property {name}: {reason}", one.name, error.message)
                yield PROPERTY(message, place(one.name, attribute), help=error.help)


def goal_problems(exercise: Exercise, mission: Mission, catalogue: Catalogue) -> Iterator[Diagnostic]:
    """What is wrong with the properties of an exercise that begins with that mission."""
    named = _named_in(mission, catalogue)
    if named is None:
        return
    from kitrobot.verifier.properties.conditions import PropertyError
    from kitrobot.verifier.properties.custom_properties import parse_conditions

    for goal in exercise.goals:
        if isinstance(goal, CheckGoal) and goal.asked is not None:
            try:
                parse_conditions(goal.asked, *named)
            except PropertyError as error:
                yield GOAL(error.message, goal.place, help=error.help)


def _named_in(mission: Mission, catalogue: Catalogue) -> tuple[list[Member], Team | None] | None:
    """The agents that conditions name, and the team with their roles and groups; None where a robot is not at hand."""
    from kitrobot.verifier.properties.conditions import Member

    kinds = {program.name: program.target for program in mission.programs}
    declared = mission.team if any(agent.robot for agent in mission.team.agents) else None

    def whole(robot: Robot) -> Robot:
        """The robot with what a member of the team has besides."""
        works = mission.team.works
        return robot if declared is None or has_team(robot, works) else with_team(robot, works)

    team = [
        Member(agent.name, agent.program, whole(robot) if agent.robot else robot)
        for agent in mission.team.agents
        if (robot := catalogue.robots.get(agent.robot or kinds.get(agent.program, ""))) is not None
    ]
    return (team, declared) if len(team) == len(mission.team.agents) else None
