"""The user's folders: for XML of their own, for what programs remember, for what can be made again.

Each is named by a variable of the environment, or is the usual one of the platform (docs/install.md).
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from platformdirs.api import PlatformDirsABC


def config_folder() -> Path:
    """The user's robots, constructors and kits: `$KITROBOT_CONFIG`, or the platform's usual place."""
    return Path(os.environ.get("KITROBOT_CONFIG") or _usual(roaming=True).user_config_path)


def state_folder() -> Path:
    """What programs remember: `$KITROBOT_STATE`, or the platform's usual place."""
    return Path(os.environ.get("KITROBOT_STATE") or _usual().user_state_path)


def cache_folder() -> Path:
    """What can be made again: `$KITROBOT_CACHE`, or the platform's usual place."""
    return Path(os.environ.get("KITROBOT_CACHE") or _usual().user_cache_path)


def _usual(*, roaming: bool = False) -> PlatformDirsABC:
    # Not before: a static site names its folders, and has no platformdirs.
    import platformdirs

    return platformdirs.PlatformDirs("kitrobot", appauthor=False, roaming=roaming)
