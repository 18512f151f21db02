"""When agents tick: three assumptions, of which every verdict names its own.

- *lockstep*: all tick at once, and between two ticks arms end and robots move, as in the simulator;
- *prompt*: every agent ticks at least once between two events of the world;
- *free*: an agent may lag behind the others for as long as it likes.

In each of them a robot that drives has a tick of its own in each zone and at each class of gap (see `bodies`).

A *step* is an edge of the graph that is explored: events, and the progress classes they belong to, as bits. The classes
of agent i of n are its ticks (bit i), that it begins to roll (n + i), the end of what takes it longer (2 n + i), and
that it comes into another zone (3 n + i). None of the first three is put off for ever; and a robot that rolls one way
again and again comes into another zone again and again.
"""

from __future__ import annotations

from enum import Enum


class Timing(Enum):
    """An assumption about when agents tick."""

    LOCKSTEP = "lockstep"
    PROMPT = "prompt"
    FREE = "free"
