"""Sessions of Zenoh: opened with our settings or refused with a sentence, and closed without waiting for others."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from contextlib import suppress
from threading import Thread
from typing import Any, Final

from kitrobot.fleet.charter import FleetError
from kitrobot.text.sentences import Sentence

CLOSED_WITHIN_S: Final = 1.0
"""How long closing a session is waited for; what is still to be sent then is lost."""

_COMMON: Final[Mapping[str, Any]] = {
    "scouting/multicast/enabled": False,
    "scouting/gossip/enabled": True,
    "listen/exit_on_failure": True,
    "transport/unicast/max_sessions": 1000,
    # 1 ms of patience loses messages whenever the machine is busy.
    "transport/link/tx/queue/congestion_control/drop/wait_before_drop": 5000,
}


def open_session(settings: Mapping[str, Any], missing: Sentence, way_out: Sentence) -> tuple[Any, Any]:
    """Zenoh, and a session of it.

    Args:
        settings: of Zenoh, by their paths, beside those of all our sessions.
        missing: what is said where Zenoh is not installed.
        way_out: the help where it cannot be opened so.

    Raises:
        FleetError: Zenoh is not installed, or cannot be opened with these settings.
    """
    try:
        import zenoh
    except ImportError as error:
        raise FleetError(missing, Sentence("install it: {command}", "`pip install kitrobot[fleet]`")) from error
    zenoh.init_log_from_env_or("off")
    config = zenoh.Config()
    try:
        for name, value in {**_COMMON, **settings}.items():
            config.insert_json5(name, json.dumps(value))
        return zenoh, zenoh.open(config)
    except Exception as error:  # Zenoh's own errors have no class of their own that all versions share.
        raise FleetError(Sentence("the network cannot be opened: {why}", _reason(error)), way_out) from error


def _reason(error: Exception) -> str:
    """What Zenoh says, without the lines of its source and the type of the error in it."""
    first = str(error).strip().partition("\n")[0]
    return re.sub(r'^\w+\(Message \{ msg: "| at /.*', "", first)[:200]


def close_session(session: Any) -> None:
    """Ends a session.

    Zenoh waits for connections whose other ends are out of reach, and then fails; nobody waits for that here.
    """

    def close() -> None:
        with suppress(Exception):  # Zenoh's own errors have no class that all versions share.
            session.close()

    closing = Thread(target=close, daemon=True, name="closes a session of Zenoh")
    closing.start()
    closing.join(CLOSED_WITHIN_S)
