"""`python -m kitrobot`, and the command `kitrobot`: the place where the doors are put together.

The command line and the studio's server are strangers to each other; here the one is handed to the other.
"""

from __future__ import annotations

from kitrobot.cli import ClassWish, Opening, main


def _open_studio(opening: Opening) -> None:
    # Only now: nothing else needs a web server.
    from kitrobot.server import serve

    serve(opening.target, opening.host, opening.port, opening.browser, opening.new)


def _open_class(wish: ClassWish) -> None:
    from kitrobot.server import ClassOpening, serve_class

    serve_class(ClassOpening(wish.folder, wish.host, wish.port, wish.tls, wish.browser, wish.new_code, wish.site))


def _first_missions() -> dict[str, bytes]:
    from kitrobot.server.first_missions import first_missions

    return first_missions()


def run() -> None:
    """Runs the command line with the studio and the class in it."""
    main(studio=_open_studio, classroom=_open_class, first=_first_missions)


if __name__ == "__main__":
    run()
