"""KitRobot among the programs of a Linux desktop: its entry in the menu, its icon, and `.krt` as files that it opens.

Three files below the user's data folder, as the XDG specifications name them; nothing else of the system is changed.
The entry begins the studio in a terminal, so that closing its window ends the studio.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import make_folder, write_atomic
from kitrobot.text.sentences import Sentence
from kitrobot.translation.languages import ENGLISH, LANGUAGES
from kitrobot.translation.reader_language import override_language, translate

COMMENT = Sentence("Draw programs for small robots, and run them")
MISSION = Sentence("KitRobot mission")
KIND = "application/x-kitrobot+xml"
_SIGN = Path(__file__).parent / "shipped" / "kitrobot.svg"
_TEMPORARY = ("archive-v0", "environments-v2", ".cache", "_pipx")
"""Folders of programs that were only fetched for one use, by uv and pipx."""


class DesktopError(KitRobotError):
    """There is no place for an entry, or it cannot be written."""


@dataclass(frozen=True)
class DesktopFiles:
    """Where the three files are."""

    entry: Path
    icon: Path
    kind: Path

    @property
    def all(self) -> tuple[Path, ...]:
        """All of them."""
        return self.entry, self.icon, self.kind


def desktop_files() -> DesktopFiles:
    """Where they are for this user, there or not.

    Raises:
        DesktopError: this system has no such entries.
    """
    if sys.platform in ("win32", "darwin"):
        raise DesktopError(
            Sentence("KitRobot makes entries in the menus of Linux desktops only"),
            Sentence("on this system make a shortcut to {command}", f"`{' '.join(_command())}`"),
        )
    data = os.environ.get("XDG_DATA_HOME", "")
    # As the specification says: a path that is not absolute does not count.
    folder = Path(data) if Path(data).is_absolute() else Path.home() / ".local" / "share"
    return DesktopFiles(
        folder / "applications" / "kitrobot.desktop",
        folder / "icons" / "hicolor" / "scalable" / "apps" / "kitrobot.svg",
        folder / "mime" / "packages" / "kitrobot.xml",
    )


def install_entry(missions: Path) -> DesktopFiles:
    """Writes the entry, whose studio opens the folder `missions`; the folder is made if it is not there.

    Raises:
        DesktopError: this system has none, or this KitRobot goes away by itself.
        FileError: a file cannot be written.
    """
    files = desktop_files()
    if set(Path(sys.prefix).parts) & set(_TEMPORARY):
        raise DesktopError(
            Sentence("this KitRobot was only fetched for one use: an entry would soon lead nowhere"),
            Sentence(
                "install it first, with {one} or {other}", "`pipx install kitrobot`", "`uv tool install kitrobot`"
            ),
        )
    missions = missions.absolute()
    for folder in (missions, *(file.parent for file in files.all)):
        make_folder(folder)
    write_atomic(files.icon, _SIGN.read_bytes())
    write_atomic(files.kind, _kind().encode())
    write_atomic(files.entry, _entry(missions).encode())
    _notify_desktop(files)
    return files


def remove_entry() -> tuple[Path, ...]:
    """Takes away what `install_entry` wrote; the files that were there. Missions stay.

    Raises:
        DesktopError: this system has none, or a file cannot be taken away.
    """
    files = desktop_files()
    there = tuple(file for file in files.all if os.path.lexists(file))
    for file in there:
        try:
            file.unlink()
        except OSError as error:
            raise DesktopError(
                Sentence("`{file}` could not be removed: {reason}", file, error.strerror or str(error))
            ) from None
    if there:
        _notify_desktop(files)
    return there


def _command() -> list[str]:
    """What begins this very KitRobot."""
    script = Path(sys.executable).with_name("kitrobot.exe" if sys.platform == "win32" else "kitrobot")
    return [str(script)] if script.is_file() else [sys.executable, "-m", "kitrobot"]


def _entry(missions: Path) -> str:
    command = " ".join(map(_quoted, _command()))
    lines = [
        "[Desktop Entry]",
        "Type=Application",
        "Version=1.5",
        "Name=KitRobot",
        *_localised("Comment", COMMENT),
        f"Exec={_escaped(command)} %f",
        f"Path={_escaped(str(missions))}",
        "Icon=kitrobot",
        "Terminal=true",
        "Categories=Education;Development;Robotics;",
        f"MimeType={KIND};",
    ]
    return "\n".join(lines) + "\n"


def _kind() -> str:
    comments = "".join(
        f"<comment{'' if language == ENGLISH else f' xml:lang={chr(34)}{language}{chr(34)}'}>{words}</comment>\n    "
        for language, words in _in_each_language(MISSION)
    )
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="{KIND}">
    {comments}<sub-class-of type="application/xml"/>
    <glob pattern="*.krt"/>
  </mime-type>
</mime-info>
"""


def _localised(key: str, sentence: Sentence) -> list[str]:
    return [
        f"{key}={words}" if language == ENGLISH else f"{key}[{language}]={words}"
        for language, words in _in_each_language(sentence)
    ]


def _in_each_language(sentence: Sentence) -> list[tuple[str, str]]:
    found = []
    for language in LANGUAGES:
        with override_language(language):
            found.append((language, translate(sentence)))
    return found


def _quoted(argument: str) -> str:
    """One argument of `Exec`: in quotes, what means something there behind a backslash, `%` twice."""
    for character in '\\"`$':
        argument = argument.replace(character, f"\\{character}")
    return '"' + argument.replace("%", "%%") + '"'


def _escaped(value: str) -> str:
    """A value of the file: one line."""
    return value.replace("\\", "\\\\").replace("\n", "\\n").replace("\r", "\\r").replace("\t", "\\t")


def _notify_desktop(files: DesktopFiles) -> None:
    """Desktops that keep lists of all this have them made anew; where the programs for that are missing nothing is."""
    for program, folder in (
        ("update-mime-database", files.kind.parents[1]),
        ("update-desktop-database", files.entry.parent),
    ):
        found = shutil.which(program)
        if found is not None:
            with suppress(OSError, subprocess.SubprocessError):
                subprocess.run([found, str(folder)], capture_output=True, check=False, timeout=20)
