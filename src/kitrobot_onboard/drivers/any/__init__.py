"""Drivers for any board."""
