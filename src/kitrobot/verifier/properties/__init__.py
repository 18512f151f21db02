"""Properties of states and runs, and their verdicts."""
