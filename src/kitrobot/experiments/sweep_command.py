"""The command line that makes a study."""

from __future__ import annotations

import shlex

from kitrobot.experiments.plan import StudyRequest


def sweep_command(file: str, request: StudyRequest, folder: str = "") -> str:
    """`kitrobot sweep …` for a shell of POSIX; `folder` is where the study goes, where that is not the usual place."""
    words = ["kitrobot", "sweep", file]
    for address, values in request.vary:
        words += ["--vary", f"{address}={values}"]
    words += ["--seeds", request.seeds]
    for measure in request.measures:
        words += ["--measure", measure]
    if request.seconds != StudyRequest.seconds:
        words += ["--seconds", f"{request.seconds:g}"]
    if request.fail_rate:
        words += ["--fail-rate", f"{request.fail_rate:g}"]
    if request.is_zip:
        words.append("--zip")
    return shlex.join([*words, "-o", folder] if folder else words)


def resume_command(folder: str) -> str:
    """The command that goes on with a study."""
    return shlex.join(["kitrobot", "sweep", folder, "--resume"])
