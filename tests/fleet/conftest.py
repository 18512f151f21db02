"""The command line as `tests/cli` calls it."""

from tests.cli.conftest import here, kitrobot

__all__ = ["here", "kitrobot"]
