# The loop of a robot: in each tick sample the inputs, run the program, hand its commands to the devices; in the gap
# until the next one tell what changed and listen to the link (docs/reference/link.md). Whatever a driver does wrong
# stops the devices, never the link.
#
# The smallest board has 9 kB for everything, and a stack for five calls in one another. So what a robot knows is in a
# list (see `state`); functions are short, because compiling one takes six times its text; and what is asked of a robot
# less often is read from a file when it is asked (see `asked`).

from kitrobot_onboard.acting import stop
from kitrobot_onboard.hearing import hear
from kitrobot_onboard.obeying import obey
from kitrobot_onboard.reaction import react
from kitrobot_onboard.state import COUNT, DUE, EVERY, FAILED, FAULT, GONE, HEARD, HELD, LATE, PERIOD, STATE, STEPS, TELL

GAP_MS = 50  # the longest wait when no tick is due
HOLD_MS = 800  # a held run ends when no whole frame came for so long


def run(port, robot):
    """Goes on until somebody asks for the prompt. `robot` is what the steps from `start` on made."""
    while not robot[GONE]:
        try:
            left = GAP_MS
            if robot[FAILED]:
                stop(robot)
                number, instruction, text = robot[FAILED]
                robot[FAULT] = number, instruction, robot[COUNT], text[:60]
                robot[FAILED] = None
                robot[STATE] = 4
                request = "l", 0, b""
            else:
                if robot[STATE] == 2 and not robot[STEPS]:
                    left = port.diff(robot[DUE], port.ticks())
                    if left <= 0:
                        react(port, robot)
                        robot[DUE] = port.add(robot[DUE], robot[PERIOD])
                        left = port.diff(robot[DUE], port.ticks())
                        if left < 0:
                            robot[DUE] = port.ticks()
                            robot[LATE] = min(robot[LATE] + 1, 65535)
                            left = 0
                    if robot[HELD] and port.diff(port.ticks(), robot[HEARD]) > HOLD_MS:
                        robot[FAILED] = 6, 65535, ""
                    if robot[FAILED]:
                        continue
                if robot[EVERY]:
                    robot[TELL](port, robot, left)
                    if left < GAP_MS:
                        left = max(port.diff(robot[DUE], port.ticks()), 0)
                request = hear(port, robot, left)
            if request:
                obey(port, robot, request)
        except MemoryError:
            robot[FAILED] = 3, 65535, ""
    stop(robot)
