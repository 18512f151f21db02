"""`python -m kitrobot`, and the command `kitrobot`: the place where the doors are put together.

The command line and the studio's server are strangers to each other; here the one is handed to the other.
"""

from __future__ import annotations

from kitrobot.cli import Opening, main


def _open_studio(opening: Opening) -> None:
    # Only now: nothing else needs a web server.
    from kitrobot.server import serve

    serve(opening.target, opening.host, opening.port, opening.browser, opening.new)


def run() -> None:
    """Runs the command line with the studio in it."""
    main(studio=_open_studio)


if __name__ == "__main__":
    run()
