# Chooses what a board starts, for main.py: `program` is the program file of the newer intact line of `kr0` and `kr1`
# whose program file is intact too, or "". The words of a line: generation, module of the interpreter, program, sum of
# the program, sum of the line. It is the same in all versions, as main.py is.

import micropython

micropython.opt_level(3)  # numbers of lines take room
micropython.kbd_intr(-1)  # who calls while it starts must not end that; the prompt undoes it
program = ""
generation = a = b = file = data = line = 0


def add(data):
    global a, b
    for i in data:
        a += i
        b += a
    a %= 255
    b %= 255


for name in ("kr0", "kr1"):
    try:
        file = open(name, "rb")
        data = file.read(64)
        file.close()
        a = b = 0
        add(data[: data.rfind(b" ") + 1])
        line = str(data, "utf8").split()
        if int(line[4], 16) == b << 8 | a and int(line[0]) > generation:
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
del micropython, add, a, b, name, data, file, line
