"""Facts about reading constructors and robots."""
