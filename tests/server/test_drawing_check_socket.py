"""The check while one draws over its WebSocket: findings in the reader's language, refusals, and the socket goes on."""

from __future__ import annotations

import json
from typing import Any

import pytest
from pydantic import TypeAdapter

from kitrobot.server.routes import drawing_check as drawing_check_socket
from kitrobot.wire.drawing_check import DrawingCheckMessage
from tests.server.conftest import SOCKET, TOKEN
from tests.workspace.test_drawing_check import WAIT

MESSAGE: TypeAdapter[Any] = TypeAdapter(DrawingCheckMessage)


def test_what_is_found_comes_in_the_readers_language_and_what_is_no_mission_is_refused(
    page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(drawing_check_socket, "EXPLORE_S", None)  # However busy the machine is.
    drawn = page.post("/api/mission/read", content=WAIT.encode()).json()["mission"]
    with page.websocket_connect(f"{SOCKET}/api/drawing-check?language=fr&token={TOKEN}") as socket:

        def asked(**more: Any) -> Any:
            socket.send_text(json.dumps({"type": "start", "mission": drawn, "path": "", "seed": 1, **more}))
            return json.loads(socket.receive_text())

        said = asked()
        MESSAGE.validate_python(said)
        first, second = said["findings"]
        assert first["problem"]["message"] == "`carrier-1` peut en venir à attendre ici pour toujours"
        assert first["shown"]["seed"] == 1
        assert second["problem"]["code"] == "never-reached"
        assert second["shown"] is None
        mistakes: list[dict[str, Any]] = [{"mission": {}}, {"seed": -1}, {"path": 3}]
        for odd in mistakes:
            assert asked(**odd)["type"] == "refused"
        robots = [{"name": "r", "program": "missing", "start": ""}]
        assert asked(mission={**drawn, "agents": robots})["problems"]
        assert asked()["findings"] == said["findings"]
