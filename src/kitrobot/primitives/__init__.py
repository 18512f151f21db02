"""The words a robot understands: constructors and robots, read from XML."""
