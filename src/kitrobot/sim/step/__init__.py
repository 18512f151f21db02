"""One step of a run: programs, devices, physics, faults and substitution in their order."""
