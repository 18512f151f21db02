"""A program as a graph, and its part of the `.krt` file."""
