"""The raw REPL of a MicroPython board, from any state that the board may be in.

Bytes may be lost or garbled on the way, and small boards buffer no more than 64 of them: so a command has at most 60
bytes, is awaited, and is sent again when no whole answer comes. A command may therefore arrive twice or changed, and
nothing is said here that could do harm: what touches files goes through the receiver, whose messages are checked.
"""

from __future__ import annotations

from kitrobot.deploy.errors import SilentError
from kitrobot.deploy.line import Line

LONGEST = 60
"""Bytes of a command, with its end."""

_BANNER = b"raw REPL; CTRL-B to exit\r\n>"
_TRIES = 6
_ENTERING = (0.7, 1.0, 1.5, 2.0, 3.0)
"""Seconds that the prompt is waited for, try after try."""


class GarbledError(Exception):
    """What came back is no answer to what was sent."""


class RawRepl:
    """The raw REPL at the other end of a line."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.answered = False
        """Whether there ever was an answer."""

    def enter(self) -> None:
        """Stops what runs, and begins with an empty memory, without `main.py`.

        Raises:
            SilentError: there is no MicroPython that answers.
        """
        for attempt, patience_s in enumerate(_ENTERING):
            self.line.write(b"\r\x03\x03")
            self.line.drain(0.1 + 0.1 * attempt)
            self.line.write(b"\r\x01")
            if not self._ends(_BANNER, patience_s):
                continue
            self.answered = True
            # A soft reset from here leaves `main.py` out.
            self.line.write(b"\x04")
            answer = self.line.read_until(_BANNER, 5 + attempt)
            if b"reboot" in answer and answer.endswith(_BANNER):
                return
        raise SilentError(
            f"no MicroPython answers on `{self.line.address}`",
            "press the board's reset button and try again; a board that never had MicroPython needs it first,"
            " from micropython.org",
        )

    def run(self, command: str, timeout_s: float = 5.0, *, patient: bool = False) -> str:
        """What a harmless command prints; it may be executed more than once. `patient`: it takes long, and is not to
        be broken off.

        Raises:
            GarbledError: the answer is an error of Python each time, so it was garbled each time.
            SilentError: no answer comes.
        """
        data = command.encode() + b"\x04"
        assert len(data) <= LONGEST, command
        error = b""
        for attempt in range(_TRIES):
            self.line.write(data)
            wait_s = timeout_s if patient else min(timeout_s, 0.5 * 2**attempt)
            answer = self.line.read_until(b"\x04>", wait_s)
            text, _, error = answer.removeprefix(b"OK").removesuffix(b"\x04>").partition(b"\x04")
            if answer.startswith(b"OK") and answer.endswith(b"\x04>"):
                if not error:
                    return text.decode(errors="replace").replace("\r\n", "\n")
            else:
                self.again()
        if error:
            raise GarbledError(error.decode(errors="replace"))
        raise SilentError(f"the board on `{self.line.address}` stopped answering", "run the command again")

    def leave(self) -> None:
        """Restarts the board's Python, which starts `main.py`."""
        self.line.write(b"\r\x02")
        self.line.read_until(b">>> ", 1)
        self.line.write(b"\x04")

    def again(self) -> None:
        """Back to an empty line of the raw REPL, whatever is half said."""
        self.line.write(b"\r\x03")
        self.line.drain(0.1)
        self.line.write(b"\r\x01")
        self._ends(_BANNER, 2)

    def _ends(self, end: bytes, timeout_s: float) -> bool:
        return self.line.read_until(end, timeout_s).endswith(end)
