"""Diagnostics: how KitRobot reports mistakes."""
