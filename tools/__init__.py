"""Small programs for working on the project; nothing of this is shipped but what the build needs."""
