"""The simulator: a mission in its world, fixed step, seeded, the same run every time."""
