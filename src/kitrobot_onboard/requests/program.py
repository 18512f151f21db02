# Refuses a request that needs a program where there is none.

need_program(robot)
