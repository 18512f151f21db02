# Making the drivers of a program's devices, at power-on: forgotten afterwards, like `program`.

from kitrobot_onboard.state import ACTUATORS, KINDS, PROCEDURES, SENSORS

LIMIT_S = 30


def equip(port, loaded):
    """Fills a robot with its devices. `loaded`: what `program.load` gave.

    Returns a text when a driver is missing or cannot be made: which device, and why.
    """
    robot, devices = loaded
    kinds = []
    counts = [0, 0]
    names = ""
    for words in devices:
        sensor = words[0] == "s"
        n = counts[sensor]
        counts[sensor] += 1
        given = 5 if sensor else 4
        settings = dict([word.split("=", 1) for word in words[given:]])
        if sensor:
            settings["min"], settings["max"] = words[3:5]
        driver = None
        try:
            if words[1] != "-":
                driver = port.driver(words[1]).make(settings)
        except MemoryError:
            raise
        except Exception as error:
            return words[0] + str(n) + " " + words[1] + " " + repr(error)
        if not sensor:
            limit = int(float(settings.get("limit", LIMIT_S)) * 1000)
            robot[ACTUATORS].append(driver and [driver, 0 if words[2] == "-" else int(words[2]), limit, None, 65535])
            if words[3] != "-":
                for word in words[3].split(","):
                    name, count = word.split("/")
                    later = count[-1] == "+"
                    names += name + ","
                    kinds.append(2 * int(count[:-1] if later else count) + later)
        elif driver:
            robot[SENSORS].append((driver.read, int(words[2]), int(words[3]), int(words[4])))
    robot[PROCEDURES] = names
    robot[KINDS] = bytes(kinds)
    return ""
