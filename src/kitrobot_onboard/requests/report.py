# Starts the news (see `reports`).

from kitrobot_onboard.state import ANSWER, DATA, EVERY, REPORTS, SINCE, TICKS

robot[SINCE] = robot[TICKS]()
robot[EVERY] = struct.unpack("<H", robot[DATA])[0]
robot[REPORTS].append(tell_news)
robot[ANSWER] = 0
