# Sets a variable.

from kitrobot_onboard.state import ANSWER, CELLS, DATA, INPUTS, VISIBLE

if len(robot[DATA]) != 5:
    robot[ANSWER] = 3
number = robot[DATA][0]
if not robot[INPUTS] < number < robot[VISIBLE]:
    robot[ANSWER] = 2
robot[CELLS][number] = struct.unpack("<i", robot[DATA][1:])[0]
robot[ANSWER] = 0
