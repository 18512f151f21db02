# The loop of a robot: in each tick sample the inputs, run the program, give its commands to the devices; in the gap
# until the next one report changes and serve the link (docs/reference/link.md). An error of a driver stops the devices,
# never the link.
#
# The smallest board has 9 kB for everything, and a stack for five nested calls. So a robot's state is in a list (see
# `state`); functions are short, because compiling one takes six times its text; and the code of rare requests is read
# from a file on demand (see `requests`).

from kitrobot_onboard.actuation import fail, stop
from kitrobot_onboard.dispatch import dispatch_request
from kitrobot_onboard.reaction import react
from kitrobot_onboard.receive import receive_request
from kitrobot_onboard.state import (
    ADD,
    DIFF,
    DUE,
    FAILED,
    FAULT,
    GONE,
    HEARD,
    HELD,
    LATE,
    PERIOD,
    REPORTS,
    STATE,
    STEPS,
    TENDS,
    TICKS,
    WHO,
)

GAP_MS = 50  # the longest wait when no tick is due
HOLD_MS = 800  # a held run ends when no whole frame came for so long, not counting what a request takes
LOOK_MS = 200  # of what passes between two looks at the line no more counts: frames may have come and wait to be read


def run(robot):
    """Runs until the prompt is requested. `robot`: what the program file made."""
    last = robot[TICKS]()
    while not robot[GONE]:
        try:
            left = GAP_MS
            if robot[STATE] == 2 and not robot[STEPS]:
                left = robot[DIFF](robot[DUE], robot[TICKS]())
                if left <= 0:
                    react(robot)
                    robot[DUE] = robot[ADD](robot[DUE], robot[PERIOD])
                    left = robot[DIFF](robot[DUE], robot[TICKS]())
                    if left < 0:
                        robot[DUE] = robot[TICKS]()
                        robot[LATE] += 1
                        left = 0
            for robot[WHO], tend in robot[TENDS]:
                tend()
            robot[WHO] = None
            now = robot[TICKS]()
            if robot[DIFF](now, last) > LOOK_MS:
                robot[HEARD] = robot[ADD](robot[HEARD], robot[DIFF](now, last) - LOOK_MS)
            last = now
            if robot[HELD] and robot[DIFF](now, robot[HEARD]) > HOLD_MS:
                fail(robot, 6, None)
            if robot[FAILED]:
                stop(robot)
                robot[FAULT] = robot[FAILED]
                robot[FAILED] = None
                robot[STATE] = 4
                dispatch_request(robot, ("l", 0, b""))
            else:
                for tell in robot[REPORTS]:
                    left = tell(robot, left)
                request = receive_request(robot, left)
                if request:
                    dispatch_request(robot, request)
                    robot[HEARD] = last = robot[TICKS]()
        except Exception as error:
            fail(robot, 1, error)
    stop(robot)
