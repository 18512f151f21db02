"""Python's garbage collector in a process that serves a studio."""

from __future__ import annotations

import gc


def tune_garbage_collector() -> None:
    """Has it look at everything less often, and never at what is there now.

    Hardly anything here is garbage that counting references does not find, and a look at a large mission's programs
    takes longer than the answer that it delays.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 50, 100)
