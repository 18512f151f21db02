# main.py on a board, which never changes: it does what the program file says that `krboot` chose. It is short, because
# it stays in memory as long as the robot runs.
#
# A program file (docs/reference/link.md) is pieces of Python behind their sizes, each compiled, run and forgotten by
# itself, since a small board has no room for more; the last one ends this. When a device fails, `where` names it, and
# the loop will tell; when something else does, Python says why, and the prompt is free.

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
