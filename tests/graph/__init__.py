"""Facts about programs as graphs."""
