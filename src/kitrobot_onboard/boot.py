# main.py on a board, which never changes: it starts what `krboot` found in `kr0` and `kr1`. An update writes one of
# these lines last, so a cut at any moment leaves the other whole. When something fails, Python says so, and the prompt
# is free.
#
# It is done here, and not in functions, because all of this stays in memory as long as the robot runs, and because the
# smallest board's stack holds few calls in one another. What stays of the package shares one space: modules of their
# own would take 200 bytes more each. What only starts has another, which is emptied before the next comes (emptied,
# because Python may still hold it): "+" is before a file for that, and "-" runs its `ready` and empties it. The file of
# these words has 18 characters for each: mark, name, size.

import krboot
import micropython

micropython.opt_level(3)  # numbers of lines take room
if krboot.x[0]:
    port = __import__(krboot.x[1])
    a = {}
    b = {}
    line = []
    names = open(port.FILES)
    while True:
        name = names.read(18)
        if not name:
            break
        if name[0] == "-":
            b["ready"](port, krboot.x, line)
            b.clear()
        else:
            file = open(name[1:14])
            exec(file.read(int(name[14:])), b if name[0] == "+" else a)
        min(0, 0, 0, 0)  # takes the place of what Python last called, and thereby holds
    a["run"](port, line)
