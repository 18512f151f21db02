"""Firmware: what a program requires of it, chips, ports and `.uf2` files."""
