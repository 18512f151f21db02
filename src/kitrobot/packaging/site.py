"""A folder with the whole studio in it, for any web server that only hands out files: Python runs in the page.

The folder holds the built page, Pyodide (CPython for WebAssembly), and the Python packages that the studio needs as one
archive. The same sources make the same bytes.

Left to others: where Pyodide comes from (`site_parts`), the Python packages (`site_packages`), running in a page
(`server.in_page_server`), the page's side.
"""

from __future__ import annotations

import hashlib
import io
import json
import re
import zipfile
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kitrobot import __version__
from kitrobot.packaging.site_firmware import FIRMWARE_ARCHIVE, firmware_archive
from kitrobot.packaging.site_packages import catalogues, packages
from kitrobot.packaging.site_packer import PACKED, packed
from kitrobot.packaging.site_parts import LARGE, LIBRARY, LOCK, PYTHON, RUNTIME, SiteError, find_parts
from kitrobot.packaging.site_sources import in_library, without_texts
from kitrobot.text.sentences import Sentence

_PACKAGE = Path(__file__).resolve().parent.parent
PAGE: Final = _PACKAGE / "server" / "static"
"""The built page."""
_FILES = Path(__file__).parent / "site_files"

POLICY: Final = (
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "font-src 'self'; connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'"
)
"""As the server's; what a page cannot say of itself (who may frame it) is left out."""


@dataclass(frozen=True)
class Site:
    """A site that was made: how many files, how many bytes they are, and how many of them Python is."""

    files: int
    size: int
    python: int


def make_site(
    folder: Path, parts: Iterable[Path], page: Path = PAGE, *, first: Mapping[str, bytes] = MappingProxyType({})
) -> Site:
    """Writes the site into a folder that is new or empty.

    `first`: files with the mission that it begins with, by their names: `server.first_missions` makes them.

    Raises:
        SiteError: there is something in it, or a part of the site is not there.
        OSError: it cannot be written.
    """
    _expect_empty(folder)
    index = page / "index.html"
    if not index.is_file():
        message = Sentence("the studio's page has not been built")
        raise SiteError(message, Sentence("run `python tools/page.py build`, then this command again"))
    pyodide, wheel = find_parts(parts)
    archive, libraries = packages(wheel)
    files = {f"pyodide/{name}": data for name, data in _runtime(pyodide).items()}
    large = {f"pyodide/{name}": files.pop(f"pyodide/{name}") for name in LARGE} | {"python": archive}
    files |= _packed(large | {Path(name).name: data for name, data in libraries.items()})
    python = {name: len(data) for name, data in files.items()}
    version = _digest(files).hexdigest()[:20]
    for path in sorted(page.rglob("*")):
        if path.is_file() and path.suffix not in (".br", ".gz") and not path.name.startswith("."):
            files[path.relative_to(page).as_posix()] = path.read_bytes()
    files |= first
    words = catalogues()
    files |= {f"words/{Path(name).name}.zlib": data for name, data in words.items()}
    files[FIRMWARE_ARCHIVE] = firmware_archive()
    files["index.html"] = _index(index.read_text(encoding="utf-8"))
    manifest = {
        "kitrobot": __version__,
        "version": version,
        "pyodide": "pyodide/",
        "packages": "python",
        "words": {Path(name).stem: name for name in words},
        "libraries": {name: Path(name).name for name in libraries},
        "place": f"/lib/python{PYTHON}/site-packages",
        "files": python,
        "page": sorted(name for name in files if name.startswith("assets/")),
    }
    files["site.json"] = json.dumps(manifest, indent=1, sort_keys=True).encode()
    files["service-worker.js"] = _service_worker(files)
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return Site(len(files), sum(map(len, files.values())), sum(python.values()))


def expect_site(folder: Path) -> None:
    """Expects a folder that this KitRobot wrote a site into.

    Raises:
        SiteError: there is no site, or that of another KitRobot.
    """
    shown = str(folder)
    help = Sentence("write one with `kitrobot site {folder}`", shown)
    try:
        manifest = json.loads((folder / "site.json").read_bytes())
        version = str(manifest["kitrobot"])
        sizes = {str(name): size for name, size in manifest["files"].items()}
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise SiteError(Sentence("there is no site of KitRobot in the folder `{folder}`", shown), help) from None
    if version != __version__:
        raise SiteError(
            Sentence(
                "the site in `{folder}` is from KitRobot {version}, and this is {ours}",
                shown,
                version[:40],
                __version__,
            ),
            Sentence("write a new one with `kitrobot site`, into another folder"),
        )
    if any(not (folder / name).is_file() or (folder / name).stat().st_size != size for name, size in sizes.items()):
        raise SiteError(Sentence("files of the site in `{folder}` are missing or cut off", shown), help)


def _expect_empty(folder: Path) -> None:
    if folder.is_dir():
        if next(folder.iterdir(), None) is None:
            return
        message = Sentence("there is something in the folder `{folder}` already", str(folder))
        raise SiteError(message, Sentence("name a folder that is new or empty"))
    if folder.exists():
        raise SiteError(Sentence("`{folder}` is a file, not a folder", str(folder)), Sentence("name another one"))


def _index(text: str) -> bytes:
    """The page that says where its studio is, and what it may fetch."""
    policy = f'<meta http-equiv="Content-Security-Policy" content="{POLICY}" />'
    head = text.replace("<html ", '<html data-place="page" ', 1)
    found = re.sub(r'(<meta charset="[^"]*" />)', lambda one: f"{one[0]}\n    {policy}", head, count=1)
    assert found.count(policy) == found.count('data-place="page"') == 1, "index.html has another form"
    return found.encode()


def _digest(files: dict[str, bytes]) -> hashlib._Hash:
    digest = hashlib.sha256()
    for name, data in sorted(files.items()):
        digest.update(f"{name}\0{len(data)}\0".encode() + hashlib.sha256(data).digest())
    return digest


def _service_worker(files: dict[str, bytes]) -> bytes:
    digest = _digest(files)
    text = (_FILES / "service-worker.js").read_text(encoding="utf-8")
    names = ", ".join(json.dumps(name) for name in sorted(files))
    digest.update(text.encode())
    return text.replace("@VERSION@", digest.hexdigest()[:20]).replace('"@FILES@"', names).encode()


def _packed(files: dict[str, bytes]) -> dict[str, bytes]:
    with ThreadPoolExecutor() as threads:
        return {name + PACKED: data for name, data in zip(files, threads.map(packed, files.values()), strict=True)}


def _runtime(folder: Path) -> dict[str, bytes]:
    found = {name: (folder / name).read_bytes() for name in RUNTIME}
    found[LIBRARY] = _stored(found[LIBRARY])
    lock = json.loads(found[LOCK])
    # Its packages are not here: nothing may be fetched from elsewhere.
    found[LOCK] = json.dumps({**lock, "packages": {}}, sort_keys=True).encode()
    return found


def _stored(data: bytes) -> bytes:
    """The standard library, as far as a server uses it; not compressed file by file: together they get smaller."""
    made = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(made, "w", zipfile.ZIP_STORED) as new:
        for name in sorted(filter(in_library, old.namelist())):
            data = old.read(name)
            new.writestr(zipfile.ZipInfo(name), without_texts(data) if name.endswith(".py") else data)
    return made.getvalue()
