# What a robot knows, by its place in the list that the functions of `robot`, `requests` and `report` share. A list,
# because an attribute costs a small board several times as much, in each place where it is used; and on their way to a
# board these names become numbers, and this file is left at home.

# What `start` makes of a program file.
CODE = 0
CELLS = 1
THREADS = 2
PARS = 3
OUT = 4
FIRST = 5  # first values of the cells that change
INPUTS = 6  # how many
VISIBLE = 7  # the fault flag, inputs and variables: how many cells these are
PERIOD = 8  # of a tick, in ms
SENSORS = 9  # (read, cell, least, most) for each
ACTUATORS = 10  # [driver, done cell or 0, limit in ms, when it began what takes longer or None, its instruction]
PROCEDURES = 11  # names of all commands, with commas
KINDS = 12  # for each command, twice the number of its arguments, and 1 more when it completes later

# How it goes.
STATE = 13  # 0 no program, 1 ready, 2 running, 3 ended, 4 fault
COUNT = 14  # ticks
LATE = 15
FAULT = 16  # number, instruction, tick, text as bytes
FORCED = 17  # cell: value
STEPS = 18  # step by step: no tick is due
HELD = 19
DUE = 20  # when the next tick is

# What a request asked for and the next round does.
HALT = 21
BEGIN = 22
WANT = 23  # the number of an `n` that waits for its answer
GONE = 24  # leave to the prompt

# The link.
REST = 25  # what was heard and not read yet
HEARD = 26  # when the last whole frame came
LAST = 27  # kind and number of the last request
REPLY = 28  # its answer
SHOWN = 29  # it shows itself
NAMES = 30  # the end of H

# Whoever watches.
EVERY = 31  # ms between two T; 0: nobody watches
TOLD = 32  # when the last was sent
SENT = 33  # what was told: where each slot stands, each cell's value
SPOT = 34  # which of those to look at next
NEWS = 35  # records that wait
SEEN = 36  # what ran
