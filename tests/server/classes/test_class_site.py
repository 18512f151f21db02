"""A class with a static site: which pages and files pupils get, and how an exercise reaches the studio in a page."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest

from kitrobot.classroom.assignments import MOST_BYTES, MOST_FILES, pack
from kitrobot.classroom.class_room import ClassRoom
from kitrobot.packaging.site_parts import SiteError
from kitrobot.server.app import create_app
from kitrobot.server.classroom.app import create_class_app
from kitrobot.server.classroom.class_server import ClassSettings, serve_class
from tests.server.classes.conftest import KEY, REACH, Class
from tests.server.classes.test_class_exercises import put_own_exercise
from tests.server.conftest import TestClient

OWN = "Handed out/mine/mine.exercise.xml"
TAKES = {"exercise": OWN}


@pytest.fixture
def school(tmp_path: Path):
    static, site = tmp_path / "static", tmp_path / "site"
    for folder, title in ((static, "the page"), (site, "the site")):
        (folder / "assets").mkdir(parents=True)
        (folder / "index.html").write_text(f"<!doctype html><html><head><title>{title}</title></head></html>")
        (folder / "assets" / "both.js").write_text(f"// {title}")
    (site / "python.packed").write_bytes(b"\x1f\x8b")
    (site / "assets" / "site.js").write_text("export {};")
    room = ClassRoom(tmp_path / "Class 5b")
    app = create_class_app(room, KEY, REACH, static=static, site=site)
    yield Class(room, app)
    app.close()
    room.close()


@pytest.fixture
def page(tmp_path: Path):
    """The studio that a pupil's page has in it."""
    app = create_app(tmp_path / "in the page", None, "token")
    (tmp_path / "in the page").mkdir()
    app.state.studio.folder.in_class = True
    return TestClient(app, base_url="http://127.0.0.1", headers={"X-KitRobot-Token": "token"})


def test_pupils_get_the_page_of_the_site_and_the_teacher_the_built_one(school):
    client = school.client()
    for path in ("/", "/index.html"):
        answer = client.get(path)
        assert "the site" in answer.text
        assert '<meta name="kitrobot-class" content="pupil">' in answer.text
        assert "'wasm-unsafe-eval'" in answer.headers["content-security-policy"]
    teacher = client.get("/teacher")
    assert "the page" in teacher.text
    assert "wasm" not in teacher.headers["content-security-policy"]
    assert client.get("/assets/both.js").text == "// the page"
    for path in ("/assets/site.js", "/python.packed"):
        answer = client.get(path)
        assert answer.status_code == 200
        assert "'wasm-unsafe-eval'" in answer.headers["content-security-policy"], "a worker may compile Python"
        assert "default-src 'self'" in answer.headers["content-security-policy"]
    for path in ("/class.toml", "/..%2fclass.toml", "/python", "/assets"):
        assert client.get(path).status_code == 404


def test_no_pupil_has_a_studio_on_the_teachers_machine(school):
    ada, _ = school.join("Ada")
    for path in ("/api/session", "/api/missions", "/api/exercises", "/api/board"):
        answer = ada.get(path)
        assert answer.status_code == 403
        assert answer.json()["message"] == "The studio of a pupil is in the pupil's page."
    assert not (school.room.folder / ".studios").exists()
    assert school.teacher().get("/api/missions").status_code == 200


def test_an_exercise_of_the_teachers_own_reaches_the_studio_of_a_page(school, page):
    ada, _ = school.join("Ada")
    assert ada.get("/api/class/exercise").status_code == 204
    put_own_exercise(school)
    school.teacher().post("/api/class/teacher/exercise", json={"exercise": "mine.exercise.xml"})
    assert school.room.record.exercise == OWN
    assert school.client().get("/api/class/exercise").status_code == 403
    files = ada.get("/api/class/exercise").content
    for _ in range(2):
        assert page.put("/api/handed-out", params=TAKES, content=files).status_code == 200
    found = next(one for one in page.get("/api/exercises").json() if one["name"] == OWN)
    opened = page.get("/api/mission", params={"path": found["start"]}).json()
    assert "yard.world.xml" in {path.name for path in page.app.state.studio.folder.root.rglob("*")}
    refused = page.put(
        "/api/mission", json={"path": found["start"], "revision": opened["revision"], "mission": opened["mission"]}
    )
    assert refused.status_code == 403, "it is begun with, and never written over"


