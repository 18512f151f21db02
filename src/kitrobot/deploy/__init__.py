"""Real robots: the line to a board, what is put onto it, and the link to the robot that runs there."""
