"""`python -m benchmarks.meeting KIND NUMBER COUNT ROUNDS WHERE`: one of COUNT processes that meet ROUNDS times.

KIND is `kitrobot` (the log of a team over Zenoh, as an agent of a fleet has it; WHERE is an endpoint) or `mqtt` (each
tells its arrival to a broker, and goes on when it has heard of all; WHERE is a port). It prints the milliseconds from
its arrival at each meeting until it went on, as JSON.
"""

from __future__ import annotations

import json
import socket
import sys
import threading
import time
from collections import defaultdict
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kitrobot.fleet.transport import Channel

KEY = "a key for the benchmark alone"
FLEET = "benchmark"


def kitrobot(me: int, count: int, rounds: int, where: str) -> list[float]:
    from kitrobot.fleet.bundles import bundle, unbundle
    from kitrobot.fleet.envelopes import MEMBER, Envelope
    from kitrobot.fleet.keys import key_of
    from kitrobot.fleet.transport import Channel, Network
    from kitrobot.team.changes import AppliedNote
    from kitrobot.team.charter import Charter
    from kitrobot.team.codec import decode
    from kitrobot.team.commands import Note, Seat
    from kitrobot.team.events import Event, IncomingMessage, Time
    from kitrobot.team.member import step
    from kitrobot.team.state import initial_state

    channel = Channel(Network(FLEET, ("tcp/127.0.0.1:0",), (where,)), me, key_of(KEY, "here"))
    join_run(channel)
    charter = Charter(count, lease=1000)
    arrived: defaultdict[int, int] = defaultdict(int)

    def now() -> int:
        return time.monotonic_ns() // 1_000_000

    state = initial_state(charter, Seat(me, 0), now())

    def take(event: Event) -> None:
        nonlocal state
        stepped = step(charter, state, now(), event)
        state = stepped.state
        for to, body in bundle(stepped.messages, 1):
            channel.send(to, MEMBER, body)
        for change in stepped.changes:
            if isinstance(change, AppliedNote):
                arrived[change.numbers[0]] += 1

    def messages(came: list[Envelope]) -> list[bytes]:
        return [one for envelope in came if envelope.kind == MEMBER for one in unbundle(envelope.body, me)]

    taken: list[float] = []
    told_at = 0
    for number in range(rounds):
        begun = time.perf_counter()
        take(Note((number,)))
        while arrived[number] < count:
            came = messages(channel.receive(0.02))
            for place, data in enumerate(came, 1):
                take(IncomingMessage(decode(data, 1), place < len(came)))
            if now() - told_at > 50:
                told_at = now()
                take(Time())
        taken.append(1000 * (time.perf_counter() - begun))
    end = time.monotonic() + 1.0
    while time.monotonic() < end:
        for data in messages(channel.receive(0.05)):
            take(IncomingMessage(decode(data, 1)))
        take(Time())
    channel.close()
    return taken


def join_run(channel: Channel) -> None:
    """Says that it is there until the run begins."""
    from kitrobot.fleet.envelopes import BEGIN, HELLO, TEAM_PROCESS, WELCOME

    has_begun = False
    while not has_begun:
        channel.send(TEAM_PROCESS, HELLO)
        for envelope in channel.receive(0.1):
            if envelope.kind == WELCOME:
                channel.run = envelope.run
            has_begun |= envelope.kind == BEGIN


def mqtt(me: int, count: int, rounds: int, where: str) -> list[float]:
    import paho.mqtt.client as paho
    from paho.mqtt.enums import CallbackAPIVersion

    changed = threading.Condition()
    arrived: defaultdict[int, int] = defaultdict(int)
    there: set[bytes] = set()

    def heard(client: object, data: object, message: paho.MQTTMessage) -> None:
        with changed:
            if message.topic == "there":
                there.add(bytes(message.payload))
            else:
                arrived[int(message.payload)] += 1
            changed.notify()

    def at_once(client: object, data: object, opened: Any) -> None:
        """As the broker and Zenoh send: else each message waits 40 ms for the last one to be acknowledged."""
        opened.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    client = paho.Client(CallbackAPIVersion.VERSION2)
    client.on_message = heard
    client.on_socket_open = at_once
    client.connect("127.0.0.1", int(where))
    client.subscribe([("there", 1), ("here", 1)])
    client.loop_start()
    while len(there) < count:
        client.publish("there", str(me), 1)
        with changed:
            changed.wait(0.2)
    client.publish("there", str(me), 1)
    taken: list[float] = []
    for number in range(rounds):
        begun = time.perf_counter()
        client.publish("here", str(number), 1)
        with changed:
            while arrived[number] < count:
                changed.wait(5)
        taken.append(1000 * (time.perf_counter() - begun))
    time.sleep(0.5)
    client.loop_stop()
    client.disconnect()
    return taken


if __name__ == "__main__":
    kind, number, members, times, place = sys.argv[1:]
    print(json.dumps({"kitrobot": kitrobot, "mqtt": mqtt}[kind](int(number), int(members), int(times), place)))
