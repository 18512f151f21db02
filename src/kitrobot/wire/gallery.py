"""The gallery of examples, on the wire."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.wire.mission import ProgramValue
from kitrobot.wire.values import Row, View
from kitrobot.wire.world import WorldShape, world_shape
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.previews import Preview


class TopicShape(BaseModel):
    """What an example is about."""

    name: str
    label: dict[str, str]


class ExampleShape(BaseModel):
    """What is told of an example: its level from 1, 0 where nobody said one; the kinds of its robots; how many there
    are, and how many parts its first program has.
    """

    level: int
    topics: list[TopicShape]
    robots: list[str]
    agents: int
    parts: int


class PreviewAgentShape(BaseModel):
    """An agent of a preview; `start` is the place in the world where it begins, "" where that has its own name."""

    name: str
    program: str
    robot: str
    number: int
    start: str


class PreviewShownShape(Row):
    """From that frame on an agent's actuator shows these numbers."""

    frame: int
    agent: int
    part: str
    numbers: list[int]


class PreviewStockShape(Row):
    """From that frame on so many boxes lie in a storehouse."""

    frame: int
    storehouse: str
    boxes: int


class RunPreviewShape(View):
    """The first seconds of a run in `frames` pictures; none where it cannot run, and then its program is what there is.

    `ways`: of each agent five numbers a frame (x and y in mm, the heading in thousandths of a radian, load, flags); of
    one that never changes only five. `things`: of each thing that can be pushed x and y, likewise. `marks`: points of
    lines of pens, each (frame, pen, what, x, y, colour, width), and `pens` who has them.
    """

    program: ProgramValue | None
    world: WorldShape | None
    seconds: float
    frames: int
    agents: list[PreviewAgentShape]
    ways: list[list[int]]
    shown: list[PreviewShownShape]
    stock: list[PreviewStockShape]
    things: list[list[int]]
    pens: list[int]
    marks: list[list[int]]


def run_preview_shape(opened: OpenMission, preview: Preview | None) -> RunPreviewShape:
    """A mission's preview as it travels."""
    programs = opened.mission.programs
    starts = {agent.name: agent.start for agent in opened.mission.team.agents}
    made = preview or Preview([], 0.0, 0, [], [], [], [], [], [])
    return RunPreviewShape(
        program=programs[0] if programs else None,
        world=world_shape(opened.world) if opened.world is not None else None,
        seconds=made.seconds,
        frames=made.frames,
        agents=[
            PreviewAgentShape(name=name, program=program, robot=robot, number=number, start=starts.get(name, ""))
            for name, program, robot, number in made.agents
        ],
        ways=made.ways,
        shown=[
            PreviewShownShape(frame=frame, agent=agent, part=part, numbers=numbers)
            for frame, agent, part, numbers in made.shown
        ],
        stock=[PreviewStockShape(frame=frame, storehouse=name, boxes=boxes) for frame, name, boxes in made.stock],
        things=made.things,
        pens=made.pens,
        marks=made.marks,
    )
