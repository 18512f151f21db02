"""What a robot is asked less often, a file for each request: read when it is asked; before, it takes no room.

They are scripts: each statement is a piece that is compiled, run and forgotten by itself, because a small board does it
while a program runs. They know `robot`, the list of `kitrobot_onboard.state`, the functions of the loop, `gc` and
`struct`. The first
that sets TOLD, kind and payload of the answer, is the last that is run.
"""

ASKED = {
    "h": ("hello",),
    "w": ("program", "watch"),
    "T": ("report",),
    "l": ("last",),
    "f": ("program", "force", "clamp"),
    "v": ("program", "variable"),
    "n": ("program", "next", "clamp", "again"),
    "s": ("program", "start"),
    "C": ("commands",),
    "i": ("identify",),
}
"""Request → scripts, in their order: a board passes over those before, so what is asked while a program runs comes
first. `n` goes on with C, and with s before it where there is need; `w` with T."""

BY_FAMILY = {"microbit": {"i": ("lights", "identify")}}
"""What is otherwise for a family of boards."""
