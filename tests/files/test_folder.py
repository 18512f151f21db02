"""The missions of a folder, and the examples beside them."""

from __future__ import annotations

import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from kitrobot.files.folder import ConflictError, MissionFolder, MissionNameError, ReadOnlyError, revision_of


@pytest.fixture
def folder(tmp_path):
    """A folder with two missions, and examples below it as in a checkout."""
    for name in ("a.krt", "sub/b.krt", "examples/one/one.krt", ".hidden/c.krt", "node_modules/d.krt", "sub/e.txt"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    return MissionFolder(tmp_path, tmp_path / "examples")


def test_examples_below_the_folder_are_listed_once_as_examples(folder):
    assert [entry.path for entry in folder.missions()] == ["a.krt", "sub/b.krt", "example:one/one.krt"]


def test_a_folder_without_examples_has_only_its_own(tmp_path):
    (tmp_path / "a.krt").write_text("")
    assert [entry.path for entry in MissionFolder(tmp_path, tmp_path / "none").missions()] == ["a.krt"]


def test_a_folder_too_deep_is_not_looked_into(tmp_path):
    deep = tmp_path / "1/2/3/4/5/6"
    deep.mkdir(parents=True)
    (deep / "a.krt").write_text("")
    (deep.parent / "b.krt").write_text("")
    assert [entry.path for entry in MissionFolder(tmp_path, tmp_path / "none").missions()] == ["1/2/3/4/5/b.krt"]


def test_links_in_circles_do_not_matter(tmp_path):
    (tmp_path / "a.krt").write_text("")
    (tmp_path / "loop").symlink_to(tmp_path)
    assert len(MissionFolder(tmp_path, tmp_path / "none").missions()) == 1


def test_a_file_has_one_name_and_leads_back(folder):
    for name in ("a.krt", "sub/b.krt"):
        assert folder.name_of(folder.path_of(name)) == name
    assert folder.name_of(folder.root / "examples/one/one.krt") == "example:one/one.krt"
    with pytest.raises(MissionNameError):
        folder.name_of(folder.root.parent / "x.krt")


def test_a_save_is_let_in_only_with_the_revision_on_disk(folder):
    data, revision = folder.read("a.krt")
    assert revision == revision_of(data)
    with folder.hold("a.krt", revision) as path:
        path.write_bytes(b"new")
    with pytest.raises(ConflictError) as caught, folder.hold("a.krt", revision):
        pass
    assert caught.value.revision == revision_of(b"new")


def test_a_save_that_fails_lets_the_next_one_in(folder):
    for _ in range(2):
        with pytest.raises(ZeroDivisionError), folder.hold("a.krt", folder.read("a.krt")[1]):
            raise ZeroDivisionError
        with pytest.raises(ConflictError), folder.hold("a.krt", "wrong"):
            pass


def test_of_many_saves_at_once_with_one_revision_one_wins(folder):
    _, revision = folder.read("a.krt")
    together = threading.Barrier(8)

    def save(number: int) -> bool:
        together.wait()
        try:
            with folder.hold("a.krt", revision) as path:
                path.write_text(f"save {number}")
            return True
        except ConflictError:
            return False

    with ThreadPoolExecutor(8) as pool:
        assert sum(pool.map(save, range(8))) == 1


def test_an_example_is_read_only(folder):
    data, revision = folder.read("example:one/one.krt")
    assert data == b"examples/one/one.krt"
    with pytest.raises(ReadOnlyError):
        folder.hold("example:one/one.krt", revision)


def test_the_title_of_a_mission_is_its_name_in_words(folder):
    (folder.root / "my-first_mission.krt").write_text("")
    assert [entry.title for entry in folder.missions()][1] == "My first mission"


@pytest.mark.parametrize(
    "name", ["con.krt", "Aux.krt", "nul/a.krt", "com1.drive.krt", "LPT\u00b9.krt", "sub /b.krt", "sub./b.krt"]
)
def test_a_new_mission_has_a_name_that_windows_can_have(folder, name):
    with pytest.raises(MissionNameError, match="Windows cannot have"):
        folder.path_of(name)


@pytest.mark.parametrize("name", ["console.krt", "com10.krt", "a con.krt", "nul-1.krt", ".sub/b.krt"])
def test_names_that_only_look_like_devices_are_names(folder, name):
    assert folder.path_of(name).name == name.split("/")[-1]


@pytest.mark.skipif(sys.platform == "win32", reason="there it cannot be")
def test_a_mission_of_such_a_name_that_is_there_is_opened(folder):
    (folder.root / "con.krt").write_text("here")
    assert folder.read("con.krt")[0] == b"here"
