"""Times the ticks of a micro:bit of 2016 in QEMU from outside: it adds nothing to the board's program or memory.

Two functions of the firmware that the loop of a robot calls, `ticks_diff` (is the next tick due?) and `ticks_add` (when
is the one after it?), are led through a few instructions of ours, which write the time and both arguments to an address
where nothing is; QEMU logs that (`-d unimp`). They lie where the firmware's `time_pulse_us` was, which is replaced too:
it waits as long as an echo would take and answers with its length, one of 0 to 4.1 ms, so that range finders work.

Each instruction takes 64 ns, time of waiting is left out (`-icount shift=6,sleep=off`), and nothing stops the processor
meanwhile, so the numbers are the same each time and on any machine.
"""

from __future__ import annotations

import contextlib
import re
import socket
import struct
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.repl import RawRepl
from tests.boards.qemu import Emulated, running
from tests.patience import PATIENCE_S

_SOC = "/machine/nrf51"
_TIMER = 0x4000A000  # TIMER2, which the firmware leaves alone until music plays
_NOWHERE = 0x40020000
_BEFORE_ECHO_US = 460
"""What an HC-SR04 takes from the trigger to the begin of its echo."""

_FUNCTIONS = ("utime.ticks_diff", "utime.ticks_add", "utime.sleep_us", "machine.time_pulse_us")
_CALL_OF_PULSE = 0x26
"""Where `time_pulse_us` calls what does the work."""

_LOGGED = re.compile(rb"unimplemented device write \(size 4, offset 0x0*200([01])([048]), value 0x([0-9a-f]+)\)")

_NOW = (0x2301, 0x6413, 0x2354, 0x011B, 0x58D3)
"""movs r3, 1; str r3, [r2, 0x40]; movs r3, 0x54; lsls r3, 4; ldr r3, [r2, r3]: of the timer at r2, the time in r3."""


@dataclass(frozen=True)
class ProbedCall:
    """A call of the board's loop: whether a tick is due, or, after a tick (`is_end`), when the next one is due.

    `at_us`: the time of the call; `first`, `second`: its arguments, in ms of the board.
    """

    is_end: bool
    at_us: int
    first: int
    second: int


