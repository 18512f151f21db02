# Shows itself; the loop asks again, with a word, to end that. On a micro:bit, what is dark becomes bright and back.

from kitrobot_onboard.state import SHOWN


def answer(port, robot, data):
    shown = not data
    if shown != bool(robot[SHOWN]):
        robot[SHOWN] = shown
        if hasattr(port, "identify"):
            port.identify(shown)
        else:
            from microbit import display

            for i in range(25):
                display.set_pixel(i % 5, i // 5, 9 - display.get_pixel(i % 5, i // 5))
    return 0
