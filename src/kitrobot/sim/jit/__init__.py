"""Compiled steps: the same functions under Numba, their cache, and when a run is worth compiling."""
