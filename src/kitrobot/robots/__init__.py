"""Real robots as runs: the session with each, its state from what it sends, recordings, and sending programs."""
