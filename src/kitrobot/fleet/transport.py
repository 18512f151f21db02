"""`Channel`: envelopes over Zenoh between the processes of a fleet.

An agent hears what is for all agents and what is for it; the team's process hears what is for it. Zenoh's own threads
look at the seal of what comes, and put it into a queue, of which each sender may fill a part: who has not the key uses
up nobody's, nor who recorded another run. Whoever has the channel takes envelopes out. What is no envelope of this team
is refused and reported, once for each sender and reason, then counted (`refusals`).

An agent that knows no run takes nothing but the answer to its own process (`WELCOME`), which names the run; after that,
nothing but what is of this run. So what somebody recorded of another run begins and ends nothing.
"""

from __future__ import annotations

import secrets
import time
from collections import Counter, deque
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from threading import Condition
from typing import Any

from kitrobot.fleet.charter import FleetError
from kitrobot.fleet.envelopes import (
    EVERYBODY,
    HELLO,
    STOP,
    TEAM_PROCESS,
    WELCOME,
    Envelope,
    EnvelopeError,
    VersionError,
    seal,
    unseal,
)
from kitrobot.fleet.link_sockets import set_up_links
from kitrobot.fleet.refusals import NOBODY, Refusals
from kitrobot.fleet.zenoh_session import close_session, open_session
from kitrobot.team.charter import MOST_MEMBERS
from kitrobot.text.sentences import Sentence

MOST_OF_ONE = 1024
"""Messages of one sender that may wait."""
MOST_WAITING = 16_384
MOST_REASONS = 128
"""Senders and reasons to refuse messages that are stored until they are reported."""


@dataclass(frozen=True, slots=True)
class Network:
    """How a process of a fleet is reached and reaches others.

    Attributes:
        fleet: the name under which its members find each other.
        listen, connect: Zenoh endpoints such as `tcp/127.0.0.1:7447`.
        router: whether `connect` names routers; then everything goes through them.
        tls: a folder with `ca.pem`, `cert.pem` and `key.pem`; endpoints then begin with `tls/`.
    """

    fleet: str
    listen: tuple[str, ...] = ()
    connect: tuple[str, ...] = ()
    router: bool = False
    tls: Path | None = None


