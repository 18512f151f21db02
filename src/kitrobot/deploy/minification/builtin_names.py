"""Names that are built into the firmware: they cost a small board no memory.

MicroPython keeps each name that a program uses, once, in memory: about ten bytes. Those that its own modules use are in
its flash already. So variables on a board are given such names, whatever these mean elsewhere: here are the short ones
of the micro:bit of 2016 that are neither words of Python nor names a program could miss when they are covered.
"""

_LOCALS = (
    "a b c d e f g n r bl bx on pi rx tx up a2 a4 b3 b4 b5 c3 c4 c5 d3 d4 d5 e4 e5 f2 g4 g5 NO add asr bpm buf "
    "clz cmp cos end exp get i2c key ldr log lsl lsr mem mov mrs nop off pin pop say scl sda sep sin spi sub tan "
    "wfi"
)
LOCALS = tuple(_LOCALS.split())
"""For variables inside functions, the shortest first."""

LETTERS = tuple("abcdefgnr")
"""For what several functions know and use most; a function that uses one has no variable of its own called so."""

_GLOBALS = (
    "COW MEH ODD ODE SAD YES DUCK EVEN FUNK NYAN XMAS acos addr asin atan bits blit ceil crop down fabs fill fmod "
    "freq ldrb ldrh left loop love miso mode modf mosi movt movw mouth pins push rbit scan sclk sdiv seed sing "
    "step strb strh this udiv uint ANGRY BADDY BLUES CHASE GHOST HAPPY HEART HOUSE SILLY SKULL SMILE SNAKE SWORD "
    "align atan2 audio cpsid cpsie debug delay floor frexp group ldexp ldrex label movwt panic pitch power queue "
    "radio shake speed strex throat touch trunc ASLEEP CLOCK1 CLOCK2 CLOCK3 CLOCK4 CLOCK5 CLOCK6 CLOCK7 CLOCK8 "
    "CLOCK9 PACMAN PYTHON RABBIT SQUARE TARGET TSHIRT button choice config enable height invert length little "
    "module parity repeat scroll source speech stride"
)
GLOBALS = tuple(_GLOBALS.split())
"""For functions and what else several functions know."""
