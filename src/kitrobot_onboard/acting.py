# What a robot does after a tick: its actuators get their commands; and how they are stopped.

from kitrobot_onboard.state import ACTUATORS, FAILED, HELD, KINDS, OUT, PARS, PROCEDURES, STATE


def act(port, robot):
    """Hands each actuator its command."""
    out = robot[OUT]
    n = at = 0
    try:
        for part in robot[ACTUATORS]:
            if out[at]:
                part[4] = out[at + 1]
                kind = robot[KINDS][out[at + 2]]
                part[3] = port.ticks() if kind % 2 else None
                part[0].do(robot[PROCEDURES].split(",")[out[at + 2]], out[at + 3 : at + 3 + kind // 2])
            at += robot[PARS][3]
            n += 1
    except MemoryError:
        robot[FAILED] = 3, part[4], ""
    except Exception as error:
        robot[FAILED] = 1, part[4], "a%d %r" % (n, error)


def stop(robot):
    """Stops every device, whatever one of them says to it, and the program."""
    n = 0
    for part in robot[ACTUATORS]:
        part[3] = None
        try:
            part[0].stop()
        except Exception as error:
            robot[FAILED] = robot[FAILED] or (1, 65535, "a%d %r" % (n, error))
        n += 1
    robot[HELD] = False
    if robot[STATE]:
        robot[STATE] = 1
