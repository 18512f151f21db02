"""Drivers for boards whose MicroPython has the module `machine`."""
