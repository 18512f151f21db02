"""The folder of a static site: the same bytes twice, and a sentence where a part of it is missing."""

from __future__ import annotations

import io
import json
import lzma
import re
import tarfile
import zipfile
import zlib
from pathlib import Path

import pytest

from kitrobot import __version__
from kitrobot.packaging.site import PAGE, POLICY, expect_site, make_site
from kitrobot.packaging.site_packer import packed
from kitrobot.packaging.site_parts import PYODIDE, WHEEL_TAGS, SiteError
from kitrobot.server.first_missions import first_missions
from kitrobot.server.security import CONTENT_POLICY
from kitrobot.translation.catalogue import Catalogue, catalogue
from kitrobot.translation.languages import LANGUAGES, TRANSLATED
from tests.effort import THOROUGH
from tests.sites import made_site, quickly_packed
from tools.site_parts import PARTS, ROOT

MOST_OF_PYTHON = 6_650_000 if THOROUGH else 7_930_000
"""Bytes that Python may be as it lies in the folder, so that what is too much is noticed: as it is shipped, and as it
is packed here (`tests.sites`)."""


MOST_OF_WORDS = 110_000
"""Bytes of the sentences of one language, which come once somebody reads it."""


def pyodide_of(version: str, folder: Path) -> Path:
    """A folder that says it is Pyodide."""
    package = folder / "node_modules" / "pyodide"
    package.mkdir(parents=True)
    (package / "package.json").write_text(json.dumps({"name": "pyodide", "version": version}))
    return folder


def refused(folder: Path, *parts: Path, page: Path = PAGE) -> SiteError:
    with pytest.raises(SiteError) as found:
        make_site(folder, parts, page)
    return found.value


def test_a_folder_with_something_in_it_and_a_file_are_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    assert "something in the folder" in refused(tmp_path).message
    assert "is a file" in refused(tmp_path / "mine.txt").message
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


def test_without_the_built_page_it_says_how_to_build_it(tmp_path: Path) -> None:
    assert "tools/page.py build" in refused(tmp_path / "site", page=tmp_path).help


def test_without_pyodide_or_with_another_it_says_how_to_get_it(tmp_path: Path) -> None:
    missing = refused(tmp_path / "site", tmp_path)
    assert missing.message == "Pyodide is not here: the Python that runs in a page"
    assert f"kitrobot_site_parts-{__version__}" in missing.help
    other = refused(tmp_path / "site", pyodide_of("0.1.0", tmp_path / "old"))
    assert other.message == f"Pyodide 0.1.0 is here, and {PYODIDE} is needed"
    assert not (tmp_path / "site").exists()


@pytest.mark.site
def test_without_the_wheel_it_says_how_to_get_it(tmp_path: Path) -> None:
    missing = refused(tmp_path / "site", ROOT / "web")
    assert "pydantic_core-" in missing.message
    assert f"kitrobot_site_parts-{__version__}" in missing.help


@pytest.mark.site
def test_with_the_wheel_of_another_pydantic_core_it_says_which_one_belongs_to_it(tmp_path: Path) -> None:
    (tmp_path / f"pydantic_core-2.0.1-{WHEEL_TAGS}.whl").touch()
    assert "pip install pydantic_core==2.0.1" in refused(tmp_path / "site", ROOT / "web", tmp_path).help


def test_the_page_of_a_site_is_as_strict_as_that_of_the_server() -> None:
    assert f"{POLICY}; frame-ancestors 'none'" == CONTENT_POLICY