class Channel:
    """An open way to the others. `me` is the number of the agent, or `TEAM_PROCESS`.

    Attributes:
        run: the number of the run; 0: not known yet.
        process: the number of this process, where it is an agent's.
        refused: what is to be reported, since somebody took it out.
        strangers: the senders of messages of another version, likewise.

    Raises:
        FleetError: Zenoh is not installed, or cannot be opened as the network says.
    """

    def __init__(self, network: Network, me: int, key: bytes) -> None:
        self.me = me
        self.run = self.process = 0
        self.refused: list[Sentence] = []
        self._key = key
        self._serial = 0
        self._waiting: deque[Envelope] = deque()
        self._stops: dict[int, Envelope] = {}
        """The latest emergency stop, or answer to it, of each sender: never dropped, and ahead of all that waits."""
        self._of: Counter[int] = Counter()
        self._unwanted: dict[tuple[int, str], tuple[Sentence, int]] = {}
        """What was refused unread: of each sender and reason, the last sentence and how often."""
        self.strangers: set[int] = set()
        self._dropped = 0
        self._arrived = Condition()
        self._refusals = Refusals()
        if me != TEAM_PROCESS:
            self.draw_number()
        zenoh, self._session = _open(network)
        self._root = f"kitrobot/{network.fleet}"
        remote = zenoh.Locality.REMOTE
        mine = [f"{self._root}/t"] if me == TEAM_PROCESS else [f"{self._root}/a", f"{self._root}/m/{me}"]
        self._subscribers = [self._session.declare_subscriber(name, self._came, allowed_origin=remote) for name in mine]
        self._links = self._session.info.declare_link_events_listener(lambda event: set_up_links(), history=True)
        self._drop = zenoh.CongestionControl.DROP
        self._priority = zenoh.Priority.REAL_TIME

    def _came(self, sample: Any) -> None:
        """Called in a thread of Zenoh's."""
        try:
            envelope = unseal(bytes(sample.payload), self._key)
        except EnvelopeError as error:
            self._leave_unread(error.args[1] if isinstance(error, VersionError) else NOBODY, error.args[0])
            return
        if self.run and envelope.run not in (0, self.run):
            self._leave_unread(envelope.sender, Sentence("a message of another run"))
            return
        with self._arrived:
            if envelope.kind == STOP:
                self._stops[envelope.sender] = envelope
                self._arrived.notify()
                return
            if self._of[envelope.sender] >= MOST_OF_ONE or len(self._waiting) >= MOST_WAITING:
                self._dropped += 1
                return
            self._of[envelope.sender] += 1
            self._waiting.append(envelope)
            self._arrived.notify()

    def _leave_unread(self, sender: int, why: Sentence) -> None:
        key = sender if sender < MOST_MEMBERS else NOBODY, why.template
        with self._arrived:
            if key in self._unwanted or len(self._unwanted) < MOST_REASONS:
                self._unwanted[key] = why, self._unwanted.get(key, (why, 0))[1] + 1
                self._arrived.notify()

    def draw_number(self) -> None:
        """This process takes part as another one from now on, in whatever run."""
        self.run, self.process = 0, 1 + secrets.randbelow(1 << 63)

    def wake(self) -> None:
        """Ends the waiting of `receive`; from any thread."""
        with self._arrived:
            self._arrived.notify()

    def receive(self, seconds: float, most: int = 256) -> list[Envelope]:
        """What came, as soon as anything did, or nothing after so many seconds; emergency stops first."""
        with self._arrived:
            if not self._waiting and not self._stops and seconds > 0:
                self._arrived.wait(seconds)
            taken = [self._waiting.popleft() for _ in range(min(most, len(self._waiting)))]
            for envelope in taken:
                self._of[envelope.sender] -= 1
            dropped, self._dropped = self._dropped, 0
            unwanted, self._unwanted = self._unwanted, {}
        for (sender, _), (why, times) in unwanted.items():
            if self._refuse(sender, why, times) and sender != NOBODY:
                self.strangers.add(sender)
        if dropped:
            self._refuse(NOBODY, Sentence("messages that come faster than they can be read are dropped"), dropped)
        return [*self.stops(), *(envelope for envelope in taken if self._is_mine(envelope))]

    def stops(self) -> list[Envelope]:
        """Emergency stops that have come, for who is busy with what came before; `receive` gives them too."""
        with self._arrived:
            stops, self._stops = self._stops, {}
        return [envelope for envelope in stops.values() if self._is_mine(envelope)]

    def _is_mine(self, envelope: Envelope) -> bool:
        """Whether it is for this process and of this run; else that is reported, but for what is usual."""
        sender = envelope.sender
        if envelope.to not in (self.me, EVERYBODY) or sender == self.me:
            self._refuse(sender, Sentence("a message for somebody else"))
            return False
        if self.me == TEAM_PROCESS:
            known = envelope.run == self.run or (envelope.run == 0 and envelope.kind == HELLO)
        elif sender == TEAM_PROCESS and envelope.to == self.me and envelope.process != self.process:
            return False  # for another process of this name
        elif self.run == 0:
            return sender == TEAM_PROCESS and envelope.kind == WELCOME and envelope.to == self.me
        else:
            known = envelope.run == self.run
        if not known:
            self._refuse(sender, Sentence("a message of another run"))
        return known

    def _refuse(self, sender: int, why: Sentence, times: int = 1) -> bool:
        """Counts a refusal; returns whether it is to be reported."""
        message = self._refusals.count(sender, why, times)
        if message is not None:
            self.refused.append(message)
        return message is not None

    def send(self, to: int, kind: int, body: bytes = b"", process: int = 0) -> None:
        """Brings a message on its way; it may be lost. `process`: which one of the addressee it is for."""
        self._serial += 1
        envelope = Envelope(kind, self.run, self.me, to, self._serial, body, process or self.process)
        data = seal(envelope, self._key)
        name = "t" if to == TEAM_PROCESS else "a" if to == EVERYBODY else f"m/{to}"
        self._session.put(
            f"{self._root}/{name}", data, congestion_control=self._drop, priority=self._priority, express=True
        )

    def close(self) -> None:
        """Ends it; nothing comes any more."""
        close_session(self._session)


def _open(network: Network) -> tuple[Any, Any]:
    """Zenoh, and a session of it."""
    settings: dict[str, Any] = {
        "mode": "client" if network.router else "peer",
        "connect/endpoints": list(network.connect),
        "connect/timeout_ms": 5000,
        # Zenoh waits 1, 2, 4 s between attempts: longer than a router takes to be there again.
        "connect/retry": {"period_init_ms": 200, "period_max_ms": 500, "period_increase_factor": 1.5},
        "connect/exit_on_failure": False,
        # A queue of two batches loses messages whenever the machine is busy.
        "transport/link/tx/queue/size/real_time": 16,
    }
    if not network.router:
        settings["listen/endpoints"] = list(network.listen)
    if network.tls is not None:
        settings |= _tls(network.tls)
    return open_session(
        settings,
        Sentence("a team as processes needs the package `{package}`", "eclipse-zenoh"),
        Sentence("an endpoint is written as `tcp/HOST:PORT`, with TLS as `tls/HOST:PORT`"),
    )


def _tls(folder: Path) -> dict[str, Any]:
    names = {"ca": folder / "ca.pem", "certificate": folder / "cert.pem", "key": folder / "key.pem"}
    for path in names.values():
        if not path.is_file():
            raise FleetError(
                Sentence("TLS needs the file `{file}`, which is not there", str(path)),
                Sentence("put ca.pem, cert.pem and key.pem into one folder"),
            )
    tls = "transport/link/tls"
    return {
        f"{tls}/root_ca_certificate": str(names["ca"]),
        f"{tls}/enable_mtls": True,
        **{f"{tls}/{side}_certificate": str(names["certificate"]) for side in ("listen", "connect")},
        **{f"{tls}/{side}_private_key": str(names["key"]) for side in ("listen", "connect")},
    }


Clock = Callable[[], int]


def milliseconds() -> int:
    """Ms by a clock that only goes forward, also while the process is stopped."""
    return time.monotonic_ns() // 1_000_000
