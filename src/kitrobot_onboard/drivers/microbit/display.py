# The 5 x 5 lights: a picture by its number, a digit, one light, nothing.

from microbit import Image, display

NAMES = "HEART,HEART_SMALL,HAPPY,SMILE,SAD,CONFUSED,ANGRY,ASLEEP,SURPRISED,SILLY,YES,NO"


class Display:
    def do(self, procedure, arguments):
        if procedure == "Image":
            display.show(getattr(Image, NAMES.split(",")[arguments[0]]))
        elif procedure == "Number":
            display.show(str(arguments[0]), wait=False)
        elif procedure == "Pixel":
            display.set_pixel(arguments[0], arguments[1], arguments[2])
        else:
            display.clear()

    def stop(self):
        display.clear()


def make(settings):
    return Display()
