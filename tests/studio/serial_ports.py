"""A stand-in of the browser's Web Serial, whose port is the serial line of an emulated board: real bytes both ways.

A page reaches no TCP ports, so a bridge on loopback passes the bytes on; the page must be made with `bypass_csp`, for
nothing of ours may be asked for elsewhere.
"""

from __future__ import annotations

import socket
import threading
from contextlib import suppress
from types import TracebackType

from playwright.sync_api import Page
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import ServerConnection, serve

from tests.patience import PATIENCE_S

MICROBIT, PICO = 0x0D28, 0x2E8A
"""Who made the chip of a port, by which a page knows what may be there."""
STAND_IN = """(given) => {
    class Port extends EventTarget {
        readable = null;
        writable = null;
        constructor([address, vendor]) {
            super();
            this.address = address;
            this.vendor = vendor;
        }
        getInfo() { return { usbVendorId: this.vendor }; }
        async setSignals() {}
        async open() {
            if (this.wire !== undefined) throw new DOMException("already open", "InvalidStateError");
            const wire = new WebSocket(this.address);
            wire.binaryType = "arraybuffer";
            await new Promise((resolve, reject) => {
                wire.onopen = resolve;
                wire.onerror = () => reject(new DOMException("no such device", "NetworkError"));
            });
            this.wire = wire;
            this.readable = new ReadableStream({
                start: (into) => {
                    wire.onmessage = ({ data }) => into.enqueue(new Uint8Array(data));
                    wire.onclose = () => {
                        if (this.wire !== wire) return;
                        this.readable = this.writable = null;
                        into.error(new DOMException("The device has been lost.", "NetworkError"));
                        this.dispatchEvent(new Event("disconnect", { bubbles: true }));
                    };
                },
            });
            this.writable = new WritableStream({
                write: (data) => {
                    if (wire.readyState === WebSocket.OPEN) wire.send(data);
                    else throw new DOMException("The device has been lost.", "NetworkError");
                },
            });
        }
        async close() {
            this.wire?.close();
            this.wire = undefined;
            this.readable = this.writable = null;
        }
    }
    const ports = given.map((one) => new Port(one));
    const serial = new EventTarget();
    // As in a browser, what a port tells bubbles to `navigator.serial`.
    for (const port of ports) port.addEventListener("disconnect", () => {
        const told = new Event("disconnect");
        Object.defineProperty(told, "target", { value: port });
        serial.dispatchEvent(told);
    });
    // Who is asked chooses one that is not in use.
    serial.requestPort = async () => ports.find((port) => port.wire === undefined) ?? ports[0];
    Object.defineProperty(navigator, "serial", { value: serial, configurable: true });
}"""


class Bridge:
    """Passes bytes on between a page and a board's line; `pull` is the cable that is pulled."""

    def __init__(self, port: int, vendor: int = MICROBIT) -> None:
        self.vendor = vendor
        self._board = ("127.0.0.1", port)
        self._open: list[socket.socket] = []
        self._server = serve(self._pass, "127.0.0.1", 0, compression=None)
        self.address = f"ws://127.0.0.1:{self._server.socket.getsockname()[1]}/"
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)

    def __enter__(self) -> Bridge:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.pull()
        self._server.shutdown()
        self._thread.join(PATIENCE_S)

    def give(self, page: Page, *others: Bridge) -> None:
        """The page has that port and those of others, and no more."""
        page.evaluate(STAND_IN, [[one.address, one.vendor] for one in (self, *others)])

    def pull(self) -> None:
        """Hangs up."""
        for wire in self._open:
            with suppress(OSError):
                wire.shutdown(socket.SHUT_RDWR)

    def _pass(self, page: ServerConnection) -> None:
        page.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        with socket.create_connection(self._board, timeout=PATIENCE_S) as board:
            board.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            board.settimeout(None)
            self._open.append(board)

            def up() -> None:
                with suppress(OSError, ConnectionClosed):
                    while data := board.recv(4096):
                        page.send(data)
                page.close()

            reading = threading.Thread(target=up, daemon=True)
            reading.start()
            with suppress(OSError, ConnectionClosed):
                for data in page:
                    assert isinstance(data, bytes)
                    board.sendall(data)
            with suppress(OSError):
                board.shutdown(socket.SHUT_RDWR)
            reading.join(PATIENCE_S)
