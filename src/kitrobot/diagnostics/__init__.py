"""Diagnostics: how KitRobot reports mistakes."""

from kitrobot.diagnostics.model import (
    ArcName,
    Diagnostic,
    Fix,
    FixKind,
    KitRobotError,
    Place,
    Rule,
    Severity,
    Source,
    in_reading_order,
    rule,
    rules,
)
from kitrobot.diagnostics.problems import ProblemsError, with_help, written_out
from kitrobot.diagnostics.read_files import (
    OutputPlaceError,
    expect_output,
    expect_outputs,
    note_read,
    recording_reads,
)
from kitrobot.diagnostics.regular import expect_regular, lock_handle, named_file, open_regular
from kitrobot.diagnostics.renderer import render, render_one, to_json, to_page_json

__all__ = [
    "ArcName",
    "Diagnostic",
    "Fix",
    "FixKind",
    "KitRobotError",
    "OutputPlaceError",
    "Place",
    "ProblemsError",
    "Rule",
    "Severity",
    "Source",
    "expect_output",
    "expect_outputs",
    "expect_regular",
    "in_reading_order",
    "lock_handle",
    "named_file",
    "note_read",
    "open_regular",
    "recording_reads",
    "render",
    "render_one",
    "rule",
    "rules",
    "to_json",
    "to_page_json",
    "with_help",
    "written_out",
]
