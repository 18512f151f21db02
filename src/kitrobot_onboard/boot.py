# main.py on a board, the same in all versions: it executes the program file that `krboot` chose. It is short, because
# it stays in memory as long as the robot runs.
#
# A program file (docs/reference/link.md) is pieces of Python behind their sizes, each compiled, run and released by
# itself, since a small board has no memory for more; the last one ends the loop below. When a device fails, `where`
# identifies it, and the robot's loop reports the fault; any other exception is printed, and the prompt is free.

import gc

from kitrobot_onboard.state import FAILED

exec(open("krboot.py").read())
gc.collect()  # so that what stays lies close together
if program:
    file = open(program, "rb")
    where = 0
    while file:
        gc.collect()
        try:
            exec(file.read(int(file.read(4))))
        except Exception as error:
            if not where:
                raise
            robot[FAILED] = robot[FAILED] or (3 if isinstance(error, MemoryError) else 5, 0, where, error)
    run(robot)
