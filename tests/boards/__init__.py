"""Boards that tests talk to: the board's own loop on CPython, and the micro:bit's real firmware in QEMU."""
