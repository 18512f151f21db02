"""Exercises: a mission to begin with, and goals that are decided from runs, from the programs and by checking."""
