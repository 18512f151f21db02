"""How long tests wait for what somebody else does: bounds against hangs, far above what a slow, busy machine needs."""

PATIENCE_S = 600
"""For processes and threads."""
STATE_MS = 120_000
"""For a state of the page."""
