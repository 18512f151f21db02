# Keeps inputs that are held within what they can be.

from kitrobot_onboard.state import ACTUATORS, CELLS, KIND, SENSORS, TOLD

for device in robot[SENSORS]:
    number = device[1]
    at = min(device[3], robot[CELLS][number])
    robot[CELLS][number] = max(device[2], at)
for device in robot[ACTUATORS]:
    number = device[1]
    if number and robot[CELLS][number]:
        robot[CELLS][number] = 1
if robot[KIND] == "f":
    robot[TOLD] = 0
