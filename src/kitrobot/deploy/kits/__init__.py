"""Kits: which of a robot's parts a kit has, on which pins, and in which program they are tried."""