def zipped(**files: bytes) -> bytes:
    return pack({name.replace("__", "/"): data for name, data in files.items()})


def lying() -> bytes:
    """Says that it holds less than it does."""
    made = bytearray(pack({"a.xml": b"\0" * 100_000}))
    at = made.rindex(b"PK\1\2") + 24
    made[at : at + 4] = (10).to_bytes(4, "little")
    return bytes(made)


def locked() -> bytes:
    """Says that a password is needed."""
    made = bytearray(pack({"a.xml": b"<a/>"}))
    made[6] |= 1
    made[made.rindex(b"PK\1\2") + 8] |= 1
    return bytes(made)


BAD = {
    "nothing": b"",
    "no archive": b"hello" * 100,
    "cut off": zipped(a=b"x" * 1000)[:-30],
    "out of its folder": pack({"../a.xml": b"x"}),
    "a folder": pack({"a/b.xml": b"x"}),
    "another system's folder": pack({"a\\b.xml": b"x"}),
    "hidden": pack({".a": b"x"}),
    "too many": pack({f"{number}.xml": b"" for number in range(MOST_FILES + 1)}),
    "a bomb": pack({"a.xml": b"\0" * (MOST_BYTES + 1)}),
    "a lie": lying(),
    "locked": locked(),
}


@pytest.mark.parametrize("data", BAD.values(), ids=BAD.keys())
def test_what_is_no_exercise_is_refused_and_nothing_of_it_is_written(page, data):
    answer = page.put("/api/handed-out", params=TAKES, content=data)
    assert answer.status_code == 422
    assert answer.json()["message"] == "These are not the files of an exercise that a class handed out."
    root = page.app.state.studio.folder.root
    assert [path for path in root.parent.rglob("*") if path.is_file() and path.suffix == ".xml"] == []


@pytest.mark.parametrize(
    "exercise", ["mine.exercise.xml", "a/b/c.exercise.xml", "../Handed out/x/y.exercise.xml", "Handed out/x/y.krt", ""]
)
def test_an_exercise_goes_nowhere_else(page, exercise):
    files = pack({"a.xml": b"<a/>"})
    answer = page.put("/api/handed-out", params={"exercise": exercise}, content=files)
    assert answer.status_code == 403
    assert answer.json()["message"]


def test_a_studio_outside_of_a_class_takes_none(page):
    page.app.state.studio.folder.in_class = False
    answer = page.put("/api/handed-out", params=TAKES, content=pack({"a.xml": b"<a/>"}))
    assert (answer.status_code, answer.json()["message"]) == (403, "Nothing is handed out in this studio.")


def test_packed_files_are_a_plain_archive():
    with zipfile.ZipFile(io.BytesIO(pack({"a.xml": b"<a/>"}))) as archive:
        assert archive.namelist() == ["a.xml"]


def test_a_site_that_cannot_be_used_is_told_before_anything_is_opened(tmp_path):
    with pytest.raises(SiteError, match="there is no site of KitRobot"):
        serve_class(ClassSettings(tmp_path / "Class", site=tmp_path / "nowhere"))
    # In the folder of the class it is found without being named.
    (tmp_path / "Class" / "Site").mkdir(parents=True)
    with pytest.raises(SiteError, match="there is no site of KitRobot"):
        serve_class(ClassSettings(tmp_path / "Class"))
    assert [path.name for path in (tmp_path / "Class").iterdir()] == ["Site"]
