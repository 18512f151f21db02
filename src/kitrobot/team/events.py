"""What a host tells a member; what its robot's program asks for is a command (`Announce`, `Take`, `Done`,
`Free`, or a `Note` of the host's own).
"""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.team.commands import Announce, Done, Free, Note, Take
from kitrobot.team.messages import Message


@dataclass(frozen=True, slots=True)
class Time:
    """Nothing but the time."""


@dataclass(frozen=True, slots=True)
class Received:
    """A message came; `more`: others came with it and are told next, so nothing is proposed before them."""

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


Event = Time | Received | Announce | Take | Done | Free | Note | Write | Leave
