"""A `.krt` file as a whole: programs, team and world together."""
