"""The micro:bit of 2016: the loop that runs from its flash, and room for it there."""
