# The third step to the loop: the devices of the program's robot.

from kitrobot_onboard.device import commands, device
from kitrobot_onboard.state import FAILED


def ready(port, line, robot):
    """Gives a robot its devices."""
    if line[2] == "-" or robot[FAILED]:
        return
    actuators = sensors = 0
    text = ""
    try:
        file = open(line[2], "rb")
        file.readline()
        while True:
            words = str(file.readline(), "utf8").split()
            if not words:
                break
            if words[0] == "a":
                text = "a%d %s " % (actuators, words[1])
                actuators += 1
                device(port, robot, words, 4)
                commands(robot, words[3])
            else:
                text = "s%d %s " % (sensors, words[1])
                sensors += 1
                device(port, robot, words, 5)
        file.close()
    except MemoryError:
        robot[FAILED] = 3, 65535, ""
    except Exception as error:
        robot[FAILED] = 5, 65535, text + repr(error)
