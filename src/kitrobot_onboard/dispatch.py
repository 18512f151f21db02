# Executes a request and answers it.

from kitrobot_onboard.actuation import stop
from kitrobot_onboard.link import wrap
from kitrobot_onboard.reaction import react
from kitrobot_onboard.state import ANSWER, DATA, GONE, KIND, LAST, REPLY, REQUESTS, SPACE, STEPS, TIDY, WRITE


def dispatch_request(robot, request):
    """Executes a request (kind, number, payload), and answers it.

    Rare requests are in a file: pieces of Python, each behind the letter of its request and its size, which are run in
    their order until one of them has the answer.
    """
    kind, number, robot[DATA] = request
    robot[LAST] = None
    try:
        told = 0
        if kind in "xq":
            stop(robot)
            robot[GONE] = kind == "q"
        elif kind != "p":
            robot[KIND] = kind
            robot[ANSWER] = None
            file = open(robot[REQUESTS])
            while robot[ANSWER] is None:
                robot[TIDY]()
                head = file.read(4)
                text = file.read(int(head[1:]))
                if head[0] in robot[KIND]:
                    exec(text, robot[SPACE])
                steps = robot[STEPS]
                if steps and steps > 1:  # not done by the piece itself: a small board's stack ends soon
                    robot[STEPS] = 1
                    (react if steps == 2 else stop)(robot)
            told = robot[ANSWER]
    except MemoryError:
        told = 6
    except Exception:  # no such request, or its file is gone
        told = 4
    if isinstance(told, int):
        told = bytes((78, told)) if told else b"K"
    robot[TIDY]()
    robot[REPLY] = wrap(chr(told[0]), number, told[1:])
    robot[WRITE](robot[REPLY])
    robot[LAST] = request[:2]
