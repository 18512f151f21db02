"""Parts that are tried by hand on the wire: the steps, what one measures now, what failed."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.primitives.meaning import Meaning
from kitrobot.primitives.robot import ValueType
from kitrobot.wire.sentences import Spoken
from kitrobot.wire.values import View


class BoardBenchFailureShape(BaseModel):
    """The part of a step is broken, and why."""

    step: int
    message: Spoken
    help: Spoken


class BoardBenchShape(BaseModel):
    """Parts that are tried: the `step` that is done now, None for none; `value` of its sensor, None before;
    whether its driver is `slow` and takes longer than a tick.
    """

    step: int | None
    value: int | None
    slow: bool
    failed: list[BoardBenchFailureShape]


class ReadingShape(View):
    """What the value of a part means."""

    type: ValueType
    unit: str
    meaning: Meaning | None


class BenchStepShape(BaseModel):
    """One thing to try, in texts by language: what is to be seen, and what to look for when it does not happen.
    `call` is what the part is told, "" for a sensor, whose value is looked at and means what `reads` says.
    """

    part: str
    label: dict[str, str]
    call: str
    reads: ReadingShape
    seen: dict[str, str]
    trouble: dict[str, str]


class BenchLeftOutShape(BaseModel):
    """A part that the kit lacks or that cannot work there."""

    part: str
    label: dict[str, str]
    why: Spoken
