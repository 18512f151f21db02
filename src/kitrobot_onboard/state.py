# The indices of the list that holds a robot's state, which the functions of the other modules share. A list, because an
# attribute costs a small board several times as much, in each place where it is used; in what is installed on a board
# these names are replaced by numbers, and this file is left out.

# What `tick` takes, in its order.
CODE = 0
CELLS = 1
THREADS = 2
PARS = 3
OUT = 4
SEEN = 5  # what ran; empty: not recorded

# The clock and the line, from the port.
TICKS = 6  # milliseconds that begin anew some day
DIFF = 7  # how much later the first is than the second
ADD = 8
READ = 9  # what came over the line, waiting for it at most so many ms
WRITE = 10  # says bytes; how many still wait, where a line that is not read can hold them up

# The rest of the program file.
SENSORS = 11  # (read, cell, least, most) for each
# [driver, done cell or 0, limit in ms, when it began what takes longer or None, its instruction, place in `out`,
# number, the driver's `do`, and its `done` or None]
ACTUATORS = 12
PROCEDURES = 13  # names of all commands
KINDS = 14  # for each command, twice the number of its arguments, and 1 more when it completes later
PERIOD = 15  # of a tick, in ms
FIRST = 16  # first values of the cells that change
INPUTS = 17  # how many
VISIBLE = 18  # the fault flag, inputs and variables: how many cells these are
NAMES = 19  # the end of H
REQUESTS = 20  # the file of the requests that are read on demand
SPACE = 21  # the globals of these requests
STATE = 22  # 0 no program, 1 ready, 2 running, 3 ended, 4 fault

# How it goes.
FORCED = 23  # cells of inputs that are held
FAULT = 24  # number, tick, device or None, exception: the last one
FAILED = 25  # one that was not reported yet, or None
COUNT = 26  # ticks
LATE = 27
STEPS = 28  # step by step: no tick is due; 2: one is, now; 3: all are to be stopped, now
HELD = 29
DUE = 30  # when the next tick is
WHO = 31  # the device that is at work
GONE = 32  # leave to the prompt

# The link.
REST = 33  # what was heard and not read yet
HEARD = 34  # when the last request was answered, and later by what was held up since (`LOOK_MS`)
LAST = 35  # kind and number of the last request
REPLY = 36  # its answer
KIND = 37  # of the request that is being answered; letters of the pieces that belong to it
DATA = 38  # its payload
ANSWER = 39  # its answer: kind and payload; 0 for done; the number of N that says why not; or None

# Whoever watches.
REPORTS = 40  # functions that are called in each gap with the ms that are left, and return how many are left then
EVERY = 41  # ms between two T
SINCE = 42  # when the last was sent
SENT = 43  # what was reported: the place of each slot, the value of each cell
SPOT = 44  # which of those to look at next
NEWS = 45  # records that wait
SHOWN = 46  # it shows itself

TIDY = 47  # makes the room that is free hang together

SENTTEAM = 48  # of a member of a team: the numbers that were sent to its host last

TENDS = 49  # (an actuator, what its driver does at each trip of the loop) for each driver that has `tend`

LENGTH = 50  # of the list
