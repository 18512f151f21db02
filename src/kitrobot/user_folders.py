"""The user's folders: for XML of their own, for what programs remember, for what can be made again.

Each is named by a variable of the environment, or is the usual one of the platform (docs/install.md).
"""

from __future__ import annotations

import os
import sys
from pathlib import Path


def config_folder() -> Path:
    """The user's robots, constructors and kits: `$KITROBOT_CONFIG`, or the platform's usual place."""
    return _given("KITROBOT_CONFIG") or _usual(
        "APPDATA", "Roaming", "Application Support", "XDG_CONFIG_HOME", ".config"
    )


def state_folder() -> Path:
    """What programs remember: `$KITROBOT_STATE`, or the platform's usual place."""
    return _given("KITROBOT_STATE") or _usual(
        "LOCALAPPDATA", "Local", "Application Support", "XDG_STATE_HOME", ".local/state"
    )


def cache_folder() -> Path:
    """What can be made again: `$KITROBOT_CACHE`, or the platform's usual place."""
    given = _given("KITROBOT_CACHE")
    if given is not None:
        return given
    usual = _usual("LOCALAPPDATA", "Local", "Caches", "XDG_CACHE_HOME", ".cache")
    return usual / "cache" if sys.platform == "win32" else usual


def _given(variable: str) -> Path | None:
    found = os.environ.get(variable)
    return Path(found) if found else None


def _usual(windows: str, app_data: str, library: str, xdg: str, linux: str) -> Path:
    """The folder of KitRobot where programs of this platform have theirs.

    Args:
        windows: the variable that names it on Windows.
        app_data: the folder of `AppData` where that is not set.
        library: the folder of `Library` on macOS.
        xdg: the variable that names it elsewhere.
        linux: the folder in the home folder where that is not set.
    """
    if sys.platform == "win32":
        return Path(os.environ.get(windows) or Path.home() / "AppData" / app_data) / "kitrobot"
    if sys.platform == "darwin":
        return Path.home() / "Library" / library / "kitrobot"
    return Path(os.environ.get(xdg) or Path.home() / linux) / "kitrobot"
