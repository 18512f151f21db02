# Making the drivers of a program's devices, at power-on: thrown away afterwards, like `program`.

LIMIT_S = 30


def equip(robot, devices):
    """Fills a robot with its devices. `devices` is a list of words for each, as a program file has them.

    Returns a text when a driver is missing or cannot be made: which device, and why.
    """
    kinds = []
    counts = [0, 0]
    for words in devices:
        sensor = words[0] == "s"
        n = counts[sensor]
        counts[sensor] += 1
        given = 5 if sensor else 4
        settings = dict([word.split("=", 1) for word in words[given:]])
        try:
            driver = robot.port.driver(words[1]).make(settings)
        except MemoryError:
            raise
        except Exception as error:
            return words[0] + str(n) + " " + words[1] + " " + repr(error)
        if sensor:
            robot.sensors.append((driver, int(words[2]), int(words[3]), int(words[4])))
            continue
        robot.actuators.append((driver, 0 if words[2] == "-" else int(words[2])))
        robot.limits.append(int(float(settings.get("limit", LIMIT_S)) * 1000))
        robot.since.append(None)
        if words[3] != "-":
            for word in words[3].split(","):
                name, count = word.split("/")
                later = count[-1] == "+"
                robot.procedures.append(name)
                kinds.append(2 * int(count[:-1] if later else count) + later)
    robot.kinds = bytes(kinds)
    return ""
