"""Tutorials: the steps that a user is asked to do, and whether a program shows that a step is done."""
