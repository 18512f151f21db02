"""The boot records on a board: two lines, of which the newer one says what starts, and the files that a line needs.

`kr0` and `kr1` hold a line each, `GENERATION INTERPRETER PROGRAM PSUM SUM` (docs/reference/link.md); the larger
generation whose sums fit counts. Files are named by their content and name one another in it, so what a line needs can
be found by reading.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from kitrobot.deploy.package.content_names import DIGITS, MODULE, PROGRAM
from kitrobot_onboard.link import checksum

SLOTS = ("kr0", "kr1")
MAIN = "main.py"
TRIAL = "krt"
"""The file that is there as long as a generation is on trial: once it was started, the generation and a line feed."""
UNTRIED = b"-"
"""What is in it before."""

LAST_GENERATION = 65535
"""The board has two bytes for it."""

_GENERATION = re.compile(r"[0-9]{1,5}")
_SUM = re.compile(r"[0-9a-f]{4}")
_OURS = re.compile(rf"({MODULE}[0-9a-f]{{{DIGITS}}}\.py|{PROGRAM}[0-9a-f]{{{DIGITS}}})")
_NAMED = re.compile(rf"\b{MODULE}[0-9a-f]{{{DIGITS}}}\b")


@dataclass(frozen=True)
class StartLine:
    """One line: what to start, as the how-manieth installation; `sum` is that of the program file."""

    generation: int
    module: str
    program: str
    sum: int

    def to_bytes(self) -> bytes:
        """The file."""
        text = f"{self.generation} {self.module} {self.program} {self.sum:04x} "
        return f"{text}{checksum(text.encode()):04x}\n".encode()

    @property
    def files(self) -> list[str]:
        """The files that it names."""
        return [f"{self.module}.py", self.program]


def read_line(data: bytes) -> StartLine | None:
    """The line of a file; None when it is not whole."""
    words = data.decode("ascii", errors="replace").split(" ")
    if len(words) != 5 or not _GENERATION.fullmatch(words[0]) or not _SUM.fullmatch(words[3]):
        return None
    line = StartLine(int(words[0]), words[1], words[2], int(words[3], 16))
    return line if line.to_bytes() == data else None


def newest(lines: dict[str, StartLine]) -> tuple[str, StartLine] | None:
    """Slot and line of what starts; None when nothing does."""
    return max(lines.items(), key=lambda item: item[1].generation, default=None)


def tried_generation(data: bytes) -> int | None:
    """The generation that a board started on trial and that nobody confirmed, by what is in `krt`; None for none."""
    text = data.decode("ascii", errors="replace")
    return int(text) if text.endswith("\n") and _GENERATION.fullmatch(text[:-1]) else None


def is_ours(name: str) -> bool:
    """Whether a file's name is one that only we give."""
    return _OURS.fullmatch(name) is not None


def needed(files: Iterable[str], content: Callable[[str], bytes | None]) -> set[str]:
    """Those files and all that they name, and so on; `content` gives what is in one, None when it is not there."""
    found: set[str] = set()
    left = list(files)
    while left:
        name = left.pop()
        if name in found:
            continue
        found.add(name)
        data = content(name)
        if data is not None:
            left += [f"{module}.py" for module in _NAMED.findall(data.decode("latin-1"))]
    return found
