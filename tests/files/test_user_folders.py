"""Where the user's folders are on each platform, as docs/install.md says."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.user_folders import cache_folder, config_folder, state_folder

HOME = Path("/home/ada")


@pytest.fixture(autouse=True)
def ada(monkeypatch: pytest.MonkeyPatch) -> None:
    """Somebody whose environment names no folder."""
    for what in ("KITROBOT_CONFIG", "KITROBOT_STATE", "KITROBOT_CACHE", "APPDATA", "LOCALAPPDATA"):
        monkeypatch.delenv(what, raising=False)
    for what in ("CONFIG", "STATE", "CACHE"):
        monkeypatch.delenv(f"XDG_{what}_HOME", raising=False)
    monkeypatch.setattr(Path, "home", lambda: HOME)


@pytest.mark.parametrize(
    ("platform", "folders"),
    [
        ("linux", (".config/kitrobot", ".local/state/kitrobot", ".cache/kitrobot")),
        ("darwin", (*["Library/Application Support/kitrobot"] * 2, "Library/Caches/kitrobot")),
        ("win32", ("AppData/Roaming/kitrobot", "AppData/Local/kitrobot", "AppData/Local/kitrobot/cache")),
    ],
)
def test_each_platform_has_its_usual_places(
    monkeypatch: pytest.MonkeyPatch, platform: str, folders: tuple[str, ...]
) -> None:
    monkeypatch.setattr("sys.platform", platform)
    assert (config_folder(), state_folder(), cache_folder()) == tuple(HOME / one for one in folders)


@pytest.mark.parametrize(
    ("platform", "variables"),
    [
        ("linux", ("XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")),
        ("win32", ("APPDATA", "LOCALAPPDATA", "LOCALAPPDATA")),
    ],
)
def test_what_the_platform_says_counts_more_and_what_kitrobot_is_told_most(
    monkeypatch: pytest.MonkeyPatch, platform: str, variables: tuple[str, ...]
) -> None:
    monkeypatch.setattr("sys.platform", platform)
    for variable in variables:
        monkeypatch.setenv(variable, f"/says/{variable}")
    for found, variable in zip((config_folder(), state_folder(), cache_folder()), variables, strict=True):
        assert found.is_relative_to(f"/says/{variable}/kitrobot")
    for what in ("CONFIG", "STATE", "CACHE"):
        monkeypatch.setenv(f"KITROBOT_{what}", f"/told/{what}")
    told = (Path("/told/CONFIG"), Path("/told/STATE"), Path("/told/CACHE"))
    assert (config_folder(), state_folder(), cache_folder()) == told
