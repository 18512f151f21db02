"""A team's program: roles, points and sets, and its projection onto each kind of robot."""
