# Stopping a robot's devices, and recording a fault.

from kitrobot_onboard.state import ACTUATORS, COUNT, FAILED, HELD, STATE, WHO


def fail(robot, number, error):
    """Records a fault, unless there is one already that was not reported."""
    if not robot[FAILED]:
        robot[FAILED] = 3 if isinstance(error, MemoryError) else number, robot[COUNT], robot[WHO], error
    robot[WHO] = None


def stop(robot):
    """Stops every device, even if one of them fails, and the program."""
    robot[HELD] = False
    if robot[STATE]:
        robot[STATE] = 1
    for part in robot[ACTUATORS]:
        part[3] = None
        try:
            part[0].stop()
        except Exception as error:
            robot[WHO] = part
            fail(robot, 1, error)
