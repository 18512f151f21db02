"""A micro:bit of 2016 in QEMU: the real firmware, with its serial line on a TCP port of this machine.

What is written into its flash stays as long as the emulator runs, over resets, and goes with it.
"""

from __future__ import annotations

import contextlib
import shutil
import socket
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from tests.patience import PATIENCE_S
from tools import qemu

_FLASH, _PAGE = 256 * 1024, 1024


@dataclass
class Emulated:
    """A running board: where it is reached, and the emulator's process."""

    address: str
    port: int
    process: subprocess.Popen[bytes]

    def read_until(self, wire: socket.socket, end: bytes) -> bytes:
        """What comes on an open connection, up to `end`."""
        data = b""
        while not data.endswith(end):
            piece = wire.recv(1)
            assert piece, f"the board hung up after {data!r}"
            data += piece
        return data

    def cut_power(self) -> None:
        """Takes the power away at once and gives it back; what is in the flash stays."""
        self.tell_emulator(b"system_reset")

    def pause(self) -> None:
        """Stops its processor, which takes some of ours also while it waits."""
        self.tell_emulator(b"stop")

    def resume(self) -> None:
        """Lets it go on where it was stopped."""
        self.tell_emulator(b"cont")

    def keep_state(self, file: Path) -> None:
        """Writes all that it is into a file, which `-incoming` goes on from, and ends it."""
        made = file.with_suffix(".new")
        self.tell_emulator(f"migrate \"exec:cat > '{made}'\"\nquit".encode())
        assert self.process.wait(PATIENCE_S) == 0
        made.replace(file)

    def tell_emulator(self, command: bytes) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(command + b"\n")
        self.process.stdin.flush()

    def wire(self) -> socket.socket:
        """A bare connection to its serial line."""
        wire = socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE_S)
        wire.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return wire


@contextlib.contextmanager
def running(*extra: str, firmware: str = "") -> Iterator[Emulated]:
    """A board that has started, with nothing on it. `extra`: options of QEMU; `firmware`: its file."""
    with booted(*extra, firmware=firmware) as board:
        with board.wire() as wire:
            wire.sendall(b"\r")
            board.read_until(wire, b">>> ")
            _erase(board, wire, _end_of(Path(firmware or installed_emulator().firmware)))
        yield board


@contextlib.contextmanager
def booted(*extra: str, firmware: str) -> Iterator[Emulated]:
    """A board that has just been given its power, with what is in a firmware's file and no more."""
    found = installed_emulator()
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        process = subprocess.Popen(
            _command(found.program, firmware or found.firmware, listener.fileno(), extra),
            pass_fds=[listener.fileno()],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            start_new_session=True,  # Linux shares cores among sessions: a board is no part of a worker's share
        )
    try:
        yield Emulated(f"socket://127.0.0.1:{port}", port, process)
    finally:
        process.kill()
        process.wait()


def installed_emulator() -> qemu.Emulator:
    """The emulator and the firmware of this machine."""
    found = qemu.find()
    # Not skipped: who leaves the board tests out says so with -m.
    assert found is not None, "no QEMU with a micro:bit here; install them, or leave these tests out: -m 'not boards'"
    return found


def _erase(board: Emulated, wire: socket.socket, start: int) -> None:
    """Erases the flash from there on, and restarts the board, which then makes a file system.

    The emulator's flash is zero where no firmware is; a real one's is erased, and the file system counts on that: on
    zeros it loses files when it tidies them up.
    """
    for line in (
        "from machine import mem32 as m",
        "m[0x4001e504]=2",  # erasing is allowed
        *(f"m[0x4001e508]={page}" for page in range(start, _FLASH, _PAGE)),
        "m[0x4001e504]=0",
    ):
        wire.sendall(line.encode() + b"\r")
        board.read_until(wire, b">>> ")
    wire.sendall(b"import machine;machine.reset()\r")
    board.read_until(wire, b"\n")
    board.read_until(wire, b">>> ")


def _end_of(firmware: Path) -> int:
    """The first page behind a firmware."""
    end = base = 0
    for line in firmware.read_text(encoding="ascii").splitlines():
        record = bytes.fromhex(line[1:])
        size, address, kind = record[0], int.from_bytes(record[1:3], "big"), record[3]
        if kind == 4:
            base = int.from_bytes(record[4:6], "big") << 16
        elif kind == 0 and base + address < _FLASH:
            end = max(end, base + address + size)
    return -(-end // _PAGE) * _PAGE


def _command(program: str, firmware: str, listener: int, extra: Sequence[str]) -> list[str]:
    # Whatever ends the tests ends the board too: it would take a whole core until the machine is restarted.
    setpriv = shutil.which("setpriv")
    return [
        *([setpriv, "--pdeathsig", "KILL"] if setpriv else []),
        program,
        *("-M", "microbit", "-display", "none", "-monitor", "stdio"),
        # One thread for all: with two, a third of the time goes into waking the other one for each byte of the line.
        *("-accel", "tcg,thread=single"),
        *("-chardev", f"socket,id=s,fd={listener},server=on,wait=off,nodelay=on", "-serial", "chardev:s"),
        *("-device", f"loader,file={firmware}"),
        *extra,
    ]
