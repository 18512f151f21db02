"""Installs a program, and the package that it needs, so that an interruption is safe."""
