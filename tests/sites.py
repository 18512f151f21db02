"""The static site, made once for all workers of a run of the tests: making it reads every source that is sent.

It is packed quickly, and as it is shipped in the thorough profile: a page unpacks both the same way. What sources are
without their texts, and what files are when they are packed, is kept in `build` from one run to the next. That it is
what making the site without it gives, to the byte, is held by `tests/workspace/test_site.py`.
"""

from __future__ import annotations

import hashlib
import lzma
import os
import pickle
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from unittest.mock import patch

from kitrobot.packaging import site, site_packages, site_packer, site_sources
from kitrobot.server.first_missions import first_missions
from tests.effort import THOROUGH
from tools.site_parts import PARTS, ROOT

if sys.platform != "win32":
    import fcntl

KEPT = ROOT / "build" / "parts-of-sites.pickle"


def quickly_packed(data: bytes) -> bytes:
    """As `site_packer.packed`, a fifth larger and in a tenth of the time."""
    filters = [{"id": lzma.FILTER_LZMA2, "preset": 0, "dict_size": max(4096, 1 << (len(data) - 1).bit_length())}]
    return lzma.compress(data, lzma.FORMAT_XZ, lzma.CHECK_CRC32, filters=filters)


@contextmanager
def kept_sources() -> Iterator[None]:
    """Takes what was made of a source or file from the run before, where data, code and Python are the same."""
    way = hashlib.sha256(sys.version.encode())
    for module in (site_sources, site_packer):
        way.update(Path(str(module.__file__)).read_bytes())
    before: dict[bytes, bytes] = pickle.loads(KEPT.read_bytes()) if KEPT.is_file() else {}
    now: dict[bytes, bytes] = {}

    def kept(made: Callable[[bytes], bytes]) -> Callable[[bytes], bytes]:
        def make(data: bytes) -> bytes:
            digest = way.copy()
            digest.update(made.__name__.encode() + data)
            key = digest.digest()
            found = before.get(key)
            now[key] = made(data) if found is None else found
            return now[key]

        return make

    without_texts = kept(site_sources.without_texts)
    with (
        patch.object(site, "without_texts", without_texts),
        patch.object(site_packages, "without_texts", without_texts),
        patch.object(site, "packed", kept(site_packer.packed) if THOROUGH else quickly_packed),
    ):
        yield
    if now.keys() != before.keys():
        made = KEPT.with_suffix(f".{os.getpid()}")
        made.write_bytes(pickle.dumps(now))
        made.replace(KEPT)


def made_site(base: Path) -> Path:
    """The folder; whoever changes it makes a copy. `base`: pytest's folder of this worker."""
    # Workers of xdist have folders side by side.
    common = base.parent if base.name.startswith("popen-") else base
    folder, made = common / "static-site", common / "static-site.made"
    with open(common / "static-site.lock", "w") as lock:
        if sys.platform != "win32":
            fcntl.flock(lock, fcntl.LOCK_EX)
        if not made.exists():
            with kept_sources():
                site.make_site(folder, [ROOT / "web", PARTS], first=first_missions())
            made.touch()
    return folder
