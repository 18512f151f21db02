"""Questions that are put to many runs, and numbers that hold: studies, probabilities, statistics."""
