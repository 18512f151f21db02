"""Events of a recording that break ready properties; a recording keeps them as English sentences."""

from __future__ import annotations

import re
from collections.abc import Iterable

from kitrobot.sim.tables import columns as c
from kitrobot.trace.model import TraceEvent

_EVENTS: dict[int, tuple[str, re.Pattern[str]]] = {
    c.COLLISION: ("collision", re.compile(r"touches (?!a wall$).*", re.DOTALL)),
    c.NO_BOX: ("message", re.compile(r"storehouse .* has no box", re.DOTALL)),
    c.NO_EMPTY_CARRIER: ("message", re.compile(r"no empty carrier stands in dock .*", re.DOTALL)),
    c.NO_LOADED_CARRIER: ("message", re.compile(r"no loaded carrier stands in dock .*", re.DOTALL)),
}
"""The kind and text of the simulator's events (`sim.event_text`)."""


def breaks_ready_property(event: TraceEvent, seen_as: Iterable[int]) -> bool:
    """Whether a recorded event is one of these events of the simulator."""
    return any(
        event.kind == kind and pattern.fullmatch(event.text) for kind, pattern in map(_EVENTS.__getitem__, seen_as)
    )
