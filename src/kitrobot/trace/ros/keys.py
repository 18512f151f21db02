"""The keys under which ROS 2 finds a topic on a Zenoh network, as `rmw_zenoh_cpp` lays them out.

A message is put under `DOMAIN/TOPIC/TYPE/HASH`, with an attachment that says who sent it and when. For each node,
publisher and subscription a liveliness token `@ros2_lv/…` is there; ROS 2 makes its graph of them. In it the QoS
`::,10:,:,:,,` is the default: reliable, volatile, the last ten. Source:
https://github.com/ros2/rmw_zenoh, `docs/design.md` and `rmw_zenoh_cpp/src/detail/attachment_helpers.cpp`, of Jazzy and
later; Humble has no hashes.
"""

from __future__ import annotations

import hashlib
import struct
from dataclasses import dataclass
from typing import Final, Literal

TYPE_HASHES: Final = {
    "diagnostic_msgs/msg/DiagnosticArray": "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e",
    "geometry_msgs/msg/Twist": "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a",
    "nav_msgs/msg/Odometry": "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0",
    "rosgraph_msgs/msg/Clock": "692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564",
    "std_msgs/msg/Empty": "20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312",
    "tf2_msgs/msg/TFMessage": "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087",
}
"""Of each type that is sent or received the hash of its definition (REP 2016, version 1)."""

MOST_DOMAIN: Final = 232
"""ROS 2 knows the domains from 0 to this one."""

STOP_TOPIC: Final = "/kitrobot/stop"
"""A message on it asks a run to end."""

_QOS: Final = "::,10:,:,:,,"
_ATTACHMENT: Final = struct.Struct("<qqB16s")


@dataclass(frozen=True, slots=True)
class RosNode:
    """A node of a ROS 2 graph, in no namespace. `session` is the number of its Zenoh session, as that writes it."""

    domain: int
    session: str
    name: str

    @property
    def token(self) -> str:
        """Its liveliness token."""
        return self._begin(0, "NN")

    def endpoint_token(self, number: int, kind: Literal["MP", "MS"], topic: str, message_type: str) -> str:
        """The liveliness token of its publisher (`MP`) or subscription (`MS`); `number` differs within the node."""
        name = topic.replace("/", "%")
        return f"{self._begin(number, kind)}/{name}/{_dds_type(message_type)}/{_type_hash(message_type)}/{_QOS}"

    def topic_key(self, topic: str, message_type: str) -> str:
        """Where messages of a topic are put."""
        return f"{self.domain}/{topic.strip('/')}/{_dds_type(message_type)}/{_type_hash(message_type)}"

    def _begin(self, number: int, kind: str) -> str:
        return f"@ros2_lv/{self.domain}/{self.session}/0/{number}/{kind}/%/%/{self.name}"


def sender_id(token: str) -> bytes:
    """The 16 bytes by which receivers tell senders apart: any that follow from the token (ROS 2 has another hash)."""
    return hashlib.blake2b(token.encode(), digest_size=16).digest()


def encode_attachment(serial: int, nanoseconds: int, sender: bytes) -> bytes:
    """What comes with a message: its number of that sender, the time, and the sender."""
    return _ATTACHMENT.pack(serial, nanoseconds, len(sender), sender)


def _dds_type(message_type: str) -> str:
    package, folder, name = message_type.split("/")
    return f"{package}::{folder}::dds_::{name}_"


def _type_hash(message_type: str) -> str:
    return f"RIHS01_{TYPE_HASHES[message_type]}"
