"""All real robots of one studio: who holds which, which ports there are, and telling the pages.

A robot belongs to the page that connected it (its *holder*), for a serial port has room for one; every page is told of
all of them and any may stop any. When a page goes away, its robots are let go: those that are held stop.

A robot's message is encoded once for all pages of a language. A port that a page has opened itself (`page_ports`), and
the robot on it, only that page is told of. Only the server's event loop touches anything here; robots' threads call it
through `call_soon_threadsafe`. The ports are looked at only while some page shows them.

Left to others: a page and what it is told (`robot_subscriber`).
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import itertools
import logging
from collections.abc import Iterable
from typing import TYPE_CHECKING

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.beside_loop import beside_loop
from kitrobot.server.robot_gateway import RobotGateway
from kitrobot.server.robot_subscriber import AT_PAGE, MOST_BOARDS, Line, Subscriber
from kitrobot.server.shapes import (
    BoardGoneMessage,
    BoardPortShape,
    BoardPortsMessage,
)
from kitrobot.server.team_room import TeamRoom
from kitrobot.text import Sentence
from kitrobot.translation import reader_language

if TYPE_CHECKING:
    from kitrobot.deploy import Port
    from kitrobot.server.robot_recorder import LastRun
    from kitrobot.server.robot_worker import RobotWorker

LOOK_S = 1.0
"""How often the ports are looked at while a page shows them."""
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
        """Whether there are only ports that the page opens: it has none of its own, and no network (`in_page`)."""
        self.team = TeamRoom(self)
        self._sessions: dict[str, RobotWorker] = {}
        self._subscribers: list[Subscriber] = []
        self._names = itertools.count(1)
        self._ports: list[Port] = []
        self._looking: asyncio.Task[None] | None = None
        self._leaving: set[asyncio.Task[None]] = set()
        self._texts: dict[tuple[str, str], tuple[int, str]] = {}

    # -- pages

    def enter(self, line: Line) -> Subscriber:
        """A page comes; it is told of all robots."""
        subscriber = Subscriber(self, line, f"page-{next(self._names)}")
        self._subscribers.append(subscriber)
        for address, session in self._sessions.items():
            if subscriber.tells_of(address, session.holder):
                subscriber.tell_board(address)
        if self.team.standing.agents:
            subscriber.tell_team()
        return subscriber

    def page_with(self, key: str) -> Subscriber | None:
        """The page that was told that key."""
        right = [one for one in self._subscribers if hmac.compare_digest(one.key.encode(), key.encode())]
        return right[0] if right else None

    async def leave(self, subscriber: Subscriber) -> None:
        """A page goes: what it holds is let go. Whoever waits for that may be cancelled; it is done all the same."""
        self._subscribers.remove(subscriber)
        self.look(subscriber, False)
        mine = [session for session in self._sessions.values() if session.holder == subscriber.name]
        for session in mine:
            session.close()
        task = asyncio.create_task(self._end(subscriber, mine))
        self._leaving.add(task)
        task.add_done_callback(self._leaving.discard)
        await asyncio.shield(task)

    async def _end(self, subscriber: Subscriber, sessions: list[RobotWorker]) -> None:
        await subscriber.end()
        for session in sessions:
            await beside_loop(session.wait, CLOSE_WITHIN_S)
            self._let_go(session)
        # Not before the robots were told to stop.
        for port in [*subscriber.ports.values()]:
            port.gone()

    # -- ports

    def look(self, subscriber: Subscriber, on: bool) -> None:
        """The page shows the ports from now on, or no more."""
        subscriber.looks = on
        if any(one.looks for one in self._subscribers):
            if on:
                subscriber.tell_ports()
            if self._looking is None and not self.in_page:
                self._looking = asyncio.create_task(self._look_at_ports())
        elif self._looking is not None:
            self._looking.cancel()
            self._looking = None

    async def _look_at_ports(self) -> None:
        while True:
            await self._find_ports()
            await asyncio.sleep(LOOK_S)

    async def _find_ports(self) -> None:
        try:
            found = await beside_loop(self.links.list_ports)
        except (KitRobotError, OSError) as error:
            _log.debug("the ports cannot be listed: %s", error)
            found = []
        if found != self._ports:
            self._ports = found
            for subscriber in self._subscribers:
                if subscriber.looks:
                    subscriber.tell_ports()

    def ports_text(self, page: Subscriber) -> str:
        """All ports that a page may use, encoded."""
        ports = [
            BoardPortShape(
                address=one.address,
                name=_shown(one.address, one.name),
                description=one.description,
                firmware=one.firmware,
            )
            for one in (*(port.port for port in page.ports.values()), *self._ports)
        ]
        return BoardPortsMessage(ports=ports).model_dump_json()

    # -- robots

    async def session(self, holder: str, address: str) -> RobotWorker:
        """The session of that page on the robot at an address, taken now if nobody has it.

        Raises:
            KitRobotError: there is no such port, another page has it, or there are too many.
        """
        name = await self._name_of(address, holder)
        while (found := self._sessions.get(address)) is not None and found.closing:
            # Whoever had it is gone; a page that was loaded again asks before all is done.
            await beside_loop(found.wait, CLOSE_WITHIN_S)
            self._let_go(found)
        if found is not None:
            return _mine(holder, found)
        if address in self.team.addresses:
            raise HeldError(Sentence("the team has `{robot}`", name), Sentence("stop the team first"))
        if len(self._sessions) >= MOST_BOARDS:
            raise BoardsError(
                Sentence("this studio talks with {most} robots already", MOST_BOARDS),
                Sentence("disconnect one of them first"),
            )
        from kitrobot.server.robot_worker import RobotWorker

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
            return _shown(address, "")
        known = {one.address: one.name for one in self._ports}
        if address not in known:
            await self._find_ports()
            known = {one.address: one.name for one in self._ports}
        if address not in known:
            raise AddressError(
                Sentence("there is no robot at `{address}`", address),
                Sentence("choose one of the list, or write `socket://host:port`"),
            )
        return _shown(address, known[address])

    def taken(self, holder: str, address: str) -> RobotWorker:
        """The session that this page has on a robot already.

        Raises:
            KitRobotError: it has none.
        """
        found = self._sessions.get(address)
        if found is None:
            raise AddressError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        return _mine(holder, found)

    def together(self, holder: str, addresses: Iterable[str]) -> dict[str, RobotWorker]:
        """Sessions that this page has, by names that tell robots apart that are called alike.

        Raises:
            KitRobotError: it has none on one of them.
        """
        sessions = [self.taken(holder, address) for address in dict.fromkeys(addresses)]
        names = [one.name for one in sessions]
        shown = (f" {names[: at + 1].count(name)}" if names.count(name) > 1 else "" for at, name in enumerate(names))
        return {one.name + number: one for one, number in zip(sessions, shown, strict=True)}

    def recorder(self, address: str) -> LastRun:
        """The recording of a robot that some page talks with.

        Raises:
            KitRobotError: there is none.
        """
        found = self._sessions.get(address)
        if found is None:
            raise AddressError(Sentence("nobody talks with this robot"), Sentence("connect it first"))
        return found.recorder

    def stop(self, address: str) -> None:
        """Stops a robot, or all of them with ""; whoever holds it."""
        for session in [*self._sessions.values()]:
            if address in ("", session.address):
                session.stop()
        if address in ("", *self.team.addresses):
            self.team.stop()

    async def forget(self, session: RobotWorker) -> None:
        """Lets go of a robot."""
        session.close()
        await beside_loop(session.wait, CLOSE_WITHIN_S)
        self._let_go(session)

    async def free(self, holder: str, address: str) -> None:
        """Sees to it that nobody here talks with the robot at an address: the team is to have it.

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
            await self.forget(found if found.closing else _mine(holder, found))

    def _let_go(self, session: RobotWorker) -> None:
        if self._sessions.get(session.address) is session:
            del self._sessions[session.address]
            self._texts = {key: kept for key, kept in self._texts.items() if key[0] != session.address}
        self._changed(session.address, session.holder)

    def team_changed(self) -> None:
        """All pages are told of the team."""
        for subscriber in self._subscribers:
            subscriber.tell_team()

    def _changed(self, address: str, holder: str) -> None:
        for subscriber in self._subscribers:
            if subscriber.tells_of(address, holder):
                subscriber.tell_board(address)

    def board_text(self, address: str) -> str:
        """A robot as it stands, or that nobody talks with it, encoded in the language of who asks."""
        session, language = self._sessions.get(address), reader_language()
        if session is None:
            return BoardGoneMessage(address=address).model_dump_json()
        version, kept = self._texts.get((address, language), (-1, ""))
        if version != session.standing.version:
            version = session.standing.version
            kept = session.message().model_dump_json()
            self._texts[address, language] = (version, kept)
        return kept


def _mine(holder: str, session: RobotWorker) -> RobotWorker:
    if session.holder != holder:
        raise HeldError(
            Sentence("another page of this studio has `{robot}`", session.name),
            Sentence("disconnect it there; to stop it, press STOP here"),
        )
    return session


def _shown(address: str, name: str) -> str:
    """What a robot is called on the page: one on the network by where it is."""
    return address.split("://", 1)[1] if "://" in address else name or address


class BoardsError(KitRobotError):
    """There are more robots than one studio talks with."""
