"""The errors for requests that a robot refuses, each a sentence with a way out."""

from __future__ import annotations

from kitrobot.deploy.errors import BoardError, NoMemoryError, SilentError
from kitrobot.text.sentences import Sentence
from kitrobot_onboard import link

_MEMORY = 6
_REFUSALS = {
    1: (Sentence("the board holds no program that can run"), Sentence("send one with `kitrobot deploy`")),
    2: (
        Sentence("the program on the board has no such variable or input"),
        Sentence("send the program again with `kitrobot deploy`"),
    ),
    3: (Sentence("the board did not understand the message"), Sentence("update it with `kitrobot deploy`")),
    4: (Sentence("the board did not understand the message"), Sentence("update it with `kitrobot deploy`")),
    5: (Sentence("the board cannot do that now"), Sentence("stop the program first")),
    6: (Sentence("the program needs more memory than the board has"), Sentence("make the program smaller")),
}


def silent(address: str) -> SilentError:
    """Nobody answers there."""
    return SilentError(
        Sentence("the board on `{address}` does not answer", address),
        Sentence("press its reset button; when it holds no KitRobot yet, send it a program with `kitrobot deploy`"),
    )


def refusal(answer: tuple[str, bytes]) -> BoardError:
    """The refusal of a robot, or an answer to another request."""
    kind, payload = answer
    why = payload[0] if kind == "N" and payload else 0
    return (NoMemoryError if why == _MEMORY else BoardError)(*_REFUSALS.get(why, _REFUSALS[3]))


def not_understood() -> BoardError:
    """The answer cannot be read by this KitRobot."""
    return BoardError(*_REFUSALS[3])


def another_version(theirs: int) -> BoardError:
    """The two ends speak different versions of the link."""
    if theirs < link.PROTOCOL:
        return BoardError(
            Sentence(
                "the board speaks version {theirs} of the link, this computer version {ours}", theirs, link.PROTOCOL
            ),
            Sentence("update the board: `kitrobot deploy`"),
        )
    return BoardError(
        Sentence(
            "the board speaks version {theirs} of the link, this computer only version {ours}", theirs, link.PROTOCOL
        ),
        Sentence("update KitRobot on this computer, or put its version onto the board with `kitrobot deploy`"),
    )
