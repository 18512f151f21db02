# One tick of a robot, with the inputs before and the commands after it. What goes wrong is written down in FAILED.

from kitrobot_onboard.acting import act
from kitrobot_onboard.interpreter import tick
from kitrobot_onboard.sensing import sense
from kitrobot_onboard.state import CELLS, CODE, COUNT, FAILED, OUT, PARS, SEEN, STATE, THREADS


def react(port, robot):
    """One tick."""
    sense(port, robot)
    if not robot[FAILED]:
        tick(robot[CODE], robot[CELLS], robot[THREADS], robot[PARS], robot[OUT], robot[SEEN])
        robot[COUNT] += 1
        if robot[THREADS][0] < 0:
            robot[STATE] = 3
        act(port, robot)
