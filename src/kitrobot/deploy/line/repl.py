"""The raw REPL of a MicroPython board, entered from any state that the board may be in.

Bytes may be lost or garbled, and small boards buffer no more than 64 of them: so a command has at most 60 bytes, its
answer is awaited, and it is sent again when none arrives intact. A command may therefore arrive twice or changed, so
no command here can do harm: file access goes through the receiver, whose messages have checksums.

A board whose program never comes back to its loop hears nothing; for a moment when its power comes on it does
(`kitrobot_onboard.krboot`). So a board that sent nothing is called without a pause, and the sender of the command
learns that a reset is wanted (`resets`).
"""

from __future__ import annotations

from collections.abc import Callable

from kitrobot.deploy.errors import SilentError
from kitrobot.deploy.line.line import MOST, Line
from kitrobot.deploy.line.retry_timer import RetryTimer
from kitrobot.text.sentences import Sentence

LONGEST = 60
"""Bytes of a command, with its end."""

_BANNER = b"raw REPL; CTRL-B to exit\r\n>"
_TRIES = 6
_ENTERING_S = 0.7
"""How long the prompt is waited for at first."""

_SILENT_S = 10.0
_RESET_S = 5.0
_RELEASE_S = 0.2
_MUTE_S = 3.0
"""Without a byte for so long a board needs a reset."""
RESET_S = 30.0
"""A person needs so long, at most, to read that and to press the button; once more when the first time was in vain."""
_CALL_S = 0.1
"""So often it is called meanwhile: less than the moment in which it hears that."""
_INTO_RAW = b"\r\x03\x03\r\x01"


class GarbledError(Exception):
    """What came back is no answer to what was sent."""


class RawRepl:
    """The raw REPL at the other end of a line."""

    def __init__(self, line: Line, resets: Callable[[], None] = lambda: None) -> None:
        self.line = line
        self.resets = resets
        """Is called once when the board needs a reset."""

        self.answered = False
        """Whether there ever was an answer."""

        self.pace_s = 0.0
        """Seconds that the board, and the way to it, needed for a soft reset: a measure for all else."""

    def enter(self) -> None:
        """Stops what runs, and begins with an empty memory, without `main.py`.

        Raises:
            SilentError: there is no MicroPython that answers.
        """
        patience = RetryTimer(self.line.now, _ENTERING_S, _SILENT_S, most_s=_SILENT_S)
        quiet_s = 0.1
        heard_at = self.line.now()
        while wait := patience.wait():
            self.line.write(b"\r\x03\x03")
            heard = self.line.drain(quiet_s)
            self.line.write(b"\r\x01")
            quiet_s = min(2 * quiet_s, 0.5)
            if not heard and self.line.now() - heard_at > _MUTE_S:
                self.resets()
                patience = RetryTimer(self.line.now, _ENTERING_S, RESET_S, most_s=_SILENT_S)
                found = self._call(patience)
            else:
                found = self.line.read_until(_BANNER, wait)
            if heard or found:
                heard_at = self.line.now()
            if not found.endswith(_BANNER):
                continue
            self.answered = True
            patience.heard()
            # A soft reset from here leaves `main.py` out.
            began = self.line.now()
            self.line.write(b"\x04")
            if self._was_reset(max(_RESET_S, 3 * wait)):
                self.pace_s = self.line.now() - began
                return
        raise SilentError(
            Sentence("no MicroPython answers on `{address}`", self.line.address),
            Sentence(
                "press the board's reset button and try again; a board that never had MicroPython needs it "
                "first, from micropython.org"
            ),
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
            wait_s = max(timeout_s if patient else min(timeout_s, 0.5 * 2**attempt), 2 * self.pace_s)
            answer = self.line.read_until(b"\x04>", wait_s)
            text, _, error = answer.removeprefix(b"OK").removesuffix(b"\x04>").partition(b"\x04")
            if answer.startswith(b"OK") and answer.endswith(b"\x04>"):
                if not error:
                    return text.decode(errors="replace").replace("\r\n", "\n")
            else:
                self.again()
        if error:
            raise GarbledError(error.decode(errors="replace"))
        raise SilentError(
            Sentence("the board on `{address}` stopped answering", self.line.address), Sentence("run the command again")
        )

    def leave(self) -> None:
        """Restarts the board's Python, which starts `main.py`."""
        self.line.write(b"\r\x02")
        self.line.read_until(b">>> ", 1)
        self.line.write(b"\x04")

    def release(self) -> None:
        """Leaves the board as after a reset, whatever it does; no answer is waited for."""
        for word in (b"\r\x03\x03", b"\r\x02"):
            self.line.write(word)
            self.line.drain(_RELEASE_S, _RELEASE_S)
        self.line.write(b"\x04")

    def again(self) -> None:
        """Back to an empty line of the raw REPL, whatever is half said."""
        self.line.write(b"\r\x03")
        self.line.drain(0.1)
        self.line.write(b"\r\x01")
        self._ends(_BANNER, max(2.0, 4 * self.pace_s))

    def _call(self, patience: RetryTimer) -> bytes:
        """Calls a mute board without a pause until its prompt answers; empty when patience ends.

        What it says before (it was just switched on) is no reason to call less: the moment in which it hears is short.
        """
        heard = b""
        while patience.left() > 0:
            self.line.write(_INTO_RAW)
            heard = heard[1 - len(_BANNER) :] + self.line.drain(_CALL_S, _CALL_S)
            if _BANNER in heard:
                self.line.drain(0.3)  # answers to the calls before
                return _BANNER
        return b""

    def _was_reset(self, timeout_s: float) -> bool:
        """Whether the board says so, behind prompts that it gave before."""
        until = self.line.now() + timeout_s
        data = b""
        while (left := until - self.line.now()) > 0 and len(data) < MOST:
            data += self.line.read(left)
            at = data.find(b"reboot")
            if at >= 0 and _BANNER in data[at:]:
                return True
        return False

    def _ends(self, end: bytes, timeout_s: float) -> bool:
        return self.line.read_until(end, timeout_s).endswith(end)
