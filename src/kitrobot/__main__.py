"""`python -m kitrobot`, and the command `kitrobot`: the place where the doors are put together.

The command line and the studio's server are strangers to each other; here the one is handed to the other. Nothing that
takes time is imported before Ctrl-C is heard and the streams that were closed from the start have their numbers; hence
`_signal`, which is what `signal` makes enumerations of, and no `typing`.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]
import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from kitrobot.cli.classroom import ClassOptions
    from kitrobot.cli.studio import StudioOptions

INTERRUPTED = 130


def _open_studio(options: StudioOptions) -> None:
    # Only now: nothing else needs a web server.
    from kitrobot.server.studio_server import serve

    serve(options.target, options.host, options.port, options.browser, options.new)


def _open_class(options: ClassOptions) -> None:
    from kitrobot.server.classroom.class_server import ClassSettings, serve_class

    serve_class(
        ClassSettings(
            options.folder,
            options.host,
            options.port,
            options.tls,
            options.https,
            options.browser,
            options.new_code,
            options.site,
        )
    )


def _first_missions() -> dict[str, bytes]:
    from kitrobot.server.first_missions import first_missions

    return first_missions()


def run() -> None:
    """Runs the command line with the studio and the class in it.

    Raises:
        SystemExit: always, with the status.
    """
    _hold_standard_streams()
    usual = _end_at_once_with_ctrl_c(b"broken off\n")
    from kitrobot.cli.app import main

    try:
        if usual is not None:
            _signal.signal(_signal.SIGINT, usual)
        main(studio=_open_studio, classroom=_open_class, first=_first_missions)
    except KeyboardInterrupt:
        os.write(2, b"broken off\n")
        raise SystemExit(INTERRUPTED) from None
    finally:
        # What is left is Python's own end.
        _end_at_once_with_ctrl_c()


def _end_at_once_with_ctrl_c(words: bytes = b"") -> Any:
    """Ctrl-C ends the process from now on, with these words on standard error: nothing is open. Gives what it did
    before; None where that is not ours to change.
    """
    usual = _signal.getsignal(_signal.SIGINT)
    if usual in (_signal.SIG_IGN, None):
        return None
    try:
        _signal.signal(_signal.SIGINT, lambda *_: (os.write(2, words), os._exit(INTERRUPTED)))
    except ValueError:
        return None  # not in the main thread
    return usual


def _hold_standard_streams() -> None:
    """Numbers of standard streams that were closed lead nowhere: else the next file that is opened gets one, and with
    it whatever is written there.
    """
    for number in range(3) if os.name == "posix" else ():
        try:
            os.fstat(number)
        except OSError:
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)


if __name__ == "__main__":
    run()
