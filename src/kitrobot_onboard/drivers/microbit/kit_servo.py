# A door that a servo at a connector of a kit moves: S1 or S2 of a Maqueen (DFRobot) or a Cutebot (ELECFREAKS).

from microbit import i2c, running_time

SETTINGS = {
    "kit": "maqueen|cutebot",
    "number": "1..2 = 1",
    "open": "0..180 = 90",
    "closed": "0..180 = 0",
    "time": "1..60000 = 1000",
}
PROCEDURES = "Open Close"


class Door:
    def __init__(self, settings):
        number = int(settings.get("number", "1"))
        self.head = bytes((19 + number,))
        self.tail = b""
        if settings["kit"] == "cutebot":
            self.head = bytes((4 + number,))
            self.tail = b"\0\0"
        self.open = int(settings.get("open", "90"))
        self.closed = int(settings.get("closed", "0"))
        self.needed = int(settings.get("time", "1000"))
        self.until = 0

    def do(self, procedure, arguments):
        angle = self.open if procedure == "Open" else self.closed
        i2c.write(16, self.head + bytes((angle,)) + self.tail)
        self.until = running_time() + self.needed

    def done(self):
        return running_time() >= self.until

    def stop(self):
        self.until = 0


make = Door
