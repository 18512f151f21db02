"""Work that takes long, on the wire: what all kinds of it have in common."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict

from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.sentences import Spoken


class WorkMessage(BaseModel):
    """What a page is told."""

    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


class WorkRefusedMessage(WorkMessage):
    """Why nothing came of it; `problems` are the errors of the mission, where it has some."""

    type: Literal["refused"] = "refused"
    message: Spoken
    help: Spoken
    problems: list[ProblemShape]
