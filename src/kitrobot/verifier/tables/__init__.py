"""The discrete world: its columns, places and bodies, and the arrays that exploration reads."""
