"""Find the Firefox that a test drives; with `--install`, install it where that is possible.

    python -m tools.firefox              print its path; status 1 if there is none
    python -m tools.firefox --install    install it with apt if this is root's Debian, else say what is left out

The one of the system, or the one that KITROBOT_FIREFOX names.
"""

from __future__ import annotations

import os
import shutil
import sys

from tools import debian

NAMES = ("firefox-esr", "firefox")
PACKAGES = ("firefox-esr", "fonts-noto-core")


def find() -> str | None:
    """The path of a Firefox, or None."""
    named = os.environ.get("KITROBOT_FIREFOX")
    if named:
        return shutil.which(named)
    return next((path for path in map(shutil.which, NAMES) if path), None)


def main(arguments: list[str]) -> int:
    if arguments == ["--install"]:
        reason = "" if find() else debian.install(PACKAGES)
        if reason:
            print(f"the test in Firefox left out: no Firefox ({reason}); install it, or name it in KITROBOT_FIREFOX")
        return 0
    path = find()
    if path:
        print(path)
    return 0 if path else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
