"""A stretch of a run on the wire: as a preview, with what happens in it."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.sim.event_text import Event
from kitrobot.wire.gallery import RunPreviewShape, run_preview_shape
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.run import EventKind
from kitrobot.wire.sentences import Clause, Spoken
from kitrobot.wire.values import Row
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.previews import Preview

LONGEST = 3_000_000
"""A step that is asked for, at most."""


class RunStretchAskShape(BaseModel):
    """Record the run of a mission with that seed between two steps, `first` before `last`."""

    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    first: Annotated[int, Field(ge=0, lt=LONGEST)]
    last: Annotated[int, Field(ge=1, le=LONGEST)]


class StretchEventShape(Row):
    """What an agent does or what becomes of it in a stretch, and how many seconds after its beginning."""

    seconds: float
    kind: EventKind
    agent: str
    text: Clause


class RunStretchShape(BaseModel):
    """The run between two steps: `run` in frames that are `frame_s` apart, and what happens in it.

    `ending` says why the run ended in it; "" where it goes on behind it.
    """

    run: RunPreviewShape
    frame_s: float
    events: list[StretchEventShape]
    ending: Spoken


def run_stretch_shape(
    opened: OpenMission, preview: Preview, events: list[Event], first: int, frame_s: float, tick_s: float, ending: str
) -> RunStretchShape:
    """A stretch as it travels."""
    return RunStretchShape(
        run=run_preview_shape(opened, preview),
        frame_s=frame_s,
        events=[
            StretchEventShape.model_validate(
                {
                    "seconds": (event.tick - first) * tick_s,
                    "kind": event.kind,
                    "agent": event.agent,
                    "text": event.text,
                }
            )
            for event in events
        ],
        ending=ending,
    )
