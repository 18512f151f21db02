"""All real robots of one studio: their holders, the ports, and notifying pages.

A robot belongs to the page that connected it (its *holder*), for a serial port has room for one; every page is sent
the status of all of them and may stop any. When a page closes, its robots are released: those that are held stop.

A robot's message is encoded once for all pages of a language. A port that a page has opened itself (`page_ports`), and
the robot on it, are sent to that page only. Only the server's event loop touches anything here; robots' threads call it
through `call_soon_threadsafe`. Ports are scanned only while some page shows them.

Not here: a page and its queue of messages (`robot_subscriber`).
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import itertools
import logging
from collections.abc import Iterable
from typing import TYPE_CHECKING

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import run_in_background
from kitrobot.live.robot_gateway import RobotGateway
from kitrobot.live.robot_subscriber import AT_PAGE, MOST_BOARDS, RobotSubscriber
from kitrobot.live.team_controller import TeamController
from kitrobot.text.sentences import Sentence
from kitrobot.translation.reader_language import reader_language
from kitrobot.wire.board import BoardGoneMessage, BoardPortShape, BoardPortsMessage

if TYPE_CHECKING:
    from kitrobot.deploy.firmware.ports import Port
    from kitrobot.live.feed import Channel
    from kitrobot.live.last_run_recorder import LastRunRecorder
    from kitrobot.live.robot_worker import RobotWorker

LOOK_S = 1.0
"""How often ports are scanned while a page shows them."""
CLOSE_WITHIN_S = 3.0
"""How long a page that goes away waits for its robots to stop."""
NETWORK = ("socket://", "rfc2217://")
"""The only URLs that are opened: others of pySerial's open files."""

_log = logging.getLogger("kitrobot.server")


class AddressError(KitRobotError):
    """There is no robot at such an address, or it may not be opened."""


class HeldError(KitRobotError):
    """Another page holds the robot."""


