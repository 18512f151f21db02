"""Where the user's folders are on each platform, as docs/install.md says."""

from __future__ import annotations

from pathlib import Path, PurePosixPath, PureWindowsPath

import platformdirs
import pytest
from platformdirs import macos, unix, windows

from kitrobot.user_folders import cache_folder, config_folder, state_folder

HOME = "/home/ada"
ROAMING, LOCAL = r"C:\Users\ada\AppData\Roaming", r"C:\Users\ada\AppData\Local"


@pytest.fixture(autouse=True)
def ada(monkeypatch: pytest.MonkeyPatch) -> None:
    """Somebody whose environment names no folder."""
    for what in ("CONFIG", "STATE", "CACHE"):
        monkeypatch.delenv(f"KITROBOT_{what}", raising=False)
        monkeypatch.delenv(f"XDG_{what}_HOME", raising=False)
    monkeypatch.setenv("HOME", HOME)
    monkeypatch.setenv("WIN_PD_OVERRIDE_APPDATA", ROAMING)
    monkeypatch.setenv("WIN_PD_OVERRIDE_LOCAL_APPDATA", LOCAL)


@pytest.mark.parametrize(
    ("platform", "folders"),
    [
        (unix.Unix, [f"{HOME}/{one}/kitrobot" for one in (".config", ".local/state", ".cache")]),
        (macos.MacOS, [f"{HOME}/Library/{one}/kitrobot" for one in (*["Application Support"] * 2, "Caches")]),
        (windows.Windows, [rf"{ROAMING}\kitrobot", rf"{LOCAL}\kitrobot", rf"{LOCAL}\kitrobot\cache"]),
    ],
)
def test_each_platform_has_its_usual_places(monkeypatch: pytest.MonkeyPatch, platform: type, folders: list) -> None:
    monkeypatch.setattr(platformdirs, "PlatformDirs", platform)
    path = PureWindowsPath if platform is windows.Windows else PurePosixPath
    assert [path(folder()) for folder in (config_folder, state_folder, cache_folder)] == [path(one) for one in folders]


def test_what_the_platform_says_counts_more_and_what_kitrobot_is_told_most(monkeypatch: pytest.MonkeyPatch) -> None:
    names = ("CONFIG", "STATE", "CACHE")
    for what in names:
        monkeypatch.setenv(f"XDG_{what}_HOME", f"/says/{what}")
    assert [config_folder(), state_folder(), cache_folder()] == [Path(f"/says/{what}/kitrobot") for what in names]
    for what in names:
        monkeypatch.setenv(f"KITROBOT_{what}", f"/told/{what}")
    assert [config_folder(), state_folder(), cache_folder()] == [Path(f"/told/{what}") for what in names]
