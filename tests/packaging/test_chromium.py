"""The browser of the browser tests: found, installed where that may be done, else said in one line."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools import chromium


@pytest.fixture
def programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The only folder on the PATH, still empty."""
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("KITROBOT_CHROMIUM", raising=False)
    return tmp_path


def add_program(folder: Path, name: str, text: str = "#!/bin/sh\n") -> str:
    path = folder / name
    path.write_text(text)
    path.chmod(0o755)
    return str(path)


@pytest.mark.parametrize("name", chromium.NAMES)
def test_chromium_is_found_by_each_of_its_names(programs: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    path = add_program(programs, name)
    assert chromium.main([]) == 0
    assert capsys.readouterr().out == path + "\n"


def test_the_named_one_comes_first(programs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    add_program(programs, "chromium")
    named = add_program(programs, "my-browser")
    monkeypatch.setenv("KITROBOT_CHROMIUM", named)
    assert chromium.find() == named


def test_without_chromium_the_status_is_one(programs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert chromium.main([]) == 1
    assert capsys.readouterr().out == ""


def test_where_it_may_not_be_installed_one_line_says_what_is_left_out(
    programs: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    add_program(programs, "apt-get")
    monkeypatch.setattr("os.geteuid", lambda: 1000)
    assert chromium.main(["--install"]) == 0
    assert capsys.readouterr().out == (
        "browser tests left out: no Chromium (only root may install it); install it, or name it in KITROBOT_CHROMIUM\n"
    )


def test_root_installs_it_with_apt(
    programs: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    said = programs / "said"
    add_program(programs, "apt-get", f'#!/bin/sh\necho "$@" >> {said}\n')
    monkeypatch.setattr("os.geteuid", lambda: 0)
    assert chromium.main(["--install"]) == 0
    assert capsys.readouterr().out == ""
    assert said.read_text() == (
        "--quiet update\n--quiet install --yes --no-install-recommends chromium-headless-shell fonts-noto-core\n"
    )


def test_a_failing_apt_is_told(
    programs: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    add_program(programs, "apt-get", "#!/bin/sh\nexit 100\n")
    monkeypatch.setattr("os.geteuid", lambda: 0)
    assert chromium.main(["--install"]) == 0
    assert "no Chromium (`apt-get --quiet update` failed)" in capsys.readouterr().out
