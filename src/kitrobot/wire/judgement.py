"""What a judge says of a property, on the wire."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel

from kitrobot.judges.judgement import Judgement
from kitrobot.wire.sentences import Spoken


class JudgementShape(BaseModel):
    """What is said of a property of the mission: `name` is its own, `sentence` what it demands, `reason` the ground.

    `tick`: the tick in which it broke; null where there is no such moment.
    """

    name: str
    sentence: Spoken
    ruling: Literal["kept", "broken", "not decided"]
    reason: Spoken
    tick: int | None


def judgement_shape(said: Judgement) -> JudgementShape:
    """A judgement for the page."""
    return JudgementShape(
        name=said.question,
        sentence=said.words,
        ruling=said.ruling.value,
        reason=said.reason,
        tick=said.tick if said.tick >= 0 else None,
    )
