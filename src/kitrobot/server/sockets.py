"""A WebSocket as a channel of `kitrobot.live`."""

from __future__ import annotations

from fastapi import WebSocket, WebSocketDisconnect

from kitrobot.live.feed import ChannelClosedError, Message


class SocketChannel:
    """The channel to the page at the other end of an accepted WebSocket."""

    def __init__(self, socket: WebSocket) -> None:
        self._socket = socket

    async def receive(self) -> Message:
        """The next message.

        Raises:
            ChannelClosedError: the page is gone.
        """
        try:
            message = await self._socket.receive()
        except (WebSocketDisconnect, RuntimeError) as error:
            raise ChannelClosedError from error
        if message["type"] == "websocket.disconnect":
            raise ChannelClosedError
        return message.get("text") or message.get("bytes") or ""

    async def send_text(self, data: str) -> None:
        """Sends a message.

        Raises:
            ChannelClosedError: the page is gone.
        """
        try:
            await self._socket.send_text(data)
        except (WebSocketDisconnect, RuntimeError, OSError) as error:
            raise ChannelClosedError from error

    async def send_bytes(self, data: bytes) -> None:
        """Sends a frame.

        Raises:
            ChannelClosedError: the page is gone.
        """
        try:
            await self._socket.send_bytes(data)
        except (WebSocketDisconnect, RuntimeError, OSError) as error:
            raise ChannelClosedError from error
