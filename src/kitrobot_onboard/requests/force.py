# Forces an input to a value, or releases it.

from kitrobot_onboard.state import ANSWER, CELLS, DATA, FORCED, INPUTS, SENSORS

if len(robot[DATA]) != 6:
    robot[ANSWER] = 3
number = robot[DATA][0]
if not 0 < number <= robot[INPUTS]:
    robot[ANSWER] = 2
if number in robot[FORCED]:
    robot[FORCED].remove(number)
    for device in robot[SENSORS]:
        if device[1] == number:
            robot[CELLS][number] = device[0]()
if robot[DATA][1]:
    robot[FORCED].append(number)
    robot[CELLS][number] = struct.unpack("<i", robot[DATA][2:])[0]
