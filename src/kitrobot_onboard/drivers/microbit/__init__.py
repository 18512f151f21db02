"""Drivers for the micro:bit of 2016."""
