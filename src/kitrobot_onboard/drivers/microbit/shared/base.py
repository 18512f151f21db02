# The two motors of a micro:bit's kit, behind a chip on its I2C bus: what `drive`, `turn` and `wheel` want, summed up.

from microbit import i2c

wanted = [0, 0, 0, 0]  # percent: forward, counter-clockwise, the left and the right wheel by themselves
told = [None, None]


def move(kit):
    """Tells both motors what has changed. `kit`: whose chip it is."""
    for side in (0, 1):
        percent = wanted[0] + (wanted[1] if side else -wanted[1]) + wanted[2 + side]
        percent = max(-100, min(percent, 100))
        if told[side] == percent:
            continue
        told[side] = percent
        part = abs(percent)
        if kit == "maqueen":
            i2c.write(16, bytes((2 * side, percent < 0, part * 255 // 100)))
        elif kit == "cutebot":
            i2c.write(16, bytes((1 + side, 1 if percent < 0 else 2, part, 0)))
        else:
            first = 2 if side else 4
            ahead = (percent > 0) == (side == 1)
            i2c.write(98, bytes((first + (not ahead), 0)))
            i2c.write(98, bytes((first + ahead, part * 255 // 100)))


def halt(kit):
    """Stands still, whatever was told before."""
    told[0] = told[1] = None
    for at in range(4):
        wanted[at] = 0
    move(kit)


def begin(kit):
    """Wakes the chip up."""
    if kit == "move":
        for pair in (b"\0\0", b"\1\4", b"\x08\xaa"):
            i2c.write(98, pair)
    halt(kit)
