"""Drivers of devices, by family of boards; `any` for those that need none of a family's modules."""
