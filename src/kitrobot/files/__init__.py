"""Files of every kind on disk: found, read, written whole, locked, recovered; missions inside pictures."""
