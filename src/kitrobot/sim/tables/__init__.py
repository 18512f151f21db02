"""The layout of a run's state: rows of numbers, the names of their columns, their bytes."""
