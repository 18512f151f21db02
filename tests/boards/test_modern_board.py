"""The WebAssembly board behaves at its line as boards with a current MicroPython do."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing

import pytest
import serial

from tests.boards.modern import ModernBoard, run
from tests.patience import PATIENCE_S

WAITS = b"import sys; sys.stdin.read(1)\n"
"""The first line of a program that says nothing before it is told to: pySerial forgets what comes while it connects."""
BANNER = b"raw REPL; CTRL-B to exit\r\n>"


@pytest.fixture
def board() -> Iterator[ModernBoard]:
    with ModernBoard() as found:
        yield found


def connect(board: ModernBoard) -> closing[serial.Serial]:
    return closing(serial.serial_for_url(board.address, timeout=PATIENCE_S))


def until(line: serial.Serial, end: bytes) -> bytes:
    found: bytes = line.read_until(end)
    assert found.endswith(end), found
    return found


def interrupted(line: serial.Serial) -> bytes:
    """What a program says that is interrupted, again where nothing comes of it, as by a person's key."""
    line.timeout = 1
    found = b""
    for _ in range(PATIENCE_S):
        line.write(b"\x03")
        found += line.read_until(b"\x04>")
        if found.endswith(b"\x04>"):
            break
    line.timeout = PATIENCE_S
    return found


def to_raw(line: serial.Serial) -> None:
    """Whatever runs, to an empty raw REPL."""
    line.write(b"\r\x03\x03\r\x01")
    until(line, BANNER)


def command(line: serial.Serial, text: str) -> bytes:
    """What a command prints in the raw REPL."""
    line.write(text.encode() + b"\x04")
    until(line, b"OK")
    printed = until(line, b"\x04")[:-1]
    assert until(line, b"\x04>") == b"\x04>"
    return printed


def test_the_prompt_answers(board: ModernBoard) -> None:
    with connect(board) as line:
        line.write(b"\r6*7\r")
        assert b"42" in until(line, b"42\n>>> ")


def test_the_raw_repl_answers_and_tells_of_exceptions(board: ModernBoard) -> None:
    with connect(board) as line:
        to_raw(line)
        assert command(line, "print(6*7)") == b"42\n"
        line.write(b"1/0\x04")
        assert b"ZeroDivisionError" in until(line, b"\x04>")


def test_a_program_is_interrupted_while_it_runs_and_while_it_waits(board: ModernBoard) -> None:
    with connect(board) as line:
        to_raw(line)
        for waits in ("time.ticks_ms()", "time.sleep_ms(1)", "sys.stdin.buffer.read(1)"):
            line.write(b"import sys, time\nprint('on')\nwhile True: " + waits.encode() + b"\x04")
            until(line, b"on\n")
            assert b"KeyboardInterrupt" in interrupted(line)


def test_bytes_are_polled_and_read_without_waiting_and_control_c_can_be_one_of_them(board: ModernBoard) -> None:
    with connect(board) as line:
        to_raw(line)
        text = """
import micropython, select, sys
micropython.kbd_intr(-1)
poll = select.poll()
poll.register(sys.stdin, select.POLLIN)
print(poll.poll(0))
while not poll.poll(1000): pass
print(sys.stdin.buffer.read(3), poll.poll(0))
micropython.kbd_intr(3)
"""
        line.write(text.encode() + b"\x04")
        assert until(line, b"[]\n") == b"OK[]\n"
        line.write(b"a\x03\xff")
        assert until(line, b"\x04\x04>") == b"b'a\\x03\\xff' []\n\x04\x04>"


def test_files_outlast_a_soft_reset_and_a_power_cut_and_memory_does_not(board: ModernBoard) -> None:
    with connect(board) as line:
        to_raw(line)
        command(line, "import os\nf=open('a','wb')\nf.write(b'1\\n\\xff')\nf.close()\nx=1\nos.rename('a','b')")
        command(line, "open('c','w').close()\nos.mkdir('d')\nopen('d/e','w').close()\nos.remove('c')")
        assert board.files() == {"b": b"1\n\xff", "d/e": b""}
        line.write(b"\x04")
        assert b"soft reboot\r\n" in until(line, BANNER)
        assert command(line, "import os\nprint('x' in globals(), sorted(os.listdir()), os.getcwd())") == (
            b"False ['b', 'd'] /flash\n"
        )
        line.write(b"f=open('f','wb')\nf.write(b'1')\nprint('on')\nwhile True: pass\x04")
        until(line, b"on\n")
        board.cut_power()
        until(line, b">>> ")
        to_raw(line)
        assert command(line, "import os\nprint(sorted(os.listdir()), open('b','rb').read())") == (
            b"['b', 'd'] b'1\\n\\xff'\n"
        )


def test_main_py_runs_at_power_on_and_at_a_soft_reset_from_the_prompt_only() -> None:
    files = {
        "boot.py": WAITS + b"print('boot')",
        "main.py": b"import time\nprint('main')\nwhile True: time.sleep_ms(5)",
    }
    with ModernBoard(files) as board, connect(board) as line:
        line.write(b"x")
        assert until(line, b"main\n") == b"boot\nmain\n"
        line.write(b"\x03")
        assert b"KeyboardInterrupt" in until(line, b">>> ")
        line.write(b"\x04x")
        until(line, b"soft reboot\r\nboot\nmain\n")
        to_raw(line)
        line.write(b"\x04x")
        assert b"reboot\r\nboot\n" in (heard := until(line, BANNER))
        assert b"main" not in heard


def test_an_error_in_main_py_is_shown_and_leads_to_the_prompt() -> None:
    with ModernBoard({"main.py": WAITS + b"x = 1\n1/0"}) as board, connect(board) as line:
        line.write(b"x")
        assert b'File "main.py", line 3' in until(line, b">>> ")
        line.write(b"x\r")
        until(line, b"x\r\n1\n>>> ")


def test_raw_paste_takes_long_texts_window_by_window(board: ModernBoard) -> None:
    with connect(board) as line:
        to_raw(line)
        text = b"#" + b"long " * 2000 + b"\nprint(6*7)\n"
        for _ in range(2):
            line.write(b"\x05A\x01")
            assert line.read(2) == b"R\x01"
            window = int.from_bytes(line.read(2), "little")
            room = 0
            left = text
            while left:
                if room == 0:
                    assert line.read(1) == b"\x01"
                    room += window
                line.write(left[:room])
                left, room = left[room:], max(0, room - len(left))
            line.write(b"\x04")
            assert until(line, b"\x04").strip(b"\x01") == b"\x04"
            assert until(line, b"\x04\x04>") == b"42\n\x04\x04>"
        assert command(line, "print(1)") == b"1\n"


def test_a_burst_is_not_lost(board: ModernBoard) -> None:
    with connect(board) as line:
        to_raw(line)
        line.write(b"import sys\nprint('on')\nprint(sum(sys.stdin.buffer.read(200000)))\x04")
        until(line, b"on\n")
        line.write(b"\x01" * 200_000)
        assert b"200000\n" in until(line, b"\x04\x04>")


def test_the_next_host_takes_the_line_over(board: ModernBoard) -> None:
    with connect(board) as first:
        to_raw(first)
        with connect(board) as second:
            to_raw(second)
            assert command(second, "print(1)") == b"1\n"


def test_a_program_runs_without_a_line_with_garbage_collected() -> None:
    program = b"""
left = 300
def step():
    global left
    left -= 1
    print(left, len(bytes(1_000_000)))
    return left
"""
    assert run({"main.py": program}, "main.py").split()[-4:] == ["1", "1000000", "0", "1000000"]
