# Back to the program's first instruction; after `n`, for a tick on request.

from kitrobot_onboard.state import (
    ANSWER,
    CELLS,
    COUNT,
    DATA,
    DUE,
    FAILED,
    FAULT,
    FIRST,
    HELD,
    INPUTS,
    KIND,
    LATE,
    NEWS,
    PARS,
    SEEN,
    SENT,
    SPOT,
    STATE,
    STEPS,
    THREADS,
    TICKS,
)

if robot[KIND] == "s" and robot[DATA] not in (b"\0", b"\1", b"\2"):
    robot[ANSWER] = 3
robot[STEPS] = 3  # all devices are stopped now
if robot[FAILED]:
    robot[ANSWER] = 5
at = robot[INPUTS]
for number in robot[FIRST]:
    at += 1
    robot[CELLS][at] = number
robot[CELLS][0] = 0
for number in range(0, len(robot[THREADS]), 2):
    robot[THREADS][number] = -1
    robot[THREADS][number + 1] = 0
at = robot[PARS]
robot[THREADS][0] = at[5]
number = 4 + 4 * at[0]
for count in range(at[1]):
    at[number] = 0
    number += 5
for count in range(at[2]):
    at[number] = 0
    number += 3
robot[NEWS] = b""  # everything is reported anew
robot[SPOT] = 0
for number in range(len(robot[SENT] or b"")):
    robot[SENT][number] = -2
for number in range(len(robot[SEEN])):
    robot[SEEN][number] = 0
robot[FAULT] = 0, 0, None, None
robot[COUNT] = robot[LATE] = 0
robot[STATE] = 2
robot[STEPS] = robot[KIND] != "s" or robot[DATA] == b"\2"
robot[HELD] = False
robot[DUE] = robot[TICKS]()
if robot[KIND] == "s":
    robot[HELD] = robot[DATA] != b"\0"
    robot[ANSWER] = 0