@pytest.mark.site
@pytest.mark.thorough("test_the_folder_is_whole_and_no_order_date_or_owner_of_the_machine_is_in_it")
def test_the_same_sources_make_the_same_bytes(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    one = tmp_path / "deeper" / "one"
    made = make_site(one, [ROOT / "web", PARTS], first=first_missions())
    files = files_in(one)
    assert files == files_in(made_site(tmp_path_factory.getbasetemp()))
    assert len(files) == made.files
    assert sum(map(len, files.values())) == made.size


def test_what_is_packed_is_small_the_same_each_time_and_unpacked_to_the_same() -> None:
    data = b"".join(path.read_bytes() for path in sorted(Path(__file__).parent.glob("*.py")))
    small = packed(data)
    assert small == packed(data)
    assert lzma.decompress(small) == lzma.decompress(quickly_packed(data)) == data
    assert len(small) < len(quickly_packed(data)) < len(data) / 2


def files_in(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.site
def test_the_folder_is_whole_and_no_order_date_or_owner_of_the_machine_is_in_it(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    files = files_in(made_site(tmp_path_factory.getbasetemp()))
    for name, data in files.items():
        assert not name.endswith(".packed") or data.startswith(b"\xfd7zXZ\0"), name
    with tarfile.open(fileobj=io.BytesIO(files["python.packed"]), mode="r:xz") as archive:
        entries = archive.getmembers()
        exercises = [archive.extractfile(one) for one in entries if one.name.endswith(".exercise.xml")]
        texts = [one.read() for one in exercises if one is not None]
    assert not any(one.name.endswith(".po") for one in entries)
    assert len(texts) == 12
    assert not any(b"hidden" in one for one in texts)
    assert [one.name for one in entries] == sorted(one.name for one in entries)
    assert {(one.mtime, one.uid, one.gid, one.uname, one.gname, one.mode) for one in entries} == {
        (0, 0, 0, "", "", 0o644)
    }
    with zipfile.ZipFile(io.BytesIO(lzma.decompress(files["pyodide/python_stdlib.zip.packed"]))) as library:
        assert library.namelist() == sorted(library.namelist())
        assert {one.date_time for one in library.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    page = files["index.html"].decode()
    assert POLICY in page
    assert re.findall(r"(?:src|href)=\"(?!\./)[^\"]*\"", page) == [], "an address that depends on the place"
    worker = files["service-worker.js"].decode()
    assert "@" not in worker
    listed = set(json.loads(re.search(r"FILES = (\[.*\]);", worker)[1]))  # type: ignore[index]
    assert listed == files.keys() - {"service-worker.js"}
    told = json.loads(files["site.json"])
    assert len(told["page"]) > 50
    assert set(told["page"]) < files.keys()
    assert {name: len(files[name]) for name in told["files"]} == told["files"]
    assert [name.partition(".")[0] for name in told["libraries"]] == ["pydantic_core/_pydantic_core"]
    for language in LANGUAGES:
        first = json.loads(files[f"first/{language}.json"])
        assert first["path"] == "example:transport/transport.krt"
        assert first["mission"]["programs"][0]["vertices"]
        assert not re.search(rb"/(tmp|home|root|work)/", files[f"first/{language}.json"])
    assert list(told["words"]) == list(TRANSLATED)
    for language, name in told["words"].items():
        words = Catalogue(zlib.decompress(files[f"words/{language}.po.zlib"]).decode())
        assert name == f"kitrobot/translation/{language}.po"
        assert words.entries == catalogue(language).entries
        assert len(files[f"words/{language}.po.zlib"]) < MOST_OF_WORDS
    for library in told["libraries"].values():
        assert lzma.decompress(files[f"{library}.packed"]).startswith(b"\0asm")
    assert sum(told["files"].values()) < MOST_OF_PYTHON


def site_in(folder: Path, **told: object) -> Path:
    """A folder that says of itself that it is a site, with one file."""
    folder.mkdir()
    (folder / "python.packed").write_bytes(b"12345")
    said = {"kitrobot": __version__, "files": {"python.packed": 5}} | told
    (folder / "site.json").write_text(json.dumps(said))
    return folder


def test_a_site_of_this_kitrobot_is_one(tmp_path: Path) -> None:
    expect_site(site_in(tmp_path / "site"))


@pytest.mark.parametrize(
    ("told", "message"),
    [
        ({"kitrobot": "0.0.1"}, "is from KitRobot 0.0.1, and this is"),
        ({"files": {"python.packed": 6}}, "are missing or cut off"),
        ({"files": {"python.packed": 5, "pyodide/pyodide.mjs": 5}}, "are missing or cut off"),
        ({"files": ["python.packed"]}, "there is no site of KitRobot"),
    ],
    ids=["another version", "cut off", "a file is missing", "another form"],
)
def test_a_folder_that_cannot_serve_as_a_site_says_why(tmp_path: Path, told: dict[str, object], message: str) -> None:
    folder = site_in(tmp_path / "site", **told)
    with pytest.raises(SiteError) as found:
        expect_site(folder)
    assert message in found.value.message
    assert "kitrobot site" in found.value.help


@pytest.mark.parametrize(
    "data", [None, b"", b"{", b"[]", b"3", b"{}", b"\xff", b"[" * 100_000], ids=lambda data: str(data)[:8]
)
def test_what_is_no_site_says_so(tmp_path: Path, data: bytes | None) -> None:
    if data is not None:
        (tmp_path / "site.json").write_bytes(data)
    with pytest.raises(SiteError, match="there is no site of KitRobot"):
        expect_site(tmp_path)
