# What a robot knows, by its place in the list that the functions of the other modules share. A list,
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
FAULT = 16  # number, instruction, tick, text
FORCED = 17  # cell: value
STEPS = 18  # step by step: no tick is due
HELD = 19
DUE = 20  # when the next tick is

WANT = 21  # the number of an `n` that waits for its answer
GONE = 22  # leave to the prompt
FAILED = 23  # number, instruction and text of a fault that was not told yet, or None

# The link.
REST = 24  # what was heard and not read yet
HEARD = 25  # when the last whole frame came
LAST = 26  # kind and number of the last request
REPLY = 27  # its answer
SHOWN = 28  # it shows itself
NAMES = 29  # the end of H

# Whoever watches.
EVERY = 30  # ms between two T; 0: nobody watches
TOLD = 31  # when the last was sent
SENT = 32  # what was told: where each slot stands, each cell's value
SPOT = 33  # which of those to look at next
NEWS = 34  # records that wait
SEEN = 35  # what ran
TELL = 36  # the function that tells news, for as long as somebody watches
