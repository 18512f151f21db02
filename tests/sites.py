"""The static site, made once for all workers of a run of the tests: making it reads every source that is sent."""

from __future__ import annotations

import sys
from pathlib import Path

from kitrobot.workspace.site import make_site
from tools.site_parts import PARTS, ROOT

if sys.platform != "win32":
    import fcntl


def made_site(base: Path) -> Path:
    """The folder; whoever changes it makes a copy. `base`: pytest's folder of this worker."""
    # Workers of xdist have folders side by side.
    common = base.parent if base.name.startswith("popen-") else base
    folder, made = common / "static-site", common / "static-site.made"
    with open(common / "static-site.lock", "w") as lock:
        if sys.platform != "win32":
            fcntl.flock(lock, fcntl.LOCK_EX)
        if not made.exists():
            make_site(folder, [ROOT / "web", PARTS])
            made.touch()
    return folder
