"""A pause of Python's garbage collector, for work that makes many objects and no cycles among them.

While a large tree grows, the collector looks through all of it again and again and finds nothing; that takes as long as
reading the text. What is made during a pause is looked at once, after it. Pauses may nest and overlap between threads:
only the one that found the collector running sets it going again.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def collection_paused() -> Iterator[None]:
    """Pauses the collector for a `with` block, unless it stands still already."""
    was_running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_running:
            gc.enable()
