# What needs a program is refused where there is none.

need_program(robot)
