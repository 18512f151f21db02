"""A run goes to ROS 2 while it goes on: a client that is not ours finds it, receives it, and stops it."""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from threading import Event
from typing import Any

import pytest
import zenoh
from rosbags.typesys import Stores, get_typestore

import kitrobot
from kitrobot.files.examples import examples_folder
from kitrobot.live.ros_bridge import RosBridge, RosNetwork
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.ros.keys import TYPE_HASHES, RosNode, encode_attachment, sender_id
from kitrobot.workspace.fleets import free_endpoint
from tests.fleet.test_processes import started
from tests.patience import PATIENCE_S

DOMAIN = 7
ROBOT = "robot_1"
LEAST = 100
LINE = "=" * 80
TYPES = get_typestore(Stores.ROS2_JAZZY)


@pytest.fixture(scope="module")
def mission(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two robots that drive to and fro for longer than any test."""
    examples = examples_folder()
    assert examples is not None
    source, folder = examples / "pair", tmp_path_factory.mktemp("pair")
    text = (source / "pair.krt").read_text(encoding="utf-8")
    (folder / "pair.krt").write_text(text.replace('<set name="count">2<', '<set name="count">1000<'), encoding="utf-8")
    (folder / "pair.world.xml").write_bytes((source / "pair.world.xml").read_bytes())
    return folder / "pair.krt"


def write_definitions(folder: Path) -> None:
    """The definitions of all messages as files, as a client expects them."""
    for kind in TYPE_HASHES:
        first, *others = TYPES.generate_msgdef(kind, ros_version=2)[0].split(f"{LINE}\nMSG: ")
        for name, text in [(kind, first), *(one.split("\n", 1) for one in others)]:
            package, *_, short = name.split("/")
            (folder / package / "msg").mkdir(parents=True, exist_ok=True)
            (folder / package / "msg" / f"{short}.msg").write_text(text, encoding="utf-8")


class Heard:
    """What a client received of a run, how that ended, and its recording."""

    def __init__(self, told: Any, ended: tuple[int, str, str], trace: Path) -> None:
        self.told, self.ended = told, ended
        self.received: dict[str, list[Any]] = told["received"]
        with TraceReader(trace) as reader:
            self.values = [record.values(reader.header) for record in reader.walk(0)]
            self.tick_ns = reader.header.tick_ms * 1_000_000

    def at(self, stamp: Any) -> Any:
        """The recorded values of that moment."""
        tick, rest = divmod(stamp["sec"] * 1_000_000_000 + stamp["nanosec"], self.tick_ns)
        assert rest == 0
        return self.values[tick]


@pytest.fixture(scope="module")
def heard(mission: Path) -> Heard:
    folder = mission.parent
    write_definitions(folder / "messages")
    endpoint = free_endpoint()
    trace = folder / "run.krtrace"
    words = ("--ros", str(DOMAIN), "--ros-listen", endpoint, "--trace", str(trace))
    with started("run", str(mission), *words) as run:
        run.until("ROS 2 domain 7")
        client = subprocess.run(
            [
                sys.executable,
                str(Path(__file__).with_name("ros_client.py")),
                endpoint.rpartition(":")[2],
                str(DOMAIN),
                str(folder / "messages"),
                ROBOT,
                str(LEAST),
            ],
            capture_output=True,
            text=True,
            timeout=PATIENCE_S,
            check=False,
            # It clones definitions of messages that it does not find; here it finds all, and needs no git.
            env={**os.environ, "HOME": str(folder), "GIT_PYTHON_REFRESH": "quiet"},
        )
        assert client.returncode == 0, client.stderr
        return Heard(json.loads(client.stdout), run.end(), trace)


def test_a_client_that_is_not_ours_lists_the_topics_with_their_types(heard: Heard) -> None:
    robots = [
        (f"/robot_{n}/{name}", kind) for n in (1, 2) for name, kind in (("cmd_vel", "Twist"), ("odom", "Odometry"))
    ]
    packages = {"Twist": "geometry_msgs", "Odometry": "nav_msgs"}
    assert heard.told["topics"] == {
        "/clock": ["rosgraph_msgs/msg/Clock"],
        "/diagnostics": ["diagnostic_msgs/msg/DiagnosticArray"],
        "/kitrobot/stop": ["std_msgs/msg/Empty"],
        "/tf": ["tf2_msgs/msg/TFMessage"],
        **{topic: [f"{packages[kind]}/msg/{kind}"] for topic, kind in robots},
    }
    kind = "tf2_msgs/msg/TFMessage"
    assert heard.told["tf"] == ["kitrobot", "/", TYPES.hash_rihs01(kind), "::,10:,:,:,,", 1]


def test_what_it_receives_is_what_is_recorded_tick_for_tick(heard: Heard) -> None:
    def same_pose(position: Any, turn: Any, values: Any) -> None:
        assert (position["x"], position["y"]) == pytest.approx((values["x_mm"] / 1000, values["y_mm"] / 1000))
        turned = 2 * math.atan2(turn["z"], turn["w"])
        assert math.cos(turned - values["heading_rad"]) == pytest.approx(1)

    assert len(heard.received["/tf"]) >= LEAST
    for message in heard.received["/tf"]:
        assert [one["child_frame_id"] for one in message["transforms"]] == ["robot_1", "robot_2"]
        for name, one in zip(("robot-1", "robot-2"), message["transforms"], strict=True):
            values = heard.at(one["header"]["stamp"])[name]
            same_pose(one["transform"]["translation"], one["transform"]["rotation"], values)
    odometry = heard.received[f"/{ROBOT}/odom"]
    assert len(odometry) >= LEAST
    for message in odometry:
        assert (message["header"]["frame_id"], message["child_frame_id"]) == ("map", ROBOT)
        pose = message["pose"]["pose"]
        same_pose(pose["position"], pose["orientation"], heard.at(message["header"]["stamp"])["robot-1"])
    moments = [
        message["clock"]["sec"] * 1_000_000_000 + message["clock"]["nanosec"] for message in heard.received["/clock"]
    ]
    assert moments == sorted(set(moments))


def test_commands_are_those_of_the_program_and_diagnostics_say_how_robots_are(heard: Heard) -> None:
    commands = heard.received[f"/{ROBOT}/cmd_vel"]
    # It drives at 60 % of 400 mm/s, stands, or turns at 50 % of 180 °/s.
    ways = {(0.24, 0.0), (0.0, 0.0), (0.0, round(math.pi / 2, 6))}
    assert {(one["linear"]["x"], round(one["angular"]["z"], 6)) for one in commands} <= ways
    diagnostics = heard.received["/diagnostics"]
    assert len(diagnostics) >= 2
    for message in diagnostics:
        assert message["header"]["stamp"]["nanosec"] == 0
        told = [(one["name"], one["hardware_id"], one["level"], one["message"]) for one in message["status"]]
        assert told == [("robot_1", "robot-1", 0, "well"), ("robot_2", "robot-2", 0, "well")]


def test_another_domain_hears_and_sees_nothing(heard: Heard) -> None:
    assert heard.told["elsewhere"] == [[], 0]


def test_its_message_on_stop_ends_the_run_as_ctrl_c_does(heard: Heard) -> None:
    status, out, said = heard.ended
    assert (status, out) == (130, "")
    assert said.endswith("Stopped by a message on `/kitrobot/stop`.\n")


@pytest.fixture
def neighbour() -> Iterator[Any]:
    """Joins the router at an endpoint."""
    sessions = []

    def join(endpoint: str) -> Any:
        config = zenoh.Config()
        config.insert_json5("mode", '"client"')
        config.insert_json5("connect/endpoints", json.dumps([endpoint]))
        sessions.append(zenoh.open(config))
        return sessions[-1]

    yield join
    for session in sessions:
        session.close()


def test_a_team_goes_to_ros_and_stops_too(mission: Path, neighbour: Any) -> None:
    endpoint, here, moved = free_endpoint(), RosNode(DOMAIN, "0", "test"), Event()
    with started("team", str(mission), "--ros", str(DOMAIN), "--ros-listen", endpoint) as team:
        team.until("ROS 2 domain 7")
        session = neighbour(endpoint)
        key = here.topic_key("/tf", "tf2_msgs/msg/TFMessage")
        subscriber = session.declare_subscriber(key, lambda sample: moved.set())
        assert moved.wait(PATIENCE_S)
        subscriber.undeclare()
        session.put(here.topic_key("/kitrobot/stop", "std_msgs/msg/Empty"), b"\x00\x01\x00\x00\x00")
        status, out, _ = team.end()
    assert status == 130
    assert out.startswith("Stopped by a message on `/kitrobot/stop`.")


def test_the_last_message_arrives_and_then_the_node_leaves(neighbour: Any) -> None:
    endpoint, kind = free_endpoint(), "diagnostic_msgs/msg/DiagnosticArray"
    simulation = kitrobot.open_mission("follow-the-leader").simulation(seed=1, seconds=1)
    bridge = RosBridge(simulation, RosNetwork(DOMAIN, endpoint))
    session, here = neighbour(endpoint), RosNode(DOMAIN, "0", "test")
    heard: list[Any] = []
    first, last, left = Event(), Event(), Event()

    def add(sample: Any) -> None:
        heard.append(TYPES.deserialize_cdr(bytes(sample.payload), kind))
        first.set()
        if heard[-1].header.stamp.sec:
            last.set()

    def leave(sample: Any) -> None:
        if sample.kind == zenoh.SampleKind.DELETE:
            left.set()

    session.declare_subscriber(here.topic_key("/diagnostics", kind), add)
    session.liveliness().declare_subscriber(f"@ros2_lv/{DOMAIN}/*/0/0/NN/%/%/kitrobot", leave, history=True)
    # The router learns of a subscription some time after it is made.
    while not first.wait(0.05):
        bridge.publish()
    simulation.inject_fault("second", "stall")
    simulation.inject_fault("third", "fail")
    while simulation.outcome is None:
        simulation.step()
        bridge.publish()
    bridge.close()
    assert last.wait(PATIENCE_S)
    assert left.wait(PATIENCE_S)
    told = [(one.name, one.level, one.message) for one in heard[-1].status]
    assert told == [("leader", 0, "well"), ("second", 1, "stalled"), ("third", 2, "failed")]


# ---- keys


def test_keys_and_tokens_are_those_that_rmw_zenoh_documents() -> None:
    """The examples of its `docs/design.md`, but for the type, which we do not send."""
    node = RosNode(2, "aac3178e146ba6f1fc6e6a4085e77f21", "listener")
    empty, kind = "std_msgs/msg/Empty", "std_msgs::msg::dds_::Empty_"
    hashed = TYPES.hash_rihs01(empty)
    assert node.token == "@ros2_lv/2/aac3178e146ba6f1fc6e6a4085e77f21/0/0/NN/%/%/listener"
    assert node.endpoint_token(10, "MS", "/robot1/chatter", empty) == (
        f"@ros2_lv/2/aac3178e146ba6f1fc6e6a4085e77f21/0/10/MS/%/%/listener/%robot1%chatter/{kind}/{hashed}/::,10:,:,:,,"
    )
    assert node.topic_key("/robot1/chatter", empty) == f"2/robot1/chatter/{kind}/{hashed}"


def test_hashes_are_those_that_rosbags_computes() -> None:
    assert {kind: TYPES.hash_rihs01(kind) for kind in TYPE_HASHES} == {
        kind: f"RIHS01_{hashed}" for kind, hashed in TYPE_HASHES.items()
    }


def test_an_attachment_is_what_the_client_reads() -> None:
    from zenoh_ros2_sdk.attachment import Attachment

    sender = sender_id("@ros2_lv/…")
    read = Attachment.from_bytes(encode_attachment(3, 1_700_000_000_000_000_000, sender))
    assert (read.sequence_id, read.timestamp_ns, read.gid) == (3, 1_700_000_000_000_000_000, sender)
    assert sender != sender_id("@ros2_lv/another")
