"""`RosBridge`: a run on a ROS 2 network while it goes on, without ROS installed. See docs/trace.md, *Live to ROS 2*.

It is one node, `kitrobot`. At each step it sends where the robots are, how they move, and how they are told to move;
once in a second of the run, how they are. Times are those of the run: `/clock` gives them to nodes that use simulated
time. Who listens too slowly misses messages: the run never waits. A message on `/kitrobot/stop` asks for its end, which
is left to whoever runs it. Nobody drives a robot from ROS: its program does.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from threading import Event
from typing import Any, Final

from kitrobot.fleet.zenoh_session import close_session, open_session
from kitrobot.live.realtime_pacer import RealtimePacer
from kitrobot.sim.recorder import DOING, Recorder
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import POSE_WORDS
from kitrobot.trace.ros.keys import STOP_TOPIC, RosNode, encode_attachment, sender_id
from kitrobot.trace.ros.messages import (
    ERROR,
    OK,
    WARN,
    clock,
    encode_diagnostics,
    odometry,
    split_time,
    transforms,
    turn_of,
    twist,
)
from kitrobot.trace.ros.topics import robot_parts

LOCAL_ENDPOINT: Final = "tcp/127.0.0.1:7447"
"""Where the nodes of a machine look for their router."""

_NODE: Final = "kitrobot"
_HOW: Final = {"failed": (ERROR, "failed"), "stalled": (WARN, "stalled"), "idle": (OK, "ended")}
"""By what a robot does, the level and the word of its diagnostics."""
_WELL: Final = (OK, "well")


@dataclass(frozen=True, slots=True)
class RosNetwork:
    """Where ROS 2 is.

    Attributes:
        domain: its ROS_DOMAIN_ID, 0 to 232.
        listen: the Zenoh endpoint at which its nodes reach this run, which is a router for them.
        router: the endpoint of a router that is there; None: this run is the router.
    """

    domain: int
    listen: str = LOCAL_ENDPOINT
    router: str | None = None


class RosBridge:
    """A run on a ROS 2 network; `stopped` is set by a message on `STOP_TOPIC`.

    Args:
        simulation: the run, before its first step.
        network: where to send it.

    Raises:
        FleetError: Zenoh is not installed, or cannot be opened as the network says.
    """

    def __init__(self, simulation: Simulation, network: RosNetwork) -> None:
        self.stopped = Event()
        self._simulation = simulation
        self._recorder = Recorder(simulation)
        self._pacer = RealtimePacer(simulation.tick_ms / 1000, time.monotonic)
        header = self._recorder.header
        columns = {(column.owner, column.name): at for at, column in enumerate(header.columns)}
        self._scales = [header.columns[columns[header.agents[0].name, word]].scale for word in POSE_WORDS[:3]]
        self._places = [[columns[agent.name, word] for word in POSE_WORDS[:3]] for agent in header.agents]
        """Of each robot the columns of x, y and heading."""
        self._doing = [columns[agent.name, "doing"] for agent in header.agents]
        parts = robot_parts(agent.name for agent in header.agents)
        self._robots = [parts[agent.name] for agent in header.agents]
        self._zenoh, self._session = _open(network)
        self._node = RosNode(network.domain, str(self._session.info.zid()), _NODE)
        self._numbers = count(1)
        self._declared = [self._session.liveliness().declare_token(self._node.token), *self._listen()]
        """Subscriptions and tokens, which end once nobody has them."""
        self._transforms, self._twist, self._clock = transforms(self._robots), twist(), clock()
        self._odometry = [odometry(robot) for robot in self._robots]
        self._send_clock = self._publisher("/clock", "rosgraph_msgs/msg/Clock")
        self._send_transforms = self._publisher("/tf", "tf2_msgs/msg/TFMessage")
        self._send_diagnostics = self._publisher("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray")
        self._send_odometry = [self._publisher(f"/{one}/odom", "nav_msgs/msg/Odometry") for one in self._robots]
        self._send_commands = [self._publisher(f"/{one}/cmd_vel", "geometry_msgs/msg/Twist") for one in self._robots]

    def _listen(self) -> list[Any]:
        kind = "std_msgs/msg/Empty"
        key = self._node.topic_key(STOP_TOPIC, kind)
        token = self._node.endpoint_token(next(self._numbers), "MS", STOP_TOPIC, kind)
        return [
            self._session.declare_subscriber(key, lambda sample: self.stopped.set()),
            self._session.liveliness().declare_token(token),
        ]

    def _publisher(self, topic: str, kind: str) -> Callable[[bytes], None]:
        """Declares a publisher; what it gives sends a message."""
        token = self._node.endpoint_token(next(self._numbers), "MP", topic, kind)
        publisher = self._session.declare_publisher(
            self._node.topic_key(topic, kind), congestion_control=self._zenoh.CongestionControl.DROP
        )
        self._declared += [publisher, self._session.liveliness().declare_token(token)]
        sender, serials = sender_id(token), count(1)

        def send(message: bytes) -> None:
            publisher.put(message, attachment=encode_attachment(next(serials), time.time_ns(), sender))

        return send

    def publish(self) -> None:
        """Sends the run as it stands; after each step, and before the first."""
        record = self._recorder.record(())
        members = self._simulation.members
        stamp = split_time(record.tick * self._simulation.tick_ms * 1_000_000)
        self._send_clock(self._clock.encode(stamp))
        moved: list[float] = []
        for at, agent in enumerate(members):
            x, y, heading = (
                record.numbers[column] * scale for column, scale in zip(self._places[at], self._scales, strict=True)
            )
            pose = (x / 1000, y / 1000, 0.0, 0.0, 0.0, *turn_of(heading))
            speed, rate = agent.motion
            self._send_odometry[at](self._odometry[at].encode((*stamp, *pose, *_velocity(speed, rate))))
            self._send_commands[at](self._twist.encode(_velocity(*agent.commanded_motion)))
            moved += (*stamp, *pose)
        self._send_transforms(self._transforms.encode(moved))
        second = 1000 // self._simulation.tick_ms or 1
        if record.tick % second == 0 or self._simulation.outcome is not None:
            states = [_HOW.get(DOING[record.numbers[at]], _WELL) for at in self._doing]
            named = zip(states, self._robots, members, strict=True)
            self._send_diagnostics(
                encode_diagnostics(stamp, [(level, robot, word, one.name) for (level, word), robot, one in named])
            )

    def wait_until_due(self) -> bool:
        """Waits until real time has come to where the run stands; gives False when the run is to end instead."""
        tick = self._simulation.tick
        if tick == 0:
            self._pacer.set_speed(1.0, tick)
            return not self.stopped.is_set()
        self._pacer.due(tick - 1)  # A run that fell behind does not race.
        return not self.stopped.wait(self._pacer.wait_s(tick - 1))

    def close(self) -> None:
        """The node leaves the network."""
        close_session(self._session)


def _velocity(speed: float, rate: float) -> tuple[float, ...]:
    """Linear and angular velocity of a robot in its own frame, of mm/s and rad/s."""
    return speed / 1000, 0.0, 0.0, 0.0, 0.0, rate


def _open(network: RosNetwork) -> tuple[Any, Any]:
    """Zenoh, and a session of it."""
    settings: dict[str, Any] = {
        # A burst of many robots' messages is more than two batches.
        "transport/link/tx/queue/size/data": 16,
    }
    missing = Sentence("messages for ROS 2 need the package `{package}`", "eclipse-zenoh")
    if network.router is not None:
        settings |= {"mode": "client", "connect/endpoints": [network.router], "connect/timeout_ms": 2000}
        return open_session(
            settings, missing, Sentence("start the router: {command}", "`ros2 run rmw_zenoh_cpp rmw_zenohd`")
        )
    settings |= {"mode": "router", "listen/endpoints": [network.listen]}
    way_out = Sentence(
        "an endpoint is written as `tcp/HOST:PORT`; if a router of ROS 2 is there, send through it: {option}",
        f"`--ros-router {network.listen}`",
    )
    return open_session(settings, missing, way_out)
