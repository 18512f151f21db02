"""The command line: a thin door to the workspace."""

from kitrobot.cli.app import main
from kitrobot.cli.studio import Opening

__all__ = ["Opening", "main"]
