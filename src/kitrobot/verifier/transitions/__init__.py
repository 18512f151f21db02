"""Successors of a state, under each assumption about time."""
