# The last fault. Its device is a list (an actuator), a tuple (a sensor), or text when it could not be made.

from kitrobot_onboard.state import ANSWER, DATA, FAULT

if robot[DATA]:
    robot[ANSWER] = 3
number, count, device, at = robot[FAULT]
if number in (0, 3, 6):
    text = ""
if number == 2:
    text = "not done"
at = 65535
if isinstance(device, tuple):
    device = "s%d " % device[1]
if isinstance(device, list):
    at = device[4]
    device = "a%d " % device[6]
text = (device or "") + text
robot[DATA] = bytes((number, at & 255, at >> 8)) + struct.pack("<i", count)
robot[ANSWER] = b"F" + robot[DATA] + bytes(text[:60], "utf8")
device = text = None
