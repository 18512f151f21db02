# What a board is to start, for main.py: the newer whole line of `kr0` and `kr1`, as the list `x`: generation, module,
# program, sum. A file of its own, because what a module does when it is imported takes no room afterwards. It never
# changes, and neither does main.py.

x = [0]
for name in ("kr0", "kr1"):
    try:
        file = open(name, "rb")
        line = file.read(64)
        file.close()
        a = b = 0
        for i in line[: line.rfind(b" ") + 1]:
            a += i
            b += a
        line = str(line, "utf8").split()
        line[0] = int(line[0])
        if int(line[3], 16) == b % 255 << 8 | a % 255 and line[0] > x[0]:
            x = line
    except Exception:  # there is none, or it is not whole
        pass
