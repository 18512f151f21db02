# What a robot senses before a tick: its sensors, and whether its actuators are done.

from kitrobot_onboard.state import ACTUATORS, CELLS, FAILED, FORCED, SENSORS, STEPS


def sense(port, robot):
    """Samples every input once."""
    cells = robot[CELLS]
    forced = robot[FORCED]
    instruction = 65535
    where = "s%d "
    n = 0
    try:
        for read, at, least, most in robot[SENSORS]:
            value = forced[at] if at in forced else read()
            cells[at] = least if value < least else most if value > most else value
            n += 1
        where = "a%d "
        n = 0
        for part in robot[ACTUATORS]:
            if part[3] is not None:
                instruction = part[4]
                if part[0].done():
                    part[3] = None
                elif not robot[STEPS] and port.diff(port.ticks(), part[3]) > part[2]:
                    robot[FAILED] = 2, instruction, where % n + "not done"
            at = part[1]
            if at:
                cells[at] = (1 if forced[at] else 0) if at in forced else 1 if part[3] is None else 0
            n += 1
    except MemoryError:
        robot[FAILED] = 3, instruction, ""
    except Exception as error:
        robot[FAILED] = 1, instruction, where % n + repr(error)
