"""When agents tick: three assumptions. Every verdict names the one that it was found under.

- *lockstep*: all tick at once, and between two ticks arms complete and robots move, as in the simulator;
- *prompt*: every agent ticks at least once between two events of the world;
- *free*: an agent may lag behind the others for as long as it likes.

In each of them a robot that drives has a tick of its own in each zone and at each class of gap (see `bodies`).

A *step* is an edge of the explored graph: events, and the progress classes that they belong to, as bits. The classes of
agent i of n are its ticks (bit i), the start of its roll (n + i), the completion of its longer actions (2 n + i), and
its entry into another zone (3 n + i). None of the first three is delayed for ever; and a robot that rolls one way again
and again enters another zone again and again.
"""

from __future__ import annotations

from enum import Enum


class Timing(Enum):
    """An assumption about when agents tick."""

    LOCKSTEP = "lockstep"
    PROMPT = "prompt"
    FREE = "free"
