# Starts or ends the news.

from kitrobot_onboard.state import ANSWER, CODE, DATA, EVERY, KIND, NEWS, PARS, REPORTS, SEEN, SENT, SPOT, VISIBLE

if len(robot[DATA]) != 2:
    robot[ANSWER] = 3
if robot[EVERY]:
    robot[REPORTS].remove(tell_news)
robot[SEEN] = robot[SENT] = robot[NEWS] = b""
robot[SPOT] = robot[EVERY] = 0
if robot[DATA] == b"\0\0":
    robot[ANSWER] = 0
number = robot[PARS][0] + robot[VISIBLE]
robot[SENT] = [-2] * number
number = len(robot[CODE]) // 4
gc.collect()
if not hasattr(gc, "mem_free") or gc.mem_free() > number + 2000:  # what ran is told where there is room for it
    robot[SEEN] = bytearray(number)
robot[KIND] = "T"
