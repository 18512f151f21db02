"""Questions at the command line, while something else has to be served.

A held robot stops when it receives nothing for 0.8 s, and a person thinks longer than that. So a thread of its own
reads the line, and the caller serves the robot meanwhile.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from queue import Empty, Queue
from threading import Thread

from kitrobot.cli.output import sanitize
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

_SERVED_EVERY_S = 0.05
_AT_ONCE = 4096


class Dialogue:
    """Asks on standard error and takes answers from standard input.

    Args:
        serve: is called again and again, in the caller's thread, until the answer is there; what it raises ends the
            question.
    """

    def __init__(self, serve: Callable[[], None]) -> None:
        self._serve = serve
        self._heard = b""

    def ask(self, question: str) -> str:
        """The answer: a line, without the spaces around it.

        Raises:
            KitRobotError: the answers have ended, or what `serve` raises.
        """
        if sys.stderr is not None:
            sys.stderr.write(sanitize(question))
            sys.stderr.flush()
        line: Queue[str | BaseException] = Queue()
        # Nobody waits for it at the end: a read of a terminal cannot be called back.
        Thread(target=self._await_line, args=(line,), daemon=True).start()
        while True:
            try:
                answer = line.get(timeout=_SERVED_EVERY_S)
                break
            except Empty:
                self._serve()
        if isinstance(answer, BaseException):
            raise answer
        if not answer:
            raise KitRobotError(
                Sentence("the answers ended before all was measured"), Sentence("begin again; nothing was written")
            )
        return answer.strip()

    def _await_line(self, line: Queue[str | BaseException]) -> None:
        try:
            line.put(self._read_line())
        except BaseException as error:
            line.put(error)

    def _read_line(self) -> str:
        """The next line with its end, "" when there is no more."""
        if sys.stdin is None:
            return ""
        # Without Python's buffer: its lock, held by a read at the end of the process, is fatal then.
        raw = getattr(getattr(sys.stdin, "buffer", None), "raw", None)
        if raw is None:
            return sys.stdin.readline()
        while b"\n" not in self._heard and (piece := raw.read(_AT_ONCE)):
            self._heard += piece
        line, end, self._heard = self._heard.partition(b"\n")
        return (line + end).decode(errors="replace")
