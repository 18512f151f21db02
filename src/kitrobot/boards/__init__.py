"""Real boards as use cases: what they run, kits, benches, calibration, and sets of a class."""
