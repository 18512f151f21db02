# Makes a micro:bit visible: inverts its display.


def identify(on):
    from microbit import display

    for number in range(25):
        at = number % 5, number // 5
        display.set_pixel(at[0], at[1], 9 - display.get_pixel(at[0], at[1]))
