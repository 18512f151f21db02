# Identity and state of the robot.

from kitrobot_onboard.state import ANSWER, COUNT, DATA, FAULT, LATE, NAMES, STATE

if len(robot[DATA]) != 1:
    robot[ANSWER] = 3
number = robot[FAULT][0]
if robot[STATE] != 4:
    number = 0
robot[DATA] = bytes((1, robot[STATE], number))
gc.collect()
number = 1 << 20
if hasattr(gc, "mem_free"):
    number = gc.mem_free()
robot[DATA] += struct.pack("<i", number)
number = min(robot[LATE], 65535)
robot[DATA] += struct.pack("<i", robot[COUNT]) + struct.pack("<H", number)
robot[ANSWER] = b"H" + robot[DATA] + robot[NAMES]
