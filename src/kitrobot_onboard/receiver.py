# The program of a board while it is being installed: it receives frames of the link, answers each, and accesses files.
#
# It is never stored: a host defines it over the raw REPL, after link.py, and calls `receive`. A frame that arrives
# twice in a row is answered twice and executed once, so a host may repeat a request. Requests:
#
#   x  the payload is a Python expression; answered by D and its value (bytes as they are, all else as text)
#   d  the payload is written to the file that `o` opened; answered by K
#   q  the end; answered by K
#
# A small board's stack is small too: an expression may nest few calls. An exception is answered by E and its text.
# 0x03 twice in a row, which no frame contains, ends it too.

import builtins
import os

import micropython

from kitrobot_onboard.link import unwrap, wrap

try:
    import sys

    take = sys.stdin.buffer.read
    give = sys.stdout.buffer.write

    def hear():
        return take(1)

except AttributeError:  # the micro:bit of 2016
    from microbit import uart

    hear = uart.read
    give = uart.write

file = None


def o(name, mode):
    """Opens the file of the next requests."""
    global file
    c()
    file = open(name, mode)


def c():
    """Closes the file."""
    global file
    if file:
        file.close()
    file = None


def r(count):
    """The next bytes of the file."""
    return file.read(count)


def e(name):
    """Removes a file, when there is one."""
    if name in os.listdir():
        os.remove(name)


def z(name):
    """How long a file is, and the sum of it."""
    it = open(name, "rb")
    a = b = size = 0
    while True:
        data = it.read(64)
        if not data:
            break
        for x in data:
            a += x
            b += a
        a %= 255
        b %= 255
        size += len(data)
    it.close()
    return "%d %d" % (size, b << 8 | a)


def receive():
    micropython.kbd_intr(-1)
    give(wrap("K", 0, b""))
    heard = b""
    last = answer = None
    while last is None or last[0] != "q":
        heard += hear() or b""
        if b"\x03\x03" in heard:
            break
        i = heard.find(b"~")
        if i < 0:
            heard = heard[-99:]
            continue
        found = unwrap(heard[:i])
        heard = heard[i + 1 :]
        if found is None:
            continue
        if found[:2] != last:
            last = found[:2]
            answer = "K", b""
            try:
                if found[0] == "d":
                    file.write(found[2])
                elif found[0] == "x":
                    data = builtins.eval(found[2])  # by this name, so that the rest may be made shorter
                    answer = "D", data if isinstance(data, bytes) else bytes(str(data), "utf8")
            except Exception as error:
                answer = "E", bytes(repr(error), "utf8")
        give(wrap(answer[0], found[1], answer[1]))
    c()
    micropython.kbd_intr(3)