class RobotRegistry:
    """The robots of one studio."""

    def __init__(self, links: RobotGateway) -> None:
        self.links = links
        self.in_page = False
        """Whether the only ports are those that the page opens, without a network (`in_page_server`)."""
        self.team = TeamController(self)
        self._sessions: dict[str, RobotWorker] = {}
        self._subscribers: list[RobotSubscriber] = []
        self._names = itertools.count(1)
        self._ports: list[Port] = []
        self._port_scan: asyncio.Task[None] | None = None
        self._leaving: set[asyncio.Task[None]] = set()
        self._texts: dict[tuple[str, str], tuple[int, str]] = {}

    # -- pages

    def subscribe(self, channel: Channel) -> RobotSubscriber:
        """Adds a page, and sends it all robots."""
        subscriber = RobotSubscriber(self, channel, f"page-{next(self._names)}")
        self._subscribers.append(subscriber)
        for address, session in self._sessions.items():
            if subscriber.is_sent_board(address, session.holder):
                subscriber.queue_board(address)
        if self.team.status.agents:
            subscriber.queue_team()
        return subscriber

    def page_by_key(self, key: str) -> RobotSubscriber | None:
        """The page that has that key."""
        right = [one for one in self._subscribers if hmac.compare_digest(one.key.encode(), key.encode())]
        return right[0] if right else None

    async def unsubscribe(self, subscriber: RobotSubscriber) -> None:
        """Removes a page and releases its robots, also when the caller is cancelled."""
        self._subscribers.remove(subscriber)
        self.show_ports(subscriber, False)
        mine = [session for session in self._sessions.values() if session.holder == subscriber.name]
        for session in mine:
            session.close()
        task = asyncio.create_task(self._end(subscriber, mine))
        self._leaving.add(task)
        task.add_done_callback(self._leaving.discard)
        await asyncio.shield(task)

    async def _end(self, subscriber: RobotSubscriber, sessions: list[RobotWorker]) -> None:
        await subscriber.end()
        for session in sessions:
            await run_in_background(session.wait, CLOSE_WITHIN_S)
            self._remove_session(session)
        # Not before the robots were ordered to stop.
        for port in [*subscriber.ports.values()]:
            port.disconnect()

    # -- ports

    def show_ports(self, subscriber: RobotSubscriber, on: bool) -> None:
        """The page shows the ports from now on, or not any more."""
        subscriber.shows_ports = on
        if any(one.shows_ports for one in self._subscribers):
            if on:
                subscriber.queue_ports()
            if self._port_scan is None and not self.in_page:
                self._port_scan = asyncio.create_task(self._scan_ports())
        elif self._port_scan is not None:
            self._port_scan.cancel()
            self._port_scan = None

    async def _scan_ports(self) -> None:
        while True:
            await self._find_ports()
            await asyncio.sleep(LOOK_S)

    async def _find_ports(self) -> None:
        try:
            found = await run_in_background(self.links.list_ports)
        except (KitRobotError, OSError) as error:
            _log.debug("the ports cannot be listed: %s", error)
            found = []
        if found != self._ports:
            self._ports = found
            for subscriber in self._subscribers:
                if subscriber.shows_ports:
                    subscriber.queue_ports()

    def encode_ports(self, page: RobotSubscriber) -> str:
        """All ports that a page may use, encoded."""
        ports = [
            BoardPortShape(
                address=one.address,
                name=_display_name(one.address, one.name),
                description=one.description,
                firmware=one.firmware,
            )
            for one in (*(port.port for port in page.ports.values()), *self._ports)
        ]
        return BoardPortsMessage(ports=ports).model_dump_json()

    # -- robots

    async def session(self, holder: str, address: str) -> RobotWorker:
        """The session of that page on the robot at an address, opened now if nobody has it.

        Raises:
            KitRobotError: there is no such port, another page has it, or there are too many.
        """
        name = await self._name_of(address, holder)
        while (found := self._sessions.get(address)) is not None and found.closing:
            # Its page is gone; a page that was loaded again asks before the session has ended.
            await run_in_background(found.wait, CLOSE_WITHIN_S)
            self._remove_session(found)
        if found is not None:
            return _require_holder(holder, found)
        if address in self.team.addresses:
            raise HeldError(Sentence("the team has `{robot}`", name), Sentence("stop the team first"))
        if len(self._sessions) >= MOST_BOARDS:
            raise BoardsError(
                Sentence("this studio talks with {most} robots already", MOST_BOARDS),
                Sentence("disconnect one of them first"),
            )
        from kitrobot.live.robot_worker import RobotWorker

        loop = asyncio.get_running_loop()

        def changed() -> None:
            with contextlib.suppress(RuntimeError):  # the studio has ended meanwhile
                loop.call_soon_threadsafe(self._changed, address, holder)

        session = self._sessions[address] = RobotWorker(address, name, holder, self.links, changed)
        self._changed(address, holder)
        return session

    async def _name_of(self, address: str, holder: str) -> str:
        if address.startswith(AT_PAGE):
            mine = next((one.ports for one in self._subscribers if one.name == holder), {})
            if address not in mine:
                raise AddressError(Sentence("this page has no such board"), Sentence("choose the board again"))
            return mine[address].port.name
        if self.in_page:
            raise AddressError(
                Sentence("a page reaches only boards that were chosen in it"),
                Sentence("press Find a board, or install KitRobot on this computer"),
            )
        if address.lower().startswith(NETWORK):
            return _display_name(address, "")
        known = {one.address: one.name for one in self._ports}
        if address not in known:
            await self._find_ports()
            known = {one.address: one.name for one in self._ports}
        if address not in known:
            raise AddressError(
                Sentence("there is no robot at `{address}`", address),
                Sentence("choose one of the list, or write `socket://host:port`"),
            )
        return _display_name(address, known[address])

    def held_session(self, holder: str, address: str) -> RobotWorker:
        """The session of a robot that this page holds.

        Raises:
            KitRobotError: it has none.
        """
        found = self._sessions.get(address)
        if found is None:
            raise AddressError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        return _require_holder(holder, found)

    def named_sessions(self, holder: str, addresses: Iterable[str]) -> dict[str, RobotWorker]:
        """Sessions that this page holds, by names that are made unique.

        Raises:
            KitRobotError: it has none on one of them.
        """
        sessions = [self.held_session(holder, address) for address in dict.fromkeys(addresses)]
        names = [one.name for one in sessions]
        shown = (f" {names[: at + 1].count(name)}" if names.count(name) > 1 else "" for at, name in enumerate(names))
        return {one.name + number: one for one, number in zip(sessions, shown, strict=True)}

    def recorder(self, address: str) -> LastRunRecorder:
        """The recording of a robot that some page holds.

        Raises:
            KitRobotError: there is none.
        """
        found = self._sessions.get(address)
        if found is None:
            raise AddressError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        return found.recorder

    def stop(self, address: str) -> None:
        """Stops a robot, or all of them with ""; whichever page holds it."""
        for session in [*self._sessions.values()]:
            if address in ("", session.address):
                session.stop()
        if address in ("", *self.team.addresses):
            self.team.stop()

    async def release(self, session: RobotWorker) -> None:
        """Releases a robot."""
        session.close()
        await run_in_background(session.wait, CLOSE_WITHIN_S)
        self._remove_session(session)

    async def release_board(self, holder: str, address: str) -> None:
        """Releases the robot at an address from any page, for the team.

        Raises:
            KitRobotError: there is no such port, or another page has it.
        """
        if address.startswith(AT_PAGE):
            raise AddressError(
                Sentence("a board that the browser reaches cannot be in a team"),
                Sentence("plug it into the computer that KitRobot runs on"),
            )
        await self._name_of(address, holder)
        found = self._sessions.get(address)
        if found is not None:
            await self.release(found if found.closing else _require_holder(holder, found))

    def _remove_session(self, session: RobotWorker) -> None:
        if self._sessions.get(session.address) is session:
            del self._sessions[session.address]
            self._texts = {key: kept for key, kept in self._texts.items() if key[0] != session.address}
        self._changed(session.address, session.holder)

    def notify_team_changed(self) -> None:
        """Sends all pages the status of the team."""
        for subscriber in self._subscribers:
            subscriber.queue_team()

    def _changed(self, address: str, holder: str) -> None:
        for subscriber in self._subscribers:
            if subscriber.is_sent_board(address, holder):
                subscriber.queue_board(address)

    def team_text(self) -> str:
        """The team's status, as the text of a message."""
        return self.team.text()

    def encode_board(self, address: str) -> str:
        """The status of a robot, or that nobody holds it, encoded in the reader's language."""
        session, language = self._sessions.get(address), reader_language()
        if session is None:
            return BoardGoneMessage(address=address).model_dump_json()
        version, kept = self._texts.get((address, language), (-1, ""))
        if version != session.status.version:
            version = session.status.version
            kept = session.message().model_dump_json()
            self._texts[address, language] = (version, kept)
        return kept


def _require_holder(holder: str, session: RobotWorker) -> RobotWorker:
    if session.holder != holder:
        raise HeldError(
            Sentence("another page of this studio has `{robot}`", session.name),
            Sentence("disconnect it there; to stop it, press STOP here"),
        )
    return session


def _display_name(address: str, name: str) -> str:
    """The name of a robot on the page: its address for one on the network."""
    return address.split("://", 1)[1] if "://" in address else name or address


class BoardsError(KitRobotError):
    """There are more robots than one studio supports."""
