"""A client of ROS 2 that is not ours: what it finds on a network and receives, as JSON; then it stops the run.

Run as a script in a process of its own: PORT DOMAIN FOLDER ROBOT COUNT. FOLDER has the definitions of messages. It
waits for so many messages of each topic, and for two diagnostics.
"""

import json
import sys
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from threading import Event
from typing import Any

from zenoh_ros2_sdk import ROS2Publisher, ROS2Subscriber
from zenoh_ros2_sdk.discovery import get_topic_info, get_topic_names_and_types
from zenoh_ros2_sdk.message_registry import get_registry
from zenoh_ros2_sdk.session import ZenohSession

LAST = "/kitrobot/stop"


def plain(value: Any) -> Any:
    """A message as plain values."""
    if is_dataclass(value):
        return {one.name: plain(getattr(value, one.name)) for one in fields(value) if one.name != "__msgtype__"}
    if isinstance(value, list):
        return [plain(one) for one in value]
    return value.tolist() if hasattr(value, "tolist") else value


def main(port: int, domain: int, folder: Path, robot: str, least: int) -> None:
    session = ZenohSession.get_instance("127.0.0.1", port)
    get_registry().messages_dir = folder
    where: dict[str, Any] = {"router_ip": "127.0.0.1", "router_port": port}
    topics: dict[str, list[str]] = {}
    while LAST not in topics or "/tf" not in topics:
        topics = dict(get_topic_names_and_types(domain, **where))
    elsewhere = get_topic_names_and_types(domain + 1, **where)
    info = get_topic_info("/tf", domain, **where, verbose=True)
    assert info is not None
    received: dict[str, list[Any]] = {name: [] for name in topics if name != LAST}
    enough = Event()

    wanted = {"/tf": least, "/diagnostics": 2, "/clock": least, f"/{robot}/odom": least, f"/{robot}/cmd_vel": least}

    def collect(name: str) -> Callable[[Any], None]:
        def add(message: Any) -> None:
            received[name].append(plain(message))
            if all(len(received[topic]) >= count for topic, count in wanted.items()):
                enough.set()

        return add

    heard = [
        ROS2Subscriber(topic=name, msg_type=topics[name][0], callback=collect(name), domain_id=domain, **where)
        for name in wanted
    ]
    strange: list[Any] = []
    heard.append(
        ROS2Subscriber(topic="/tf", msg_type=topics["/tf"][0], callback=strange.append, domain_id=domain + 1, **where)
    )
    enough.wait()
    stop = ROS2Publisher(topic=LAST, msg_type="std_msgs/msg/Empty", domain_id=domain, **where)
    stop.publish()
    for one in (stop, *heard):
        one.close()
    session.close()
    one = info.publishers[0]
    publisher = [one.node_name, one.node_namespace, one.type_hash, one.qos, info.publisher_count]
    told = {"topics": topics, "tf": publisher, "received": received, "elsewhere": [elsewhere, len(strange)]}
    sys.stdout.write(json.dumps(told))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]), sys.argv[4], int(sys.argv[5]))
