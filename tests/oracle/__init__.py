"""A second opinion on what a program means: LLL interpreted straight from its tree, for tests only."""

from tests.oracle.interpreter import Oracle, Outcome

__all__ = ["Oracle", "Outcome"]
