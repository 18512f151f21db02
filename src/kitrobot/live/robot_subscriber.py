"""A page that receives the status of real robots: messages are queued until it has taken the earlier ones.

Its feed sends what changed since it last sent, at most every `FRAME_S`.
"""

from __future__ import annotations

import secrets
from collections import deque
from typing import TYPE_CHECKING, Protocol

from pydantic import BaseModel

from kitrobot.live.feed import Channel, Feed
from kitrobot.wire.board import BoardsWelcomeMessage

if TYPE_CHECKING:
    from kitrobot.live.page_ports import PagePort

MOST_BOARDS = 32
MOST_TOLD = 1000
"""So many messages wait for a page that does not take them; the oldest go first."""
FRAME_S = 1 / 15
AT_PAGE = "page:"
"""The addresses of ports that pages have opened."""


class StatusSource(Protocol):
    """What is known of the robots, as the texts of messages."""

    def encode_ports(self, subscriber: RobotSubscriber) -> str:
        """The ports that a page may use."""

    def encode_board(self, address: str) -> str:
        """The status of one robot."""

    def team_text(self) -> str:
        """The status of the team."""


class RobotSubscriber:
    """A page that receives the robots' status. Messages are queued until it has taken the earlier ones."""

    def __init__(self, source: StatusSource, channel: Channel, name: str) -> None:
        self.name = name
        self.shows_ports = False
        """Whether it shows the ports."""
        self._source = source
        self.key = secrets.token_urlsafe(24)
        """The key by which the page shows that a port is its own; sent to this page only."""
        self.ports: dict[str, PagePort] = {}
        """Those that it has opened itself, by their addresses."""
        self._own: deque[BaseModel] = deque(maxlen=MOST_TOLD)
        self._feed = Feed(channel, FRAME_S)
        self.queue_message(BoardsWelcomeMessage(you=name, key=self.key))

    def queue_message(self, message: BaseModel) -> None:
        """Sends a message to this page alone."""
        self._own.append(message)
        self._feed.put((0, "own"), self._take_own)

    def _take_own(self) -> list[str]:
        own = [message.model_dump_json() for message in self._own]
        self._own.clear()
        return own

    @property
    def has_room(self) -> bool:
        """Whether it may have one port more."""
        return len(self.ports) < MOST_BOARDS

    def hold(self, port: PagePort) -> None:
        """It has opened a port."""
        self.ports[port.port.address] = port
        self.queue_ports()

    def drop(self, port: PagePort) -> None:
        """It has that port no more."""
        self.ports.pop(port.port.address, None)
        self.queue_ports()

    def queue_ports(self) -> None:
        """The ports are others now."""
        self._feed.put((1, "ports"), lambda: [self._source.encode_ports(self)])

    def queue_team(self) -> None:
        """Something about the team changed."""
        self._feed.put((3, "team"), lambda: [self._source.team_text()])

    def queue_board(self, address: str) -> None:
        """Something about that robot changed."""
        self._feed.put((2, address), lambda: [self._source.encode_board(address)])

    def is_sent_board(self, address: str, holder: str) -> bool:
        """Whether it receives the status of that robot, which page `holder` has or had."""
        return not address.startswith(AT_PAGE) or holder == self.name

    async def end(self) -> None:
        """Stops sending."""
        await self._feed.close()
