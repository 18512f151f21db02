"""Find the Chromium that the browser tests drive; with `--install`, install it where that is possible.

    python -m tools.chromium              print its path; status 1 if there is none
    python -m tools.chromium --install    install it with apt if this is root's Debian, else say what is left out

Never a browser downloaded by a test tool: the one of the system, or the one that KITROBOT_CHROMIUM names.
"""

from __future__ import annotations

import os
import shutil
import sys

from tools import debian

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
PACKAGES = ("chromium-headless-shell", "fonts-noto-core")

# For Playwright's `args`: as root there is no sandbox, and a test's browser has no business outside this machine.
FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)


def find() -> str | None:
    """The path of a Chromium, or None."""
    named = os.environ.get("KITROBOT_CHROMIUM")
    if named:
        return shutil.which(named)
    return next((path for path in map(shutil.which, NAMES) if path), None)


def main(arguments: list[str]) -> int:
    if arguments == ["--install"]:
        reason = "" if find() else debian.install(PACKAGES)
        if reason:
            print(f"browser tests left out: no Chromium ({reason}); install it, or name it in KITROBOT_CHROMIUM")
        return 0
    path = find()
    if path:
        print(path)
    return 0 if path else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
