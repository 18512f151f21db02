"""The command line: a thin door to the workspace."""

from kitrobot.cli.app import main
from kitrobot.cli.classroom import ClassWish
from kitrobot.cli.studio import Opening

__all__ = ["ClassWish", "Opening", "main"]
