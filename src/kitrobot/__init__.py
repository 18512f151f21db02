"""Draw a program as a graph and run it on small robots."""

from importlib.metadata import version

__all__ = ["__version__"]

__version__ = version("kitrobot")
