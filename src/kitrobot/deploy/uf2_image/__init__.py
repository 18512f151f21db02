"""Files that boards with a drive for UF2 take: a MicroPython of the user's with KitRobot's loop and a program in it."""
