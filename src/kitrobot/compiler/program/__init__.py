"""One program: its names checked, its tree lowered to three-address code."""
