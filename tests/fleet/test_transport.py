"""The ways on which processes of a team meet other than plain TCP: with TLS, and through a router."""

from __future__ import annotations

import json
import signal
import socket
import ssl
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
import zenoh

from kitrobot.fleet.envelopes import EVERYBODY, HELLO, MEMBER, TEAM_PROCESS, Envelope, seal
from kitrobot.fleet.transport import MOST_OF_ONE, Channel, Network
from kitrobot.workspace.fleets import free_endpoint
from tests.certificates import by_authority
from tests.fleet.test_processes import SEARCH, agents_of, is_there, linux, started

NAMES = ["robot-1", "robot-2"]


def run_and_stop(record: Callable[[str, object], None], where: str, *words: str) -> None:
    """Two agents come, hear each other, and answer the emergency stop; how fast is kept with the test's result."""
    with started("team", SEARCH, "--json", *words) as team:
        assert where in team.until("the team is at")
        for _ in NAMES:
            team.until("hears its team")
        agents = agents_of(team)
        assert sorted(agents) == NAMES
        team.process.send_signal(signal.SIGINT)
        status, out, said = team.end()
    result = json.loads(out)
    assert (status, result["outcome"]) == (130, "stopped"), said
    assert sorted(result["stopped_ms"]) == NAMES, said
    assert not any(map(is_there, agents.values())), "everything ends"
    record("stopped_ms", result["stopped_ms"])


RUN = 7


@linux
def test_a_team_meets_with_tls(tmp_path: Path, record_property: Callable[[str, object], None]) -> None:
    run_and_stop(record_property, "tls/127.0.0.1:", "--tls", str(by_authority(tmp_path)))


@pytest.fixture
def router() -> Iterator[str]:
    """Where a router of Zenoh's is."""
    where = free_endpoint()
    config = zenoh.Config()
    for name, value in (("mode", "router"), ("listen/endpoints", [where]), ("scouting/multicast/enabled", False)):
        config.insert_json5(name, json.dumps(value))
    with zenoh.open(config):
        yield where


def test_members_hear_each_other_and_the_team_through_a_router(router: str) -> None:
    key = bytes(32)
    network = Network("here", (), (router,), router=True)
    with ExitStack() as stack:
        one, other, team = (Channel(network, me, key) for me in (0, 1, TEAM_PROCESS))
        for channel in (one, other, team):
            stack.callback(channel.close)
            channel.run = RUN
        heard = set[tuple[int, int]]()
        end = time.monotonic() + 20
        while len(heard) < 3 and time.monotonic() < end:
            # Who is not known yet hears nothing: what is said once may be lost, as the protocol has it.
            one.send(1, MEMBER)
            other.send(EVERYBODY, MEMBER)
            one.send(TEAM_PROCESS, HELLO)
            heard |= {
                (envelope.sender, channel.me) for channel in (one, other, team) for envelope in channel.receive(0.02)
            }
        assert heard == {(0, 1), (1, 0), (0, TEAM_PROCESS)}


@linux
@pytest.mark.thorough("test_members_hear_each_other_and_the_team_through_a_router, without processes; --tls runs them")
def test_a_team_meets_through_a_router(router: str, record_property: Callable[[str, object], None]) -> None:
    run_and_stop(record_property, router, "--router", router)


def test_who_has_not_the_key_uses_up_no_members_share() -> None:
    key = bytes(32)
    where, name = free_endpoint(), "kitrobot/here/m/0"
    channel = Channel(Network("here", (where,)), 0, key)
    channel.run = RUN
    config = zenoh.Config()
    for setting, value in (("connect/endpoints", [where]), ("scouting/multicast/enabled", False)):
        config.insert_json5(setting, json.dumps(value))
    try:
        with zenoh.open(config) as session:
            way = session.declare_publisher(name, congestion_control=zenoh.CongestionControl.BLOCK)
            while not getattr(way.matching_status, "matching", way.matching_status):
                time.sleep(0.01)
            for serial in range(MOST_OF_ONE + 50):
                forged = seal(Envelope(MEMBER, RUN, 1, 0, serial, b""), bytes(range(32)))
                way.put(forged)
            way.put(seal(Envelope(MEMBER, RUN, 1, 0, 1, b"of the member"), key))
            # Nothing is read until all has come.
            time.sleep(0.3)
            end, found = time.monotonic() + 20, list[Envelope]()
            while not found and time.monotonic() < end:
                found = channel.receive(1)
        assert [envelope.body for envelope in found] == [b"of the member"]
        assert [why for why in channel.refused if "another key" in why] == channel.refused != []
    finally:
        channel.close()


def test_who_shows_no_certificate_of_the_authority_is_refused(tmp_path: Path) -> None:
    for name in ("own", "other"):
        (tmp_path / name).mkdir()
    tls, other = by_authority(tmp_path / "own"), by_authority(tmp_path / "other")
    where = free_endpoint(tls=True)
    host, port = where.removeprefix("tls/").rsplit(":", 1)
    words = [word for name in NAMES for word in ("--elsewhere", name)]
    key = tmp_path / "key"
    key.write_text("a key of sixteen letters")
    with started("team", SEARCH, *words, "--key", str(key), "--tls", str(tls), "--listen", where) as team:
        team.until("the team is at")
        # To whoever may come nothing is said before it says who it is.
        for shown, came in ((None, ssl.SSLError), (other, ssl.SSLError), (tls, TimeoutError)):
            context = ssl.create_default_context(cafile=str(tls / "ca.pem"))
            # Python from 3.13 on wants more of a certificate than Zenoh does.
            context.verify_flags &= ~ssl.VERIFY_X509_STRICT
            if shown is not None:
                context.load_cert_chain(shown / "cert.pem", shown / "key.pem")
            with (
                pytest.raises(came),
                socket.create_connection((host, int(port)), timeout=1) as line,
                context.wrap_socket(line, server_hostname=host) as way,
            ):
                way.recv(1)
