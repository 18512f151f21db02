"""The requests whose code is read from a file when they arrive; before, it takes no memory.

Each module is a script: each statement is a piece that is compiled, run and released by itself, because a small board
does it while a program runs. Its globals are `robot`, the list of `kitrobot_onboard.state`, the functions of the loop,
`gc` and `struct`. The first piece that sets ANSWER, kind and payload of the answer, is the last that is run.
"""

REQUESTS = {
    "m": ("member",),
    "h": ("hello",),
    "w": ("program", "watch"),
    "T": ("report",),
    "l": ("fault_text", "last"),
    "f": ("program", "force", "clamp"),
    "v": ("program", "variable"),
    "n": ("program", "next", "clamp", "again"),
    "s": ("program", "start"),
    "C": ("commands",),
    "i": ("identify",),
    "k": ("keep",),
}
"""Request → scripts, in their order: a board skips those before, so requests that arrive while a program runs come
first. `n` continues with C, and with s before it where that is needed; `w` with T. `m` is
asked at each tick of a member."""

BY_FAMILY = {"microbit": {"i": ("lights", "identify")}, "machine": {"l": ("fault_line", "last")}}
"""What differs for a family of boards."""
