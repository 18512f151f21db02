"""A page that receives the status of real robots: messages are queued until it has taken the earlier ones.

It has a task of its own, which sends what changed since it last sent, at most every `FRAME_S`.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from collections import deque
from typing import TYPE_CHECKING, Protocol

from fastapi import WebSocketDisconnect
from pydantic import BaseModel

from kitrobot.wire.board import BoardsWelcomeMessage

if TYPE_CHECKING:
    from kitrobot.live.page_ports import PagePort

MOST_BOARDS = 32
MOST_TOLD = 1000
"""So many messages wait for a page that does not take them; the oldest go first."""
FRAME_S = 1 / 15
AT_PAGE = "page:"
"""The addresses of ports that pages have opened."""


class MessageSink(Protocol):
    """The receiver of a page's messages: a WebSocket, or its twin in a test."""

    async def send_text(self, data: str) -> None:
        """Sends a message; comes back when there is room for more."""


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

    def __init__(self, source: StatusSource, line: MessageSink, name: str) -> None:
        self.name = name
        self.shows_ports = False
        """Whether it shows the ports."""
        self._source = source
        self._line = line
        self._due = asyncio.Event()
        self._ports_due = False
        self._team_due = False
        self._boards_due: dict[str, None] = {}
        self.key = secrets.token_urlsafe(24)
        """The key by which the page shows that a port is its own; sent to this page only."""
        self.ports: dict[str, PagePort] = {}
        """Those that it has opened itself, by their addresses."""
        self._own: deque[BaseModel] = deque([BoardsWelcomeMessage(you=name, key=self.key)], MOST_TOLD)
        self._due.set()
        self._task = asyncio.create_task(self._serve())

    def queue_message(self, message: BaseModel) -> None:
        """Sends a message to this page alone."""
        self._own.append(message)
        self._due.set()

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
        self._ports_due = True
        self._due.set()

    def queue_team(self) -> None:
        """Something about the team changed."""
        self._team_due = True
        self._due.set()

    def queue_board(self, address: str) -> None:
        """Something about that robot changed."""
        self._boards_due[address] = None
        self._due.set()

    def is_sent_board(self, address: str, holder: str) -> bool:
        """Whether it receives the status of that robot, which page `holder` has or had."""
        return not address.startswith(AT_PAGE) or holder == self.name

    async def _serve(self) -> None:
        with contextlib.suppress(WebSocketDisconnect, RuntimeError, OSError):
            while True:
                await self._due.wait()
                self._due.clear()
                own = tuple(self._own)
                self._own.clear()
                ports, self._ports_due = self._ports_due, False
                boards, self._boards_due = self._boards_due, {}
                team, self._team_due = self._team_due, False
                for message in own:
                    await self._line.send_text(message.model_dump_json())
                if ports:
                    await self._line.send_text(self._source.encode_ports(self))
                for address in boards:
                    await self._line.send_text(self._source.encode_board(address))
                if team:
                    await self._line.send_text(self._source.team_text())
                await asyncio.sleep(FRAME_S)

    async def end(self) -> None:
        """Stops sending."""
        self._task.cancel()
        await asyncio.gather(self._task, return_exceptions=True)
