# A tick of a member of a team. Its functions are there when the program is one of a team.

from kitrobot_onboard.state import STEPS, TOLD

take_order(robot)
if robot[STEPS]:
    robot[TOLD] = tell_changes(robot)
