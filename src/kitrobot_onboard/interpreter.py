# The one interpreter. Every host runs this very function: a robot from MicroPython, the simulator from CPython, fleets
# and the verifier compiled by Numba. So it is written in the Python that all three accept: no classes, no calls, no
# allocation, no I/O; flat arrays of whole numbers; op numbers as literals.
#
# A program is a set of threads, one slot for the program and one for each branch, in reading order. A tick runs each
# live thread, in slot order, until it blocks or ends; then, when a branch ended, it settles the parallels, outer first.
#
#   code     4 numbers an instruction: op a b c. Operands are cells; a jump's target is b + 256 c, in instructions.
#   cells    0 the fault flag, then inputs, variables, loop counters, temporaries, constants
#   threads  2 a slot: the next instruction (-1: not running), and the ticks still to wait
#   pars     0 slots, 1 parallels, 2 stops, 3 numbers an actuator has in `out`; then
#            4 a slot:      its parallel (-1: none), first instruction, marked?, the slot after its last descendant
#            5 a parallel:  active?, first slot, the slot after its last descendant, branches, unmarked branches
#            3 a stop:      armed by (instruction + 1, or 0), slot, command
#            1 a command:   where its actuator stands in `out`
#   out      for each actuator: slot + 1 (0: no command), instruction, command, arguments; the last command wins
#   seen     1 for each instruction that ran in this tick; empty: nobody watches
#
# A host samples the inputs into cells before a tick and hands the commands in `out` to the devices after it. It runs
# only images that were verified, so no index can leave its array and no thread can fail to block.
#
# There is one way out, no `return` in the middle, and no `range` with a step, which could raise: only so does Numba see
# that it need not count references to the arrays, and that alone makes a short tick four times as fast.


def tick(code, cells, threads, pars, out, seen):
    slots = pars[0]
    width = pars[3]
    watched = len(seen) > 0
    ended = 0
    i = 0
    while i < len(out):
        out[i] = 0
        i += width
    for s in range(slots):
        pc = threads[2 * s]
        if pc < 0:
            continue
        if threads[2 * s + 1] > 1:
            threads[2 * s + 1] -= 1
            continue
        threads[2 * s + 1] = 0
        while True:
            if watched:
                seen[pc] = 1
            i = 4 * pc
            pc += 1
            op = code[i]
            a = code[i + 1]
            if op < 8:
                if op == 1:  # MOV a b
                    cells[a] = cells[code[i + 2]]
                elif op == 2:  # ADD a b c
                    cells[a] = cells[code[i + 2]] + cells[code[i + 3]]
                elif op == 3:  # SUB a b c
                    cells[a] = cells[code[i + 2]] - cells[code[i + 3]]
                elif op == 4:  # CLAMP a lo hi
                    if cells[a] < cells[code[i + 2]]:
                        cells[a] = cells[code[i + 2]]
                        cells[0] = 1
                    elif cells[a] > cells[code[i + 3]]:
                        cells[a] = cells[code[i + 3]]
                        cells[0] = 1
                elif op == 5:  # EQ a b c
                    cells[a] = 1 if cells[code[i + 2]] == cells[code[i + 3]] else 0
                elif op == 6:  # LT a b c
                    cells[a] = 1 if cells[code[i + 2]] < cells[code[i + 3]] else 0
                else:  # 7 NOT a b
                    cells[a] = 0 if cells[code[i + 2]] else 1
            elif op < 12:
                if op == 9:  # JZ a t
                    if cells[a] == 0:
                        pc = code[i + 2] + 256 * code[i + 3]
                elif op == 10:  # JNZ a t
                    if cells[a] != 0:
                        pc = code[i + 2] + 256 * code[i + 3]
                else:
                    pc = code[i + 2] + 256 * code[i + 3]
                    if op == 11:  # LOOP t (8 is JMP t)
                        break
            elif op == 15:  # ACT command first count
                o = pars[4 + 4 * slots + 5 * pars[1] + 3 * pars[2] + a]
                out[o] = s + 1
                out[o + 1] = pc - 1
                out[o + 2] = a
                b = code[i + 2]
                k = code[i + 3]
                while k > 0:
                    k -= 1
                    out[o + 3 + k] = cells[b + k]
            elif op == 16:  # ARM stop
                pars[4 + 4 * slots + 5 * pars[1] + 3 * a] = pc
            elif op == 12:  # YIELD
                break
            elif op == 13:  # WAIT a
                threads[2 * s + 1] = cells[a]
                break
            elif op == 17:  # FORK p
                p = 4 + 4 * slots + 5 * a
                pars[p] = 1
                for b in range(pars[p + 1], pars[p + 2]):
                    if pars[4 + 4 * b] == a:
                        threads[2 * b] = pars[4 + 4 * b + 1]
                        threads[2 * b + 1] = 0
                break
            elif op == 18:  # JOIN p
                if pars[4 + 4 * slots + 5 * a]:
                    pc -= 1
                    break
            else:  # 14 END
                pc = -1
                ended = 1
                break
        threads[2 * s] = pc
    for n in range(pars[1]):
        if ended == 0:
            break
        p = 4 + 4 * slots + 5 * n
        if pars[p] == 0:
            continue
        first = pars[p + 1]
        last = pars[p + 2]
        live = 0
        unmarked = 0
        for b in range(first, last):
            if pars[4 + 4 * b] == n and threads[2 * b] >= 0:
                live += 1
                if pars[4 + 4 * b + 2] == 0:
                    unmarked += 1
        if pars[p + 4] > 0:
            if unmarked > 0:
                continue
        elif live > 1 or (live == 1 and pars[p + 3] == 1):
            continue
        # It is over: whatever still runs inside is abandoned, and what was marked and started is stopped.
        for b in range(first, last):
            threads[2 * b] = -1
            threads[2 * b + 1] = 0
        for k in range(n, pars[1]):
            q = 4 + 4 * slots + 5 * k
            if pars[q + 1] >= first and pars[q + 1] < last:
                pars[q] = 0
        for k in range(pars[2]):
            q = 4 + 4 * slots + 5 * pars[1] + 3 * k
            b = pars[q + 1]
            if pars[q] and b >= first and b < last:
                o = pars[4 + 4 * slots + 5 * pars[1] + 3 * pars[2] + pars[q + 2]]
                if out[o] == 0 or out[o] == b + 1:
                    out[o] = b + 1
                    out[o + 1] = pars[q] - 1
                    out[o + 2] = pars[q + 2]
                pars[q] = 0
