"""Write the previews that ship: what each example, and each choice of a new mission, does in its first seconds.

    python -m tools.previews --write    makes those that are missing and drops those that nothing needs
    python -m tools.previews            exit with 1 when the file lacks one

A preview is known by what its mission says, so an example that was changed has none until it is made again.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.folder import EXAMPLE
from kitrobot.live.studio import Studio
from kitrobot.workspace.example_list import shipped_examples
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.new_mission_choices import PREVIEW_S
from kitrobot.workspace.previews import (
    MOST_S,
    SHIPPED_PREVIEWS,
    Hand,
    key_of,
    make_preview,
    preview_text,
    read_previews,
)

Wanted = tuple[OpenMission, float, Sequence[Hand]]


def wanted(studio: Studio) -> Iterator[Wanted]:
    """What previews are asked for by the gallery and by a new mission."""
    listed = shipped_examples().examples
    for entry in studio.gallery.entries(studio):
        if entry.example is not None:
            example = listed.get(entry.path.removeprefix(EXAMPLE))
            yield _opened(studio, entry.path), MOST_S, () if example is None else example.hands
    choices = studio.choices
    for robot_set in choices.robot_sets:
        for place in choices.places_of(robot_set):
            for starter in choices.starters_of(robot_set, place):
                yield studio.open(choices.begin(robot_set.name, place, starter), ""), PREVIEW_S, ()


def _opened(studio: Studio, path: str) -> OpenMission:
    data, _ = studio.folder.read(path)
    return studio.read(data, path, path)


def text(studio: Studio, known: dict[str, str]) -> str:
    """The file as it should be; what is known already is not made again."""
    lines: dict[str, str] = {}
    for opened, seconds, hands in wanted(studio):
        key = key_of(opened, seconds, hands)
        try:
            lines[key] = known.get(key) or preview_text(make_preview(opened, seconds, hands))
        except KitRobotError as error:
            print(f"{opened.name}: {error}", file=sys.stderr)
    return "".join(f"{key} {line}\n" for key, line in sorted(lines.items()))


def main(arguments: Sequence[str]) -> int:
    """Writes the file, or says what it lacks."""
    with tempfile.TemporaryDirectory() as folder:
        studio = Studio(Path(folder), None)
        known = read_previews(SHIPPED_PREVIEWS)
        if "--write" in arguments:
            SHIPPED_PREVIEWS.write_text(text(studio, known), encoding="utf-8")
            return 0
        missing = [
            opened.name for opened, seconds, hands in wanted(studio) if key_of(opened, seconds, hands) not in known
        ]
    for name in missing:
        print(f"no preview of {name}: python -m tools.previews --write")
    return 1 if missing else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
