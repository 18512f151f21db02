# Starts the news (see `telling`).

from kitrobot_onboard.state import DATA, EVERY, SINCE, TELL, TICKS, TOLD

robot[SINCE] = robot[TICKS]()
robot[EVERY] = struct.unpack("<H", robot[DATA])[0]
robot[TELL].append(tell_news)
robot[TOLD] = 0
