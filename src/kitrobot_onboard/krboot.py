# Chooses what a board starts, for main.py: `program` is the program file of the newer intact line of `kr0` and `kr1`
# whose program file is intact too, or "". The words of a line: generation, module of the interpreter, program, sum of
# the program, sum of the line. It is the same in all versions, as main.py is.
#
# A generation is on trial as long as there is the file `krt`, which a host writes before a new line and has removed
# once the first ticks were done (`requests/keep`). The first start writes its generation there, with a line feed behind
# it; the next one passes it over: a driver that never returned would keep the board for ever.

import micropython
from utime import sleep_ms

micropython.opt_level(3)  # numbers of lines take room
sleep_ms(300)  # the prompt can be reached now, whatever a driver does later
micropython.kbd_intr(-1)  # who calls while it starts must not end that; the prompt undoes it
program = trial = ""
generation = a = b = file = data = line = 0


def add(data):
    global a, b
    for i in data:
        a += i
        b += a
    a %= 255
    b %= 255


try:
    file = open("krt")
    trial = "-" + file.read()
    file.close()
except Exception:  # nothing is on trial
    pass
for name in ("kr0", "kr1"):
    try:
        file = open(name, "rb")
        data = file.read(64)
        file.close()
        a = b = 0
        add(data[: data.rfind(b" ") + 1])
        line = str(data, "utf8").split()
        if trial != "-" + line[0] + "\n" and int(line[4], 16) == b << 8 | a and int(line[0]) > generation:
            a = b = 0
            file = open(line[2], "rb")
            while data:
                data = file.read(64)
                add(data)
            file.close()
            if int(line[3], 16) == b << 8 | a:
                generation = int(line[0])
                program = line[2]
    except Exception:  # there is none, or it is not whole
        pass
if trial and trial[-1] != "\n":
    try:
        file = open("krt", "w")
        file.write("%d\n" % generation)
        file.close()
    except Exception:  # the flash is full
        pass
del micropython, sleep_ms, add, a, b, name, data, file, line, trial
