# A tick on request, and its commands.

from kitrobot_onboard.state import ANSWER, CELLS, COUNT, DATA, FAILED, KINDS, OUT, PARS, STATE, STEPS

robot[STEPS] = 2
if robot[FAILED]:
    robot[ANSWER] = 5
number = 0
if robot[CELLS][0]:
    number = 1
if robot[STATE] == 3:
    number += 2
robot[DATA] = struct.pack("<i", robot[COUNT]) + bytes((number,))
for at in range(0, len(robot[OUT]), robot[PARS][3]):
    if robot[OUT][at]:
        at += 2
        number = robot[OUT][at]
        robot[DATA] += bytes((number,))
        for count in range(robot[KINDS][number] // 2):
            at += 1
            robot[DATA] += struct.pack("<i", robot[OUT][at])
robot[ANSWER] = b"C" + robot[DATA]
