"""What commands print, in the pages of docs: a block behind `<!-- prints: COMMAND -->` is that command's output.

`python -m tools.command_outputs` names the blocks that no longer say what the command prints, `--write` puts today's
in their place. The commands run in an empty folder with the examples and the files of `FILES`, those of all pages one
after another. A pipe to `head N` or to `lines A-B` keeps a part of the output, one to `shown` has the command stand
above it; long lines of JSON are broken. What a clock decides is compared as "some number" and stays as it stands, so
that a page changes only when something else did.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from pathlib import Path

from kitrobot.cli.app import main as kitrobot

ROOT = Path(__file__).resolve().parents[1]
PAGES = ("docs/cli.md", "docs/fastest-program.md", "docs/second-spare.md", "docs/how-sure.md")
WIDTH = 118
BLOCK = re.compile(r"(<!-- prints: (?P<command>.+?) -->\n```\w*\n)(?P<output>.*?)(?=^```$)", re.DOTALL | re.MULTILINE)
CLOCK = re.compile(r'("real_seconds": |"speed": |real time +)[\d.]+')
LINE_FOLLOWER = """*[!(LeftEye.IsGreen() | RightEye.IsGreen())](
  [LeftEye.IsBlue()](LeftWheel.Forward({slow}); RightWheel.Forward({fast});)!(
    [RightEye.IsBlue()](LeftWheel.Forward({fast}); RightWheel.Forward({slow});)!(
      LeftWheel.Forward({fast}); RightWheel.Forward({fast});
    );
  );
);
LeftWheel.Stop();
RightWheel.Stop();
"""
FILES = {
    "p.lll": "*[Run.IsTrue()](\n  Wheel.Advnce(50);\n);\n",
    "ann.lll": LINE_FOLLOWER.format(slow=10, fast=60),
    "bo.lll": LINE_FOLLOWER.format(slow=12, fast=61),
    "cem.lll": LINE_FOLLOWER.format(slow=10, fast=100),
}
RECORDED = "run examples/transport/transport.krt --trace ring.krtrace"
ONE_PROCESS = " --jobs 1"
"""Of a command that is shown: what nobody types, as it changes nothing but the time."""
SLOWER = ('<set name="speed">50</set>', '<set name="speed">30</set>')


@contextlib.contextmanager
def prepared() -> Iterator[Path]:
    """The folder in which the commands of the pages run."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "examples").symlink_to(ROOT / "examples", target_is_directory=True)
        for file, text in FILES.items():
            (folder / file).write_text(text, encoding="utf-8")
        mission = (ROOT / "examples" / "transport" / "transport.krt").read_text(encoding="utf-8")
        assert SLOWER[0] in mission
        (folder / "slower.krt").write_text(mission.replace(*SLOWER), encoding="utf-8")
        _run(RECORDED, folder)
        yield folder


def printed(command: str, folder: Path) -> str:
    """What a page shows of a command: `kitrobot …`, with `| head N`, `| lines A-B` or `| shown` behind it."""
    words, _, part = command.partition(" | ")
    lines = _run(words.removeprefix("kitrobot "), folder).splitlines()
    kind, _, number = part.partition(" ")
    if kind == "head":
        lines = lines[: int(number)]
    elif kind == "lines":
        first, _, last = number.partition("-")
        lines = lines[int(first) - 1 : int(last)]
    elif kind == "shown":
        line = f"$ {words}".replace(ONE_PROCESS, "")
        lines = [*" \\\n".join(textwrap.wrap(line, WIDTH - 2, subsequent_indent="      ")).split("\n"), *lines]
    return "".join(f"{broken}\n" for line in lines for broken in _broken(line))


def updated(page: str, folder: Path) -> str:
    """The text of a page with the outputs of today."""

    def today(found: re.Match[str]) -> str:
        output = printed(found["command"], folder)
        same = CLOCK.sub(r"\1#", output) == CLOCK.sub(r"\1#", found["output"])
        return found[0] if same else found[1] + output

    return BLOCK.sub(today, page)


def stale() -> dict[str, str]:
    """The pages that do not show what is printed today, each with the text that does."""
    with prepared() as folder:
        today = {name: updated(_read(name), folder) for name in PAGES}
    return {name: text for name, text in today.items() if text != _read(name)}


def _run(arguments: str, folder: Path) -> str:
    """What a command prints, called in this process: to start one for each takes longer than what most of them do."""
    out, before = io.TextIOWrapper(io.BytesIO(), "utf-8"), Path.cwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.TextIOWrapper(io.BytesIO(), "utf-8")):
            with contextlib.suppress(SystemExit):
                kitrobot(shlex.split(arguments))
            out.flush()
    finally:
        os.chdir(before)
    return out.buffer.getvalue().decode()


def _broken(line: str) -> list[str]:
    if not line.startswith("{"):
        return [line]
    return textwrap.wrap(line, WIDTH, subsequent_indent=" ", break_long_words=False, break_on_hyphens=False)


def _read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def main() -> int:
    """The command line; 1 when a page is stale."""
    if sys.argv[1:] not in ([], ["--write"]):
        print(__doc__)
        return 2
    write = "--write" in sys.argv
    found = stale()
    for name, text in found.items():
        print(name)
        if write:
            (ROOT / name).write_text(text, encoding="utf-8")
    return int(bool(found) and not write)


if __name__ == "__main__":
    sys.exit(main())
