# Forces inputs, before a tick on request.

from kitrobot_onboard.state import ANSWER, CELLS, DATA, FORCED, INPUTS

if len(robot[DATA]) % 5:
    robot[ANSWER] = 3
for at in range(0, len(robot[DATA]), 5):
    number = robot[DATA][at]
    if not 0 < number <= robot[INPUTS]:
        robot[ANSWER] = 2
for at in range(0, len(robot[DATA]), 5):
    number = robot[DATA][at]
    at = robot[DATA][at + 1 : at + 5]
    robot[CELLS][number] = struct.unpack("<i", at)[0]
    if number not in robot[FORCED]:
        robot[FORCED].append(number)
