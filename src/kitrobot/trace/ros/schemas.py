"""The types of the messages in an MCAP file, written as ROS 2 writes them (`.msg`), each with those that it contains.

Names and fields of the standard packages are theirs, so that a reader takes them for the types that it knows. What
ROS 2 has no type for is in `kitrobot_msgs`: any reader of MCAP learns it from the file.
"""

from __future__ import annotations

from typing import Final

_LINE: Final = "=" * 80

_DEFINITIONS: Final = {
    "builtin_interfaces/msg/Time": "int32 sec\nuint32 nanosec\n",
    "std_msgs/msg/Header": "builtin_interfaces/Time stamp\nstring frame_id\n",
    "std_msgs/msg/Float64": "float64 data\n",
    "std_msgs/msg/String": "string data\n",
    "geometry_msgs/msg/Vector3": "float64 x\nfloat64 y\nfloat64 z\n",
    "geometry_msgs/msg/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n",
    "geometry_msgs/msg/Transform": "Vector3 translation\nQuaternion rotation\n",
    "geometry_msgs/msg/TransformStamped": "std_msgs/Header header\nstring child_frame_id\nTransform transform\n",
    "tf2_msgs/msg/TFMessage": "geometry_msgs/TransformStamped[] transforms\n",
    "rcl_interfaces/msg/Log": (
        "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\n"
        "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\n"
        "string file\nstring function\nuint32 line\n"
    ),
    "kitrobot_msgs/msg/Command": (
        "builtin_interfaces/Time stamp\nstring actuator\nstring procedure\nint32[] arguments\n"
    ),
    "kitrobot_msgs/msg/Event": "builtin_interfaces/Time stamp\nstring kind\nstring agent\nstring cause\nstring text\n",
}

_CONTENTS: Final = {
    "tf2_msgs/msg/TFMessage": (
        "geometry_msgs/msg/TransformStamped",
        "std_msgs/msg/Header",
        "builtin_interfaces/msg/Time",
        "geometry_msgs/msg/Transform",
        "geometry_msgs/msg/Vector3",
        "geometry_msgs/msg/Quaternion",
    ),
    "rcl_interfaces/msg/Log": ("builtin_interfaces/msg/Time",),
    "kitrobot_msgs/msg/Command": ("builtin_interfaces/msg/Time",),
    "kitrobot_msgs/msg/Event": ("builtin_interfaces/msg/Time",),
}
"""Of each type that a file names, the types inside it, to any depth."""

WARN, INFO = 30, 20
"""Levels of a `rcl_interfaces/msg/Log`."""


def schema_text(name: str) -> str:
    """The definition of a type and of all that is in it, as an MCAP schema of the encoding `ros2msg`."""
    inner = (f"{_LINE}\nMSG: {one.replace('/msg/', '/')}\n{_DEFINITIONS[one]}" for one in _CONTENTS.get(name, ()))
    return "".join([_DEFINITIONS[name], *inner])
