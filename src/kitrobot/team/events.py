"""Events that a host gives a member; what its robot's program requests of the team is a `Note`."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.team.commands import Note
from kitrobot.team.messages import Message


@dataclass(frozen=True, slots=True)
class Time:
    """Nothing but the time."""


@dataclass(frozen=True, slots=True)
class IncomingMessage:
    """A message came; `more`: others came with it and follow, so nothing is proposed before them."""

    message: Message
    more: bool = False


@dataclass(frozen=True, slots=True)
class Write:
    """The member's program writes a shared variable."""

    variable: int
    value: int


@dataclass(frozen=True, slots=True)
class Leave:
    """The member's program has ended; it wants to be in no later view."""


Event = Time | IncomingMessage | Note | Write | Leave
