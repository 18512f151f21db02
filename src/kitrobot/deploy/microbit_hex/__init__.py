"""Files that a micro:bit takes from its drive: MicroPython, KitRobot's loop and a program in one universal hex."""
