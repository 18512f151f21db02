"""`kitrobot site`: where it cannot write, and what is missing, in a sentence."""

from __future__ import annotations

from pathlib import Path


def test_what_is_missing_is_said_with_the_way_to_get_it(kitrobot, tmp_path: Path) -> None:
    said = kitrobot("site", str(tmp_path / "site"))
    assert said.status == 1
    assert said.err.startswith("error: Pyodide is not here")
    assert "install the wheel `kitrobot_site_parts-" in said.err
    assert "npm" not in said.err
    assert not (tmp_path / "site").exists()


def test_a_folder_with_something_in_it_is_left_alone(kitrobot, tmp_path: Path) -> None:
    full = tmp_path / "full"
    full.mkdir()
    (full / "mine.txt").write_text("mine")
    said = kitrobot("site", str(full))
    assert said.status == 1
    assert "there is something in the folder" in said.err
    assert [path.name for path in full.iterdir()] == ["mine.txt"]
