"""What a robot is asked less often, a file for each request: read when it is asked; before, it takes no room.

Each has `answer(port, robot, data)`, which returns kind and payload of the answer; or 0 for done, or the number of N
that says why not. `robot` is the list of `kitrobot_onboard.state`. They are small: a small board compiles them while a
program runs.
"""

ASKED = {
    "h": "hello",
    "s": "start",
    "n": "next",
    "f": "force",
    "v": "variable",
    "w": "watch",
    "i": "identify",
    "l": "last",
    "C": "commands",
    "T": "report",
}
"""Request → file; C is the answer to `n`, made after the tick, and T what `w` begins."""
