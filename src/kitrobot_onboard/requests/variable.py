# Sets a variable.

from kitrobot_onboard.state import CELLS, DATA, INPUTS, TOLD, VISIBLE

if len(robot[DATA]) != 5:
    robot[TOLD] = 3
number = robot[DATA][0]
if not robot[INPUTS] < number < robot[VISIBLE]:
    robot[TOLD] = 2
robot[CELLS][number] = struct.unpack("<i", robot[DATA][1:])[0]
robot[TOLD] = 0