class FirmwareProbe:
    """A running board, with access to its pins, clock and calls."""

    def __init__(self, board: Emulated, folder: Path) -> None:
        self.board = board
        self._log = folder / "log"
        self._debugger, self._tester = _connected(folder / "gdb"), _connected(folder / "qtest")
        self._heard = b""
        self._seen = 0
        self._values: list[tuple[bytes, bytes, bytes]] = []

    def set_pin(self, number: int, level: bool) -> None:
        """Puts a level at a pin of the processor (0 to 31)."""
        self._test(f"set_irq_in {_SOC} unnamed-gpio-in {number} {int(level)}")

    def start_clock(self) -> None:
        """Lets the timer count microseconds, from 0 to an hour; a restart of the board ends it."""
        for register, value in ((0x504, 0), (0x508, 3), (0x510, 4), (0x000, 1)):
            self._test(f"writel {_TIMER + register:#x} {value}")

    def tell_emulator(self, command: str) -> None:
        """Gives QEMU a command of its monitor."""
        self.board.tell_emulator(command.encode())

    def written(self) -> int:
        """How much was logged so far, in bytes."""
        return self._log.stat().st_size

    def logged(self, begin: int, end: int | None = None) -> bytes:
        """What stands there in the log."""
        return self._log.read_bytes()[begin:end]

    def forget_calls(self) -> None:
        """Begins with the calls that come from now on."""
        self._seen, self._values = self.written(), []

    def calls(self) -> list[ProbedCall]:
        """What the loop called since this was asked before."""
        text = self.logged(self._seen)
        text = text[: text.rfind(b"\n") + 1]
        self._seen += len(text)
        self._values += _LOGGED.findall(text)
        while self._values and self._values[0][1] != b"0":
            del self._values[0]  # of a call whose begin was forgotten
        numbers = [int(value, 16) for _, _, value in self._values]
        whole = range(0, len(numbers) // 3 * 3, 3)
        # Small numbers of the firmware: twice the number, and 1.
        made = [
            ProbedCall(self._values[at][0] == b"1", numbers[at], numbers[at + 1] >> 1, numbers[at + 2] >> 1)
            for at in whole
        ]
        del self._values[: 3 * len(whole)]
        return made

    def patch(self) -> None:
        """Leads the firmware through our instructions. The board is at its prompt."""
        objects = self._objects()
        self._debugger.sendall(b"\x03")  # it stands until `c`
        pointers = {name: self._pointer(address) for name, address in objects.items()}
        functions = {name: self._word(pointer) - 1 for name, pointer in pointers.items()}
        pulse = functions["machine.time_pulse_us"]
        high, low = struct.unpack("<HH", self._read(pulse + _CALL_OF_PULSE, 4))
        if high >> 11 != 0x1E or low >> 11 != 0x1F or pulse % 4:
            raise RuntimeError("this is another firmware of the micro:bit")
        room = pulse + _CALL_OF_PULSE + 4 + ((high & 0x7FF) << 12 | (low & 0x7FF) << 1)
        room = -(-room // 4) * 4
        self._write(pulse, _echo(functions["utime.sleep_us"]))
        for number, name in enumerate(("utime.ticks_diff", "utime.ticks_add")):
            code = _reporting_code(functions[name], _NOWHERE + 16 * number)
            self._write(room, code)
            self._write(pointers[name], struct.pack("<I", room | 1))
            room += len(code)
        self._debugger.sendall(_packet("c"))

    def close(self) -> None:
        """Lets go of the emulator."""
        self._debugger.close()
        self._tester.close()

    def _objects(self) -> dict[str, int]:
        """Where the firmware keeps what it knows of functions; the board says it at its prompt."""
        line = Line(self.board.address)
        try:
            repl = RawRepl(line)
            repl.enter()
            return {
                name: int(repl.run(f"import {name.partition('.')[0]};print(id({name}))", PATIENCE_S))
                for name in _FUNCTIONS
            }
        finally:
            line.close()

    def _pointer(self, of: int) -> int:
        """Where in what the firmware knows of a function stands where its code is: behind its type, and for some how
        many arguments it takes.
        """
        return next(at for at in (of + 4, of + 8) if (word := self._word(at)) % 2 and 0x100 < word < 0x40000)

    def _word(self, address: int) -> int:
        return int(struct.unpack("<I", self._read(address, 4))[0])

    def _read(self, address: int, count: int) -> bytes:
        return bytes.fromhex(self._ask(f"m{address:x},{count:x}"))

    def _write(self, address: int, data: bytes) -> None:
        self._ask(f"M{address:x},{len(data):x}:{data.hex()}")

    def _test(self, command: str) -> None:
        self._tester.sendall(command.encode() + b"\n")
        told = b""
        while not told.endswith(b"\n"):
            told += _more(self._tester)
        if not told.startswith(b"OK"):
            raise RuntimeError(f"{command}: {told!r}")

    def _ask(self, command: str) -> str:
        """The answer of QEMU's debugger, behind what it tells of stops."""
        self._debugger.sendall(_packet(command))
        told = "T"
        while told.startswith("T"):
            # A packet: $...#, and two digits of a sum.
            while len(self._heard) - (end := self._heard.find(b"#")) < 3 or end < 0:
                self._heard += _more(self._debugger)
            told = self._heard[:end].partition(b"$")[2].decode()
            self._heard = self._heard[end + 3 :]
            self._debugger.sendall(b"+")
        if told.startswith("E"):
            raise RuntimeError(f"{command}: {told}")
        return told


@contextlib.contextmanager
def open_probe() -> Iterator[FirmwareProbe]:
    """A board that has started, with nothing on it, and whose firmware tells when ticks begin."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        options = [
            *("-icount", "shift=6,sleep=off"),
            *("-d", "unimp", "-D", str(folder / "log")),
            *("-gdb", f"unix:{folder / 'gdb'},server=on,wait=off"),
            *("-qtest", f"unix:{folder / 'qtest'},server=on,wait=off", "-qtest-log", "/dev/null"),
        ]
        with running(*options) as board:
            found = FirmwareProbe(board, folder)
            try:
                found._debugger.sendall(_packet("c"))
                found.patch()
                yield found
            finally:
                found.close()


def _echo(sleep: int) -> bytes:
    """The function in the place of `time_pulse_us`: waits, and gives back how long the echo was, in us."""
    return _assembled(
        (
            *(0xB510, (2, _TIMER), *_NOW),  # push {r4, lr}
            *(0x051C, 0x0D24),  # lsls r4, r3, 20; lsrs r4, r4, 20: the last 12 bits of the time
            *((0, _BEFORE_ECHO_US), 0x1900, 0x0040, 0x3001),  # r0 = 2 * (r0 + r4) + 1
            *((3, sleep | 1), 0x4798),  # blx r3
            *(0x0060, 0x3001, 0xBD10),  # r0 = 2 * r4 + 1; pop {r4, pc}
        )
    )


def _reporting_code(function: int, address: int) -> bytes:
    """Writes the time and the arguments r0 and r1 to an address, then goes on with a function."""
    return _assembled(
        (
            *((2, _TIMER), *_NOW, (2, address)),
            *(0x6013, 0x6050, 0x6091),  # str r3, [r2]; str r0, [r2, 4]; str r1, [r2, 8]
            *((2, function | 1), 0x4710),  # bx r2
        )
    )


def _assembled(code: Sequence[int | tuple[int, int]]) -> bytes:
    """Instructions, of which a pair loads a number into a register; the numbers stand behind them."""
    numbers = [one[1] for one in code if isinstance(one, tuple)]
    start = -(-len(code) // 2) * 4
    made = b""
    for at, one in enumerate(code):
        if isinstance(one, tuple):
            place = start + 4 * sum(isinstance(before, tuple) for before in code[:at])
            one = 0x4800 | one[0] << 8 | (place - (2 * at + 4) // 4 * 4) // 4
        made += struct.pack("<H", one)
    return made.ljust(start, b"\0") + struct.pack(f"<{len(numbers)}I", *numbers)


def _connected(path: Path) -> socket.socket:
    found = socket.socket(socket.AF_UNIX)
    found.settimeout(PATIENCE_S)
    found.connect(str(path))
    return found


def _packet(command: str) -> bytes:
    return b"$%s#%02x" % (command.encode(), sum(command.encode()) % 256)


def _more(wire: socket.socket) -> bytes:
    piece = wire.recv(4096)
    if not piece:
        raise RuntimeError("the emulator ended")
    return piece
