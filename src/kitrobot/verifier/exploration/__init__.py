"""Breadth-first exploration of a model's states, plain and compiled, and fairness over what it found."""
