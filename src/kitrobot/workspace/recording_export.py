"""A recording as a file of other tools, by the ending of the file's name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.files.disk import write_atomic
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.traces import is_trace, open_trace

MCAP = ".mcap"


class ExportError(KitRobotError):
    """A recording does not go into such a file, or the file that is to be exported is none."""


def is_export(source: Path, target: Path) -> bool:
    """Whether these names say that a recording is exported, or is wanted to be."""
    return is_trace(source.name) or target.suffix.lower() == MCAP


def export_recording(source: Path, target: Path, progress: Callable[[int, int], None] | None = None) -> bool:
    """Writes a recording as an MCAP file; gives whether the recording is whole.

    Args:
        source: the `.krtrace`; of one that is cut, what is there is written.
        target: the `.mcap`.
        progress: told the tick that is written, and the last one.

    Raises:
        ExportError: `source` is no recording, the ending of `target` is not `.mcap`, or a package is not there.
        TraceError: the recording is damaged.
        FileError: the file cannot be written.
    """
    if not is_trace(source.name):
        raise ExportError(
            Sentence("`{source}` is no recording, and only recordings become `{ending}` files", source, MCAP),
            Sentence("record a run: {command}", "`kitrobot run MISSION.krt --trace FILE.krtrace`"),
        )
    if target.suffix.lower() != MCAP:
        raise ExportError(
            Sentence("a recording becomes a `{ending}` file, and `{target}` has another ending", MCAP, target),
            Sentence(
                "give B the ending `{ending}`; `kitrobot {source}` opens the mission of the recording", MCAP, source
            ),
        )
    try:
        from kitrobot.trace.ros.mcap_export import mcap_bytes
    except ImportError as error:
        raise ExportError(
            Sentence("an MCAP file needs the package `{package}`", error.name),
            Sentence("install it: {command}", "`pip install kitrobot[ros]`"),
        ) from error
    expect_output(target, source)
    trace = open_trace(source)
    with trace.reader as reader:
        data = mcap_bytes(reader, progress)
        write_atomic(target, data)
        return not reader.cut
