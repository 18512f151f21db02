# One device of a robot, from its line in the program file.

from kitrobot_onboard.perform import perform
from kitrobot_onboard.state import ACTUATORS, KINDS, PROCEDURES, SENSORS

LIMIT_S = 30


def device(port, robot, words, given):
    """Adds a device to a robot: the words of its line, of which the first `given` are no settings."""
    settings = dict([word.split("=", 1) for word in words[given:]])
    if given == 5:
        settings["min"], settings["max"] = words[3:5]
    if hasattr(port, "driver"):
        make = port.driver(words[1])
    else:
        space = {}
        file = open(words[1] + ".py")
        perform(file.read(), space)
        file.close()
        make = space["make"]
    driver = make(settings)
    if given == 5:
        robot[SENSORS].append((driver.read, int(words[2]), int(words[3]), int(words[4])))
    else:
        limit = int(float(settings.get("limit", LIMIT_S)) * 1000)
        robot[ACTUATORS].append([driver, 0 if words[2] == "-" else int(words[2]), limit, None, 65535])


def commands(robot, text):
    """Adds the commands of an actuator."""
    for word in text.split(",") if text != "-" else ():
        name, count = word.split("/")
        later = count[-1] == "+"
        robot[PROCEDURES] += name + ","
        robot[KINDS] += bytes((2 * int(count[:-1] if later else count) + later,))
