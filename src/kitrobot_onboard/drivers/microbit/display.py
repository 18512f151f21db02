# The 5 x 5 lights: a picture by its number, a digit, a number that runs through, one light, nothing.

from microbit import Image, display, running_time

SETTINGS = {"delay": "20..2000 = 150"}
PROCEDURES = "Image Number Scroll Pixel Clear"

# In the order of docs/xml.md; one text, because a list of them would take three times the room.
NAMES = (
    "HEART,HEART_SMALL,HAPPY,SAD,CONFUSED,ANGRY,ASLEEP,SURPRISED,YES,NO,ARROW_N,ARROW_E,ARROW_S,ARROW_W,DIAMOND,"
    "DIAMOND_SMALL,SQUARE,SQUARE_SMALL,TARGET,CHESSBOARD,"
)


class Display:
    def __init__(self, settings):
        self.delay = int(settings.get("delay", 150))
        self.until = 0

    def do(self, procedure, arguments):
        self.until = 0
        if procedure == "Pixel":
            display.set_pixel(arguments[0], arguments[1], arguments[2])
        elif procedure == "Scroll":
            text = str(arguments[0])
            display.scroll(text, delay=self.delay, wait=False)
            self.until = running_time() + (5 + 6 * len(text)) * self.delay
        elif procedure == "Number":
            display.show(str(min(max(arguments[0], 0), 9)), wait=False)
        elif procedure == "Image":
            at = 0
            for _ in range(min(arguments[0], 19)):
                at = NAMES.find(",", at) + 1
            display.show(getattr(Image, NAMES[at : NAMES.find(",", at)]))
        else:
            self.stop()

    def done(self):
        return running_time() >= self.until

    def stop(self):
        display.show(Image())


def make(settings):
    return Display(settings)
