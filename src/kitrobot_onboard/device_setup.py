# Adds devices that their drivers made to the robot's list.

from kitrobot_onboard.state import ACTUATORS, SENSORS


def add_sensor(robot, device, part):
    """`part`: cell, least and most."""
    robot[SENSORS].append((getattr(device, "read", device), part[0], part[1], part[2]))


def add_actuator(robot, device, part):
    """`part`: cell that says whether it is done or 0, limit in ms, place in `out`, number."""
    done = getattr(device, "done", None)
    do = getattr(device, "do")  # noqa: B009 (a small board knows no such attribute, but knows it as text)
    robot[ACTUATORS].append([device, part[0], part[1], None, 65535, part[2], part[3], do, done])
