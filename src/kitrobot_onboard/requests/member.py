# A tick of a member of a team. Its functions are there when the program is one of a team.

from kitrobot_onboard.state import ANSWER, STEPS

take_order(robot)
if robot[STEPS]:
    robot[ANSWER] = tell_changes(robot)
