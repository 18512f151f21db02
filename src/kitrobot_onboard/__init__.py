"""What is copied to a robot: the interpreter and the reading of images.

Written in the part of Python that CPython, MicroPython 1.9 and (for `tick`) Numba all accept. Imports nothing
of KitRobot.
"""
