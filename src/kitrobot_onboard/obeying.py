# Doing what a request says, and answering it.

from kitrobot_onboard.acting import stop
from kitrobot_onboard.hearing import asked
from kitrobot_onboard.link import wrap
from kitrobot_onboard.perform import perform
from kitrobot_onboard.reaction import react
from kitrobot_onboard.state import CODE, FAILED, FAULT, GONE, LAST, REPLY, STATE, STEPS


def obey(port, robot, request):
    """Does what a request (kind, number, payload) says, and answers."""
    kind, number, data = request
    robot[LAST] = None
    why = 0
    if kind in "xq":
        stop(robot)
        robot[GONE] = kind == "q"
    elif kind in "snfvw" and not robot[CODE]:
        why = 6 if robot[FAULT][0] == 3 else 1
    elif kind != "p":
        try:
            for step in "wT" if kind == "w" else kind if kind != "n" else "nC" if robot[STATE] == 2 else "nsC":
                if step == "s":
                    stop(robot)
                elif step == "C":
                    robot[STEPS] = True
                    react(port, robot)
                space = {"wrap": wrap}
                perform(asked(port, step), space)
                why = 5 if robot[FAILED] else space["answer"](port, robot, data)
                if why:
                    break
                if kind == "n":
                    data = b"\2"
        except MemoryError:
            why = 6
        except Exception:  # its file is gone
            why = 4
    if isinstance(why, int):
        why = ("N", bytes((why,))) if why else ("K", b"")
    robot[REPLY] = wrap(why[0], number, why[1])
    port.write(robot[REPLY])
    robot[LAST] = request[:2]
