"""Smaller sources for small boards: short names, constants as numbers, without what no program uses."""
